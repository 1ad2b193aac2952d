#pragma once

#include <span>

#include "ribbon/island_cord.h"
#include "ribbon/system/island_state.h"

// The start and the end of an island's step: its state is read from the cords and bodies, and written back to them.

namespace ribbon {

/// Reads the cords: their points, tensions, targets, reels and grips. The environment is read by what looks for
/// contacts.
void load_cords(IslandState& state, std::span<const IslandCord> cords);
/// Reads the bodies that hold or may touch the cords, after all of them were added. `resize` has been called.
void load_bodies(IslandState& state);
/// Returns reels to where the step began.
void reset_reels(const IslandState& state);

/// Writes the cords back.
void store_cords(IslandState& state);
/// Writes the displacements and impulses of the bodies.
void store_bodies(const IslandState& state);

}  // namespace ribbon
