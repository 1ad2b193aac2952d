#pragma once

#include <span>

#include "ribbon/geometry/tangent.h"
#include "ribbon/system/island_state.h"
#include "ribbon/system/wheel_points.h"

// Where the wheels of an island are, and the straight parts of their cords, at positions by slot.

namespace ribbon {

/// The straight part before or behind a wheel.
struct WheelSide {
  TangentLine line;
  double elongation;  ///< m
};

/// The two sides of a wheel.
struct WheelSides {
  WheelSide before;
  WheelSide after;
};

/// Returns the vector from the centre of mass of the body that carries a wheel to its axle, m.
Vec2 arm_of(const IslandState& state, const Wheel& wheel, std::span<const Vec2> x);
/// Returns the straight parts before and behind a wheel.
WheelSides sides_of(const IslandState& state, const Wheel& wheel, std::span<const Vec2> x);
/// Returns the path of the cord around a wheel where the island is, with the lengths at rest that `pulley` has.
WheelPath path_of(const IslandState& state, const Wheel& wheel, const Pulley& pulley);
/// Returns the pulley of a wheel.
Pulley& pulley_of(const IslandState& state, const Wheel& wheel);

}  // namespace ribbon
