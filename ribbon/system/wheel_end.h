#pragma once

#include "ribbon/system/island_state.h"

// The end of a step at the wheels: whether the cord slips in the groove, what the motor gives, and how far the cord
// ran.

namespace ribbon {

/// Returns whether each cord sticks or slips, and each motor holds its speed or not, as assumed in the step. Otherwise
/// it corrects the assumptions of its pulley, and the step is to be redone.
bool settle_wheels(const IslandState& state);
/// Writes the end of the step to the pulleys of a member, and places its points on them.
void store_wheels(const IslandState& state, const Member& member);

}  // namespace ribbon
