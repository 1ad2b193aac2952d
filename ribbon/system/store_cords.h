#pragma once

#include "ribbon/system/island_state.h"

namespace ribbon {

/// Writes the cords back at the end of an island's step.
void store_cords(IslandState& state);
/// Writes the displacements and impulses of the bodies.
void store_bodies(const IslandState& state);

}  // namespace ribbon
