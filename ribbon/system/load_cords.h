#pragma once

#include <span>

#include "ribbon/island_cord.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// Reads the cords at the start of an island's step: points, tensions, targets, reels, ties and grips, but not the
/// circles and edges near them.
void load_cords(IslandState& state, std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                ApartTies apart);
/// Reads the bodies that hold or may touch the cords, after all of them were added and the state was resized.
void load_bodies(IslandState& state);
/// Returns rest lengths to what they were when the step began.
void reset_rest_lengths(const IslandState& state);

}  // namespace ribbon
