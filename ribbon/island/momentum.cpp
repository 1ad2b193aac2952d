#include "ribbon/island/momentum.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/stretch.h"

namespace ribbon {
namespace {

/// kg·m²/s and kg·m², about the common centre of mass.
struct Spin {
  double momentum = 0.0;
  double inertia = 0.0;
};

/// Returns whether nothing but the same gravity for all acts on the island from outside.
bool is_free(const IslandState& state) {
  if (!state.wheels.empty() || state.supports.any_from_outside()) return false;
  const auto is_zero = [](char constrained) { return constrained == 0; };
  const Vec2 fall = state.free_accelerations[0];
  const auto falls = [&](Vec2 acceleration) { return acceleration == fall; };
  const auto is_unloaded = [](const Member& member) {
    return member.cord->state.loads.empty() && member.cord->def.drag == 0.0 && !member.in_medium;
  };
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const std::size_t center = state.center(k);
    if (state.constrained[center] != 0 || !falls(state.free_accelerations[center])) return false;
  }
  const auto points = static_cast<std::ptrdiff_t>(state.points);
  const auto points_end = state.constrained.begin() + points;
  const auto falls_end = state.free_accelerations.begin() + points;
  return std::all_of(state.constrained.begin(), points_end, is_zero) &&
         std::all_of(state.members.begin(), state.members.end(), is_unloaded) &&
         std::all_of(state.free_accelerations.begin(), falls_end, falls);
}

/// Returns the mean of points and bodies, weighted by mass.
Vec2 mean(const IslandState& state, std::span<const Vec2> by_slot) {
  Vec2 sum;
  double mass = 0.0;
  for (std::size_t p = 0; p < by_slot.size(); ++p) {
    if (state.is_scalar(p)) continue;
    sum += state.masses[p] * by_slot[p];
    mass += state.masses[p];
  }
  return (1.0 / mass) * sum;
}

Spin spin(const IslandState& state, std::span<const Vec2> x, std::span<const Vec2> v) {
  const Vec2 middle = mean(state, x);
  Spin sum;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (state.is_scalar(p)) {
      if (state.constrained[p] != 0) continue;
      sum.momentum += state.masses[p] * v[p].x;
      sum.inertia += state.masses[p];
    } else {
      const Vec2 arm = x[p] - middle;
      sum.momentum += state.masses[p] * cross(arm, v[p]);
      sum.inertia += state.masses[p] * dot(arm, arm);
    }
  }
  return sum;
}

/// Limits spins such that a point at the radius of gyration, or in a groove, is not faster than `max` [m/s], unless the
/// body turned as fast at the start of the substep. Returns whether one was faster.
bool limit_spins(IslandState& state, double max) {
  bool any = false;
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const std::size_t angle = state.angle(k);
    if (state.constrained[angle] != 0) continue;
    double radius = std::sqrt(state.masses[angle] / state.masses[state.center(k)]);
    for (const Wheel& wheel : state.wheels) {
      if (wheel.solved_index == k) radius = std::max(radius, wheel.radius);
    }
    const double most = std::max(max / radius, std::abs(state.start.velocities[angle].x));
    double& turning = state.velocities[angle].x;
    if (!(std::abs(turning) > most)) continue;
    turning = std::copysign(most, turning);
    any = true;
  }
  return any;
}

/// Returns the highest speed, m/s, of what was as fast as anything at the start of the substep and has fallen since.
double max_fall_speed(const IslandState& state) {
  double gravity = length(state.gravity);
  for (std::size_t p = 0; p < state.points; ++p) gravity = std::max(gravity, length(state.free_accelerations[p]));
  double pushed = 0.0;
  for (const Member& member : state.members) {
    if (!member.in_medium) continue;
    pushed = std::max(pushed, max_medium_push(*member.cord, member.surroundings, state.dt, state.gravity).delta_v);
  }
  return highest_start_speed(state) + gravity * state.dt + pushed;
}

}  // namespace

void slow_down(IslandState& state, double excess) {
  double turning = 0.0;
  Vec2 mean_velocity = state.frame_velocity;
  const Vec2 middle = mean(state, state.positions);
  if (is_free(state)) {
    const Spin all = spin(state, state.positions, state.velocities);
    turning = all.inertia > 0.0 ? all.momentum / all.inertia : 0.0;
    mean_velocity = mean(state, state.velocities);
  }
  const auto rigid = [&](std::size_t p) {
    if (state.is_scalar(p)) return Vec2{turning, 0.0};
    return mean_velocity + turning * perp(state.positions[p] - middle);
  };
  double kinetic = 0.0;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    const Vec2 own = state.velocities[p] - rigid(p);
    if (state.constrained[p] == 0) kinetic += 0.5 * state.masses[p] * dot(own, own);
  }
  const double share = kinetic > excess ? std::sqrt((kinetic - excess) / kinetic) : 0.0;
  state.add_damping(-1.0);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] == 0) state.velocities[p] = rigid(p) + share * (state.velocities[p] - rigid(p));
  }
  state.add_damping(1.0);
}

bool restore_momentum(IslandState& state, const Contacts& contacts) {
  if (!contacts.impacts.any() || state.driven || state.in_medium || contacts.impacts.touch_kinematic(contacts.scene) ||
      !is_free(state))
    return false;
  const SubstepStart& start = state.start;
  const Spin before = spin(state, start.positions, start.velocities);
  const Spin after = spin(state, state.positions, state.velocities);
  const double turning = (before.momentum - after.momentum) / after.inertia;
  const Vec2 middle = mean(state, state.positions);
  const Vec2 lost =
      mean(state, start.velocities) + start.dt * state.free_accelerations[0] - mean(state, state.velocities);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (!state.is_scalar(p)) {
      state.velocities[p] += lost + turning * perp(state.positions[p] - middle);
    } else if (state.constrained[p] == 0) {
      state.velocities[p].x += turning;
    }
  }
  return true;
}

bool is_thrown(const IslandState& state) {
  if (!state.driven || !became_stretched(state)) return false;
  const double max = max_fall_speed(state);
  for (std::size_t p = 0; p < state.points; ++p) {
    if (state.constrained[p] == 0 && length(state.velocities[p]) > max) return true;
  }
  return false;
}

bool limit_speeds(IslandState& state) {
  const double max = max_fall_speed(state);
  state.add_damping(-1.0);
  bool any = limit_spins(state, max);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (!state.has_speed(p) || state.constrained[p] != 0) continue;
    const double speed = length(state.velocities[p]);
    if (!(speed > max)) continue;
    state.velocities[p] = (max / speed) * state.velocities[p];
    any = true;
  }
  state.add_damping(1.0);
  return any;
}

}  // namespace ribbon
