#pragma once

#include <span>

#include "ribbon/system/island_state.h"

namespace ribbon {

/// Strain of a link of an inextensible cord, above which it counts as stretched.
inline constexpr double max_strain = 5e-3;

/// Returns the largest strain of a cord's links at `x`, as below; 0 unless it is inextensible.
double largest_strain(const Member& member, std::span<const Vec2> x);
/// Returns the largest strain, also by compression unless `tension_only`, of an inextensible cord's links at `x`; or 0.
double largest_strain(const IslandState& state, std::span<const Vec2> x);
/// Returns whether an inextensible cord has become stretched in the substep by more than this strain.
bool became_stretched(const IslandState& state, double strain = max_strain);
/// Returns whether a cord is inextensible and stretched, and more than at the start of the substep.
bool is_stretched(const IslandState& state, const Member& member);
/// Returns whether a cord is, other than one that is shorter than something moves in the step. (If the motion of a cord
/// that a fast ball hits were taken back, the ball would go through.)
bool is_stretched(const IslandState& state);
/// Returns whether an inextensible cord of an island with ties is stretched, and more than at the start of the step.
bool is_stretched_by_step(const IslandState& state);
/// Returns the highest speed at the start of the substep, m/s, of cords, bodies and what is driven.
double highest_start_speed(const IslandState& state);

}  // namespace ribbon
