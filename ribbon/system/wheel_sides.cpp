#include "ribbon/system/wheel_sides.h"

#include "ribbon/geometry/rotation.h"

namespace ribbon {
namespace {

Vec2 center_of(const IslandState& state, const Wheel& wheel, std::span<const Vec2> x) {
  return x[state.center(wheel.solved_index)] + arm_of(state, wheel, x);
}

}  // namespace

Vec2 arm_of(const IslandState& state, const Wheel& wheel, std::span<const Vec2> x) {
  return times(rotation(x[state.angle(wheel.solved_index)].x), wheel.arm);
}

WheelSides sides_of(const IslandState& state, const Wheel& wheel, std::span<const Vec2> x) {
  const Vec2 center = center_of(state, wheel, x);
  const double run = x[state.groove_of(wheel)].x;
  const TangentLine in = line_to_groove(x[wheel.before] - center, wheel.radius, wheel.arrival);
  const TangentLine out = line_from_groove(x[wheel.after] - center, wheel.radius, wheel.departure);
  return {{in, in.length - (wheel.lead - run)}, {out, out.length - (wheel.trail + run)}};
}

WheelPath path_of(const IslandState& state, const Wheel& wheel, const Pulley& pulley) {
  const WheelSides sides = sides_of(state, wheel, state.positions);
  const Vec2 center = center_of(state, wheel, state.positions);
  return {center,           wheel.radius, wheel.sense, sides.before.line,
          sides.after.line, pulley.lead,  pulley.arc,  trail_of(*state.members[wheel.member].cord, pulley)};
}

Pulley& pulley_of(const IslandState& state, const Wheel& wheel) {
  return state.members[wheel.member].cord->state.pulleys[wheel.pulley];
}

}  // namespace ribbon
