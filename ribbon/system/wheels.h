#pragma once

#include <array>
#include <span>

#include "ribbon/system/island_state.h"

// The wheels of pulleys, IslandState::wheels: a cord runs around each in a groove, without contacts. Its points on the
// wheel, and the wheel if the cord does not slip, are one unknown: ρ [m], by which the cord has run through the groove
// in the step. The straight part before the wheel is a link from the point there to where the cord touches the wheel.
// If that place is s away, and m is the length at rest between the two at the start of the step, its elongation is
//
//     c = s − (m − ρ),
//
// and that of the part behind the wheel s − (m + ρ). The place does not move round the wheel in the step: it is where
// the line to the point will be tangent at its end. On the wheel the cord is not stretched, so what runs onto it gives
// its elastic energy ½·λ²/EA a metre to the groove. If it is wrong by an angle δ, the length is by R·δ³/8 or so.

namespace ribbon {

/// Adds the wheels of a member. Its points on them are driven.
void add_wheels(IslandState& state, Member& member);
/// Reads the motion of the wheels, after that of the bodies.
void load_wheels(IslandState& state);
/// Adds the forces on the points of a wheel along the cord to that on its groove. `force` is by slot, N.
void load_wheel_forces(IslandState& state, std::span<Vec2> force);

/// Returns the slots that a wheel couples: the points before and behind it, its groove, and its body's centre and
/// angle.
std::array<int, 5> wheel_slots(const IslandState& state, const Wheel& wheel);
/// Adds the wheels to the coupled system. The tensions before and behind a wheel are one slot of unknowns.
void load_wheel_rows(const IslandState& state, const Stage& stage, BlockLdlt& blocks, std::span<Vec2> right_side);
/// Writes the tensions of a solution to `next`.
void update_wheels(const IslandState& state, std::span<const Vec2> solution, std::span<double> next);
/// Returns the part of the wheels in what a stage minimises, J. `max_tensions` are the slopes of the exact penalty.
double wheel_potential(const IslandState& state, std::span<const double> max_tensions, std::span<const Vec2> x);

/// Returns the elastic energy of the parts before and behind the wheels, J.
double wheel_energy(const IslandState& state);
/// Returns the potential energy of the cord in the grooves and of the loads of the axles, J, less that of its points:
/// these are driven in the step, while their masses are in the grooves and the bodies.
double wheel_load_energy(const IslandState& state);

/// Returns the largest work, J, that the motors can have done in the substep: twice the force along the cord times how
/// far it ran.
double wheel_work(const IslandState& state);

}  // namespace ribbon
