#pragma once

#include <span>

#include "ribbon/system/island_state.h"

namespace ribbon {

/// Strain of a link of an inextensible cord, above which it counts as stretched.
inline constexpr double max_strain = 5e-3;

/// Returns the largest strain of a link of an inextensible cord at `x`; 0 if there is none.
double largest_strain(const IslandState& state, std::span<const Vec2> x);
/// Returns whether an inextensible cord has become stretched in the substep.
bool became_stretched(const IslandState& state);
/// Returns whether an inextensible cord is stretched. Where something moves further in a step than a cord is long, the
/// answer is no: what it stretches stops it.
bool is_stretched(const IslandState& state);
/// Returns the highest speed at the start of the substep, m/s, of cords, bodies and what is driven.
double highest_start_speed(const IslandState& state);

}  // namespace ribbon
