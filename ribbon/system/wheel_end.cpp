#include "ribbon/system/wheel_end.h"

#include <algorithm>
#include <cmath>

#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/wheel_sides.h"

namespace ribbon {
namespace {

constexpr double least_part = 0.1;      // of a link, that is left before or behind a wheel
constexpr double overrun_margin = 1.2;  // of how far a cord ran that ran too far
constexpr int max_motor_changes =
    2;  // in a step, after which a wheel that its motor or brake cannot hold turns both ways
constexpr double least_inertia = 1e-9;  // kg·m², of a wheel that turns on its own

double limit_of_friction(const Pulley& pulley, double before, double after) {
  const double ratio = exponential(pulley.def.friction * std::max(0.0, pulley.arc));
  return (ratio - 1.0) * std::max(0.0, std::min(before, after));
}

/// A wheel can slip under its cord unless it turns at will.
bool may_slip(const PulleyDef& def) {
  return std::isfinite(def.friction) && (def.inertia > 0.0 || def.motor_torque > 0.0);
}

/// The end of a step at a wheel.
struct WheelEnd {
  double speed;       // m/s, of the cord
  double friction;    // N, on the cord along it: what its inertia, its weight and its tensions leave
  double turning;     // rad/s, of the wheel
  double motor_sign;  // of a motor that gives its largest torque while the cord slips
};

/// The friction on a blocked cord that sticks, N. What blocks the cord takes the difference of its tensions, so that
/// only the wheel tells: with its turning ω, its motor's torque τ, and its sense s,
///
///     I·(ω⁺ − ω)/dt = τ − s·R·f.
///
/// The motor is kept from its speed and gives its largest torque; one that brakes gives what stops the wheel.
double friction_of_blocked(const Wheel& wheel, const Pulley& pulley, double turning, double dt) {
  const PulleyDef& def = pulley.def;
  const double change = def.inertia * (turning - pulley.turning) / dt;
  const double torque = def.motor_speed == turning ? std::clamp(change, -def.motor_torque, def.motor_torque)
                                                   : std::copysign(def.motor_torque, def.motor_speed - turning);
  return wheel.sense * (torque - change) / wheel.radius;
}

/// While the cord slips, the friction is at its limit, and the wheel turns on its own under the friction and the motor.
WheelEnd end_of(const IslandState& state, std::size_t k) {
  const Wheel& wheel = state.wheels[k];
  const Pulley& pulley = pulley_of(state, wheel);
  const std::size_t tension = state.wheel_tension(k);
  WheelEnd end{};
  end.speed = state.velocities[state.groove(k)].x;
  end.friction = wheel.cord_mass * (end.speed - pulley.speed) / state.dt + state.tensions[tension] -
                 state.tensions[tension + 1] - wheel.weight;
  end.turning = wheel.sense * end.speed / wheel.radius;
  if (wheel.slip_sign == 0.0) {
    if (wheel.blocked) end.friction = friction_of_blocked(wheel, pulley, end.turning, state.dt);
    return end;
  }
  end.friction = wheel.slip_sign * limit_of_friction(pulley, state.tensions[tension], state.tensions[tension + 1]);
  const double inertia = std::max(pulley.def.inertia, least_inertia);
  const double free = pulley.turning - state.dt * wheel.sense * wheel.radius * end.friction / inertia;
  const double change = state.dt * pulley.def.motor_torque / inertia;
  end.turning = pulley.def.motor_torque > 0.0 ? std::clamp(pulley.def.motor_speed, free - change, free + change) : free;
  end.motor_sign =
      end.turning == pulley.def.motor_speed || change == 0.0 ? 0.0 : std::copysign(1.0, end.turning - free);
  return end;
}

/// Returns whether the cord sticks or slips as it was assumed to, and corrects the assumption otherwise.
bool settle_friction(const IslandState& state, std::size_t k, const WheelEnd& end, Pulley& pulley) {
  const Wheel& wheel = state.wheels[k];
  if (!may_slip(pulley.def)) return true;
  if (wheel.slip_sign != 0.0) {
    const double relative = end.speed - wheel.sense * wheel.radius * end.turning;
    if (wheel.slip_sign * relative <= 0.0) return true;
    pulley.slip_sign = 0.0;
    pulley.motor_sign = end.motor_sign;
    return false;
  }
  const std::size_t tension = state.wheel_tension(k);
  const double limit = limit_of_friction(pulley, state.tensions[tension], state.tensions[tension + 1]);
  if (std::abs(end.friction) <= limit) return true;
  pulley.slip_sign = std::copysign(1.0, end.friction);
  return false;
}

/// Returns whether the motor holds its speed, or gives its largest torque, as it was assumed to.
bool settle_motor(const IslandState& state, const Wheel& wheel, const WheelEnd& end, Pulley& pulley,
                  WheelReach& reach) {
  const PulleyDef& def = pulley.def;
  if (wheel.slip_sign != 0.0 || def.motor_torque == 0.0) return true;
  if (pulley.motor_sign != 0.0) {
    const bool both_ways = reach.motor_changes >= max_motor_changes;
    if (both_ways || pulley.motor_sign * (def.motor_speed - end.turning) >= 0.0) return true;
    pulley.motor_sign = 0.0;
    ++reach.motor_changes;
    return false;
  }
  const double torque =
      wheel.sense * wheel.radius * end.friction + def.inertia * (end.turning - pulley.turning) / state.dt;
  if (std::abs(torque) <= def.motor_torque) return true;
  pulley.motor_sign = std::copysign(1.0, torque);
  ++reach.motor_changes;
  return false;
}

/// Returns whether the points that the wheel has taken up are enough for how far the cord ran, and tells how many more
/// it needs otherwise.
bool settle_reach(const IslandState& state, std::size_t k, WheelReach& reach) {
  const Wheel& wheel = state.wheels[k];
  const Member& member = state.members[wheel.member];
  const auto rest = [&](std::size_t slot) { return member.cord->state.rest[slot - member.first_point]; };
  const double run = state.positions[state.groove(k)].x;
  if (wheel.lead - run < least_part * rest(wheel.before)) {
    reach.before = std::max(reach.before, overrun_margin * run);
    return false;
  }
  if (wheel.trail + run < least_part * rest(wheel.after - 1)) {
    reach.after = std::max(reach.after, -overrun_margin * run);
    return false;
  }
  return true;
}

}  // namespace

bool settle_wheels(const IslandState& state) {
  bool settled = true;
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    Pulley& pulley = pulley_of(state, wheel);
    const WheelEnd end = end_of(state, k);
    WheelReach& reach = state.members[wheel.member].cord->reaches[wheel.pulley];
    settled = settle_reach(state, k, reach) && settle_friction(state, k, end, pulley) &&
              settle_motor(state, wheel, end, pulley, reach) && settled;
  }
  return settled;
}

void store_wheels(const IslandState& state, const Member& member) {
  CordParts& cord = *member.cord;
  for (std::size_t k = member.first_wheel; k < member.end_wheel; ++k) {
    const Wheel& wheel = state.wheels[k];
    Pulley& pulley = cord.state.pulleys[wheel.pulley];
    const std::size_t groove = state.groove(k);
    const double run = state.positions[groove].x;
    pulley.lead = wheel.lead - run;
    WheelEnd end = end_of(state, k);
    const double rim = wheel.sense * end.speed / wheel.radius;  // the friction takes the wheel no further than that
    if ((pulley.turning - rim) * (end.turning - rim) < 0.0) end.turning = rim;
    pulley.angle +=
        wheel.slip_sign == 0.0 ? wheel.sense * run / wheel.radius : 0.5 * state.dt * (pulley.turning + end.turning);
    pulley.turning = end.turning;
    pulley.speed = end.speed;
    pulley.acceleration = state.accelerations[groove].x;
    pulley.tension_before = state.tensions[state.wheel_tension(k)];
    pulley.tension_after = state.tensions[state.wheel_tension(k) + 1];

    const WheelPath path = path_of(state, wheel, pulley);
    const Vec2 arm = arm_of(state, wheel, state.positions);
    const Vec2 carried = state.velocities[state.center(wheel.solved_index)] +
                         state.velocities[state.angle(wheel.solved_index)].x * perp(arm);
    double distance = 0.0;
    const int links = pulley.def.after - pulley.def.before;
    for (int p = pulley.def.before; p < pulley.def.after; ++p) {
      const double share = links > 1 ? static_cast<double>(p - pulley.def.before) / (links - 1) : 0.0;
      cord.state.tensions[at(p)] = (1.0 - share) * pulley.tension_before + share * pulley.tension_after;
      if (p == pulley.def.before) continue;
      distance += cord.state.rest[at(p - 1)];
      const PathPlace place = place_on_path(path, distance);
      cord.state.positions[at(p)] = place.position;
      cord.state.velocities[at(p)] = carried + pulley.speed * place.along;
      cord.state.accelerations[at(p)] = pulley.acceleration * place.along;
    }
  }
}

}  // namespace ribbon
