#pragma once

#include <optional>

#include "ribbon/cord.h"
#include "ribbon/vec2.h"

// Forces on a cord, from its state.

namespace ribbon {

/// Returns the force [N] that keeps a constrained or operated point on its path, under `gravity` [m/s²]: the reaction
/// of the pin on the cord, at the end of the last step. It does not include contacts of the links at the point, nor
/// damping after set_velocity and while inverted cells are turned back. It is 0 for a free point. Throws
/// DefinitionError for an unknown point. O(points).
Vec2 reaction(const Cord& cord, int point, Vec2 gravity);
/// Returns the force [N] that would hold any point, free or not, against the other forces on it, among them its weight
/// under gravity_scale times `gravity`. For a point that a static or kinematic body holds it is the force of the body.
/// Throws DefinitionError for an unknown point.
Vec2 holding_force(const Cord& cord, int point, Vec2 gravity);
/// Returns the link whose tension exceeds its breaking force by the largest factor, the first of equal ones; nothing if
/// none does. O(1) if no link can break, otherwise O(points).
std::optional<int> overloaded_link(const Cord& cord);

}  // namespace ribbon
