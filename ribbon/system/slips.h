#pragma once

#include "ribbon/system/island_state.h"

// Where grips that slip are on their cords: before, between and after the substeps.

namespace ribbon {

/// Before the first substep, of `dt` [s]: holds each grip that will slide past a bend in it where it will be at its
/// end. It then follows the cord instead of the line of its link.
void aim_slips(IslandState& state, double dt);
/// Between substeps: moves the places of grips to where they have slipped to, so that they follow the bends of their
/// cords, and aims them again for the next `dt` [s]. Returns whether one moved; the linear system then has another
/// pattern.
bool follow_slips(IslandState& state, double dt);
/// Writes to each grip how far it has slipped in the step.
void find_slips(IslandState& state);

}  // namespace ribbon
