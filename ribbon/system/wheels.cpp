#include "ribbon/system/wheels.h"

#include <algorithm>
#include <cmath>

#include "ribbon/elastic/link.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/wheel_points.h"
#include "ribbon/system/wheel_sides.h"

namespace ribbon {
namespace {

constexpr double least_jolt = 1e-6;  // m/s
constexpr double min_mass = 1e-3;    // of a cord in a groove, as a share of a point's

double compliance_of(const CordDef& def, double rest) { return std::max(0.0, rest) / def.stretch_stiffness; }

const CordDef& def_of(const IslandState& state, const Wheel& wheel) { return state.members[wheel.member].cord->def; }

}  // namespace

void add_wheels(IslandState& state, Member& member) {
  member.first_wheel = state.wheels.size();
  const CordParts& cord = *member.cord;
  for (std::size_t k = 0; k < cord.state.pulleys.size(); ++k) {
    const Pulley& pulley = cord.state.pulleys[k];
    const Axle& axle = member.surroundings.axles[k];
    Wheel wheel;
    wheel.member = static_cast<std::size_t>(&member - state.members.data());
    wheel.pulley = k;
    wheel.before = member.first_point + at(pulley.def.before);
    wheel.after = member.first_point + at(pulley.def.after);
    wheel.solved_index = state.solved_body(axle.body);
    wheel.arm = axle.offset;
    wheel.radius = pulley.def.radius;
    wheel.sense = pulley.def.counterclockwise ? 1.0 : -1.0;
    wheel.lead = pulley.lead;
    wheel.trail = trail_of(cord, pulley);
    wheel.arrival = pulley.arrival;
    wheel.departure = pulley.departure;
    wheel.cord_mass = mass_on_wheel(cord, pulley.def);
    wheel.wheel_mass = wheel_mass(pulley.def);
    wheel.slip_sign = pulley.slip_sign;
    if (wheel.slip_sign != 0.0) wheel.ratio = exponential(pulley.def.friction * std::max(0.0, pulley.arc));
    wheel.driven = pulley.def.motor_torque > 0.0 && pulley.motor_sign == 0.0 && pulley.slip_sign == 0.0;
    for (std::size_t p = wheel.before + 1; p < wheel.after; ++p) {
      state.constrained[p] = 1;
      state.drive_starts[p] = state.positions[p];
      state.drive_velocities[p] = state.velocities[p];
    }
    state.wheels.push_back(wheel);
  }
  member.end_wheel = state.wheels.size();
}

namespace {

/// The speed of a cord that sticks, and of its wheel, m/s: where they differ, momentum is kept.
double common_speed(const Wheel& wheel, const Pulley& pulley) {
  if (wheel.slip_sign != 0.0 || wheel.wheel_mass == 0.0) return pulley.speed;
  const double rim = wheel.sense * wheel.radius * pulley.turning;
  return pulley.speed + wheel.wheel_mass / (wheel.cord_mass + wheel.wheel_mass) * (rim - pulley.speed);
}

/// Returns the sum of the forces on the points of a wheel along the cord, N.
template <typename Force>
double along_wheel(const IslandState& state, const Wheel& wheel, Force&& force) {
  const CordParts& cord = *state.members[wheel.member].cord;
  const WheelPath path = path_of(state, wheel, pulley_of(state, wheel));
  double distance = 0.0;
  double sum = 0.0;
  for (std::size_t p = wheel.before + 1; p < wheel.after; ++p) {
    distance += cord.state.rest[p - 1 - state.members[wheel.member].first_point];
    sum += dot(force(p), place_on_path(path, distance).along);
  }
  return sum;
}

/// The cord that turns around the wheel presses against it by μ·v² less, on either side, than its tension, down to
/// nothing, and it may have a weight that its mass has not as a part of the body. A ring is around the cord, which also
/// presses against its other side.
Vec2 load_of(const IslandState& state, const Wheel& wheel) {
  const WheelSides sides = sides_of(state, wheel, state.positions);
  const double speed = state.velocities[state.groove_of(wheel)].x;
  const Pulley& pulley = pulley_of(state, wheel);
  const double tension = std::max(0.0, std::min(pulley.tension_before, pulley.tension_after));
  const double turning = def_of(state, wheel).mass_per_length * speed * speed;
  const double flux = state.members[wheel.member].cord->has_rings ? turning : std::min(turning, tension);
  const Vec2 fall = state.free_accelerations[state.center(wheel.solved_index)];
  Vec2 load = flux * (sides.before.line.along - sides.after.line.along);
  for (std::size_t p = wheel.before + 1; p < wheel.after; ++p) {
    load += state.masses[p] * (state.free_accelerations[p] - fall);
  }
  return load;
}

}  // namespace

void load_wheels(IslandState& state) {
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    Wheel& wheel = state.wheels[k];
    const CordParts& cord = *state.members[wheel.member].cord;
    const Pulley& pulley = cord.state.pulleys[wheel.pulley];
    const std::size_t groove = state.groove(k);
    const std::size_t center = state.center(wheel.solved_index);
    wheel.blocked = pulley.blocked * pulley.speed > 0.0 || cord.reaches[wheel.pulley].blocks ||
                    (pulley.blocked != 0.0 && pulley.blocked * (pulley.tension_after - pulley.tension_before) >= 0.0);
    const double full_speed = wheel.sense * wheel.radius * pulley.def.motor_speed;
    state.tensions[state.wheel_tension(k)] = pulley.tension_before;
    state.tensions[state.wheel_tension(k) + 1] = pulley.tension_after;
    state.positions[groove] = {};
    state.velocities[groove] = {wheel.blocked ? 0.0 : wheel.driven ? full_speed : common_speed(wheel, pulley), 0.0};
    state.accelerations[groove] = {pulley.acceleration, 0.0};
    state.free_accelerations[groove] = {};
    state.masses[groove] =
        std::max(wheel.cord_mass, min_mass * cord.own_masses[0]) + (wheel.slip_sign == 0.0 ? wheel.wheel_mass : 0.0);
    state.constrained[groove] = wheel.blocked || wheel.driven ? 1 : 0;
    state.drive_starts[groove] = {};
    state.drive_velocities[groove] = state.velocities[groove];
    wheel.gravity =
        along_wheel(state, wheel, [&state](std::size_t p) { return state.masses[p] * state.free_accelerations[p]; });
    wheel.load = load_of(state, wheel);
    state.jolted = state.jolted || std::abs(state.velocities[groove].x - pulley.speed) > least_jolt;
    if (wheel.slip_sign == 0.0 && pulley.motor_sign != 0.0) {
      wheel.torque_force = wheel.sense * pulley.motor_sign * pulley.def.motor_torque / wheel.radius;
    }
    if (state.constrained[center] == 0) {
      state.masses[center] += wheel.cord_mass;
      state.restart = true;  // the acceleration of the body is not known
    }
  }
}

/// What acts on a point of the wheel along the cord acts on the groove. Its weight is also in the mass of the centre.
void load_wheel_forces(IslandState& state, std::span<Vec2> force) {
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    Wheel& wheel = state.wheels[k];
    wheel.weight = along_wheel(state, wheel, [force](std::size_t p) { return force[p]; });
    force[state.center(wheel.solved_index)] += wheel.load;
    force[state.angle(wheel.solved_index)].x += cross(arm_of(state, wheel, state.positions), wheel.load);
    force[state.groove(k)].x += wheel.weight + wheel.torque_force;
  }
}

std::array<int, 5> wheel_slots(const IslandState& state, const Wheel& wheel) {
  return {static_cast<int>(wheel.before), static_cast<int>(wheel.after), static_cast<int>(state.groove_of(wheel)),
          static_cast<int>(state.center(wheel.solved_index)), static_cast<int>(state.angle(wheel.solved_index))};
}

namespace {

/// A side of a wheel as rows of the coupled system.
struct SideRow {
  int point = 0;             // its slot
  double rest = 0.0;         // m, length at rest
  double sign = 1.0;         // of the change of its length along the cord as the point moves
  Vec2 component{1.0, 0.0};  // of the wheel's unknown tensions
};

void load_side(const IslandState& state, const Wheel& wheel, const Stage& stage, const WheelSide& side,
               const SideRow& row, BlockLdlt& blocks, std::span<Vec2> right_side) {
  const std::array<int, 5> slots = wheel_slots(state, wheel);
  const int groove = slots[2];
  const std::size_t k = state.index_of(wheel);
  const int dual = state.wheel_dual(k);
  const double tension = state.tensions[state.wheel_tension(k) + (row.sign > 0.0 ? 1 : 0)];
  const CordDef& def = def_of(state, wheel);
  const double inertia = stage.inertia[at(row.point)];
  const MixedBar bar{side.elongation, compliance_of(def, row.rest)};
  const Vec2 of = row.component;
  if (def.tension_only && is_slack(bar, tension, 1.0 / inertia, side.line.length)) {
    blocks.add(dual, -of.x, 0.0, -of.y);
    return;
  }
  const Vec2 t = side.line.along;
  const Vec2 turning = perp(arm_of(state, wheel, state.positions));
  const auto couple = [&](int slot, Vec2 by) {
    blocks.add(slot, dual, by.x * of.x, by.x * of.y, by.y * of.x, by.y * of.y);
  };
  couple(row.point, row.sign * t);
  couple(slots[3], -row.sign * t);
  couple(slots[4], {-row.sign * dot(turning, t), 0.0});
  couple(groove, {-row.sign, 0.0});
  const double compliance = std::max(bar.compliance, min_dual_compliance / inertia);
  blocks.add(dual, -compliance * of.x, 0.0, -compliance * of.y);
  right_side[at(dual)] -= side.elongation * of;
  right_side[at(groove)].x += row.sign * tension * tension / (2.0 * def.stretch_stiffness);
  const Vec2 u = perp(t);
  blocks.add_outer(std::max(0.0, tension) / side.line.length, std::array{row.point, slots[3], slots[4]},
                   std::array{u, -u, Vec2{-dot(u, turning), 0.0}});
}

}  // namespace

void load_wheel_rows(const IslandState& state, const Stage& stage, BlockLdlt& blocks, std::span<Vec2> right_side) {
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    const WheelSides sides = sides_of(state, wheel, state.positions);
    blocks.make_dual(state.wheel_dual(k));
    right_side[at(state.wheel_dual(k))] = {};
    right_side[state.groove(k)].y = 0.0;
    load_side(state, wheel, stage, sides.before, {static_cast<int>(wheel.before), wheel.lead, -1.0, {1.0, 0.0}}, blocks,
              right_side);
    load_side(state, wheel, stage, sides.after, {static_cast<int>(wheel.after), wheel.trail, 1.0, {0.0, 1.0}}, blocks,
              right_side);
  }
}

void update_wheels(const IslandState& state, std::span<const Vec2> solution, std::span<double> next) {
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Vec2 tensions = solution[at(state.wheel_dual(k))];
    next[state.wheel_tension(k)] = tensions.x;
    next[state.wheel_tension(k) + 1] = tensions.y;
  }
}

double wheel_potential(const IslandState& state, std::span<const double> max_tensions, std::span<const Vec2> x) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    const CordDef& def = def_of(state, wheel);
    const WheelSides sides = sides_of(state, wheel, x);
    const std::size_t tension = state.wheel_tension(k);
    const auto add = [&](const WheelSide& side, double rest, double max_tension) {
      if (def.tension_only && side.elongation <= 0.0) return;
      sum += exact_penalty({side.elongation, compliance_of(def, rest)}, max_tension);
    };
    add(sides.before, wheel.lead, max_tensions[tension]);
    add(sides.after, wheel.trail, max_tensions[tension + 1]);
  }
  return sum;
}

double wheel_energy(const IslandState& state) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    const CordDef& def = def_of(state, wheel);
    const double run = state.positions[state.groove(k)].x;
    const std::size_t tension = state.wheel_tension(k);
    sum += elastic_energy(state.tensions[tension], compliance_of(def, wheel.lead - run), 0.0, 0.0) +
           elastic_energy(state.tensions[tension + 1], compliance_of(def, wheel.trail + run), 0.0, 0.0);
  }
  return sum;
}

double wheel_load_energy(const IslandState& state) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    const Vec2 axle = state.positions[state.center(wheel.solved_index)] + arm_of(state, wheel, state.positions);
    sum -= wheel.gravity * state.positions[state.groove(k)].x + dot(wheel.load, axle);
    for (std::size_t p = wheel.before + 1; p < wheel.after; ++p) {
      sum += state.masses[p] * dot(state.free_accelerations[p], state.positions[p]);
    }
  }
  return sum;
}

double wheel_work(const IslandState& state) {
  double sum = 0.0;
  for (std::size_t k = 0; k < state.wheels.size(); ++k) {
    const Wheel& wheel = state.wheels[k];
    const PulleyDef& def = pulley_of(state, wheel).def;
    if (def.motor_torque == 0.0) continue;
    const std::size_t groove = state.groove(k);
    const std::size_t tension = state.wheel_tension(k);
    const double force = std::min(def.motor_torque / wheel.radius,
                                  std::abs(state.tensions[tension]) + std::abs(state.tensions[tension + 1]));
    sum += 2.0 * force * std::abs(state.positions[groove].x - state.start.positions[groove].x);
  }
  return sum;
}

}  // namespace ribbon
