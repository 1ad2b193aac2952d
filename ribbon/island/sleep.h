#pragma once

#include <span>

#include "ribbon/island_cord.h"
#include "ribbon/system/island_state.h"

// Cords at rest among what is at rest are not stepped: CordDef::allow_sleep.

namespace ribbon {

/// Lets the cords of an island sleep in this step if all of them have rested for long enough and their surroundings are
/// still at rest. Otherwise it wakes them all. Returns whether they sleep.
bool try_sleep(std::span<const IslandCord> cords, std::span<RigidBody> bodies, Vec2 gravity);
/// After a step: updates how long each cord has rested.
void count_rest_time(const IslandState& state, const IslandReport& report);

}  // namespace ribbon
