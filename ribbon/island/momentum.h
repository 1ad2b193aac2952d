#pragma once

#include "ribbon/contact/contacts.h"
#include "ribbon/system/island_state.h"

// Momentum of an island as a whole, and changes of velocity that conserve it.

namespace ribbon {

/// Takes so much energy [J] out of the velocities, or as much as there is. The motion of a free island as a rigid body
/// stays.
void slow_down(IslandState& state, double excess);
/// Restores the momentum of a free island after an impact, as a rigid motion of all of it. Implicit Euler takes some of
/// the angular momentum, and large forces cost the linear one digits. Returns whether it changed the velocities.
bool restore_momentum(IslandState& state, const Contacts& contacts);
/// Reduces the speed of all that is faster than anything was at the start of the substep and can have fallen since.
/// Returns whether something was.
bool limit_speeds(IslandState& state);
/// Returns whether a drive has stretched an inextensible cord further and thrown a part of it, which is now faster than
/// limit_speeds would leave it.
bool is_thrown(const IslandState& state);

}  // namespace ribbon
