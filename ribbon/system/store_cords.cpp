#include "ribbon/system/store_cords.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "ribbon/linear/index.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/overstretch.h"
#include "ribbon/system/slips.h"
#include "ribbon/system/wheel_end.h"

namespace ribbon {
namespace {

template <typename T>
void copy_from(std::span<const T> source, std::vector<T>& target) {
  std::copy(source.begin(), source.end(), target.begin());
}

/// Halves the velocity at which the free points deform. What crushed or inverted cells give back when they open would
/// become a vibration. The motion of the cord as a rigid body stays.
void damp_deformation(const IslandState& state, const Member& member) {
  Cord::State& cord = member.cord->state;
  double mass = 0.0;
  Vec2 middle;
  Vec2 momentum;
  for (std::size_t p = 0; p < member.points; ++p) {
    mass += cord.masses[p];
    middle += cord.masses[p] * cord.positions[p];
    momentum += cord.masses[p] * cord.velocities[p];
  }
  middle = (1.0 / mass) * middle;
  const Vec2 mean_velocity = (1.0 / mass) * momentum;
  double inertia = 0.0;
  double spin = 0.0;
  for (std::size_t p = 0; p < member.points; ++p) {
    const Vec2 arm = cord.positions[p] - middle;
    inertia += cord.masses[p] * dot(arm, arm);
    spin += cord.masses[p] * cross(arm, cord.velocities[p]);
  }
  const double turning = inertia > 0.0 ? spin / inertia : 0.0;
  for (std::size_t p = 0; p < member.points; ++p) {
    if (state.constrained[member.first_point + p] != 0) continue;
    const Vec2 rigid = mean_velocity + turning * perp(cord.positions[p] - middle);
    cord.velocities[p] = 0.5 * (cord.velocities[p] + rigid);
  }
}

void store_reel(CordParts& cord) {
  if (cord.state.rest_targets.empty()) return;
  for (std::size_t e = 0; e < cord.state.rest_targets.size(); ++e) {
    const bool arrived = cord.rest_end[e] == cord.state.rest_targets[e] && cord.rest_start[e] != cord.rest_end[e];
    cord.state.restart = cord.state.restart || arrived;
  }
  cord.state.rest = cord.rest_end;
  cord.elasticity->set_rest_lengths(cord.state.rest);
}

void store_holders(const IslandState& state, const Member& member) {
  auto& holders = member.cord->state.holders;
  holders.clear();
  for (std::size_t k = member.first_grip; k < member.end_grip; ++k) {
    const HeldBody& held = state.held[k];
    const std::size_t center = state.center(held.solved_index);
    const std::size_t angle = state.angle(held.solved_index);
    Cord::Holder holder;
    holder.point = static_cast<int>(held.point - member.first_point);
    holder.velocity = state.velocities[center];
    holder.turning = state.velocities[angle].x;
    holder.acceleration = state.accelerations[center];
    holder.angular_acceleration = state.accelerations[angle].x;
    holder.grip = static_cast<int>(held.grip);
    holder.pull = grip_reaction(state, k);
    holder.slid = held.slid;
    holder.slips = held.slid != 0.0;
    holders.push_back(holder);
  }
}

void store_medium_forces(const IslandState& state, const Member& member) {
  std::vector<Vec2>& forces = member.cord->state.medium_forces;
  if (!member.in_medium) return forces.clear();
  const auto by_point = IslandState::points_of(member, state.medium_forces);
  forces.assign(by_point.begin(), by_point.end());
}

void store_cord(IslandState& state, const Member& member) {
  CordParts& cord = *member.cord;
  copy_from(std::span<const Vec2>(IslandState::points_of(member, state.positions)), cord.state.positions);
  copy_from(std::span<const Vec2>(IslandState::points_of(member, state.velocities)), cord.state.velocities);
  copy_from(std::span<const Vec2>(IslandState::points_of(member, state.accelerations)), cord.state.accelerations);
  copy_from(std::span<const double>(IslandState::tensions_of(member, state.tensions)), cord.state.tensions);
  for (std::size_t p = 0; p < member.points; ++p) {
    if (cord.state.kinds[p] != PointKind::free) cord.state.positions[p] = cord.state.targets[p];  // to the last bit
  }
  cord.state.restart = state.restart;
  cord.sweep.reset();
  store_overstretch(cord);
  store_reel(cord);
  store_holders(state, member);
  store_wheels(state, member);
  store_medium_forces(state, member);
  if (!state.unlocking) return;
  cord.exclude_damping();
  damp_deformation(state, member);
  cord.state.restart = true;
}

/// Returns the velocity v [m/s] of a body after a step in dt [s]. Where something was in the way of a push, v is
/// against it. Nothing has thrown the body back: it is no faster in that direction than it was.
Vec2 without_recoil(const RigidBody& body, double dt, Vec2 v) {
  if (body.pushed == Vec2{}) return v;
  const Vec2 along = (1.0 / length(body.pushed)) * body.pushed;
  const Vec2 free = body.velocity + body.inverse_mass * body.impulse + dt * body.acceleration;
  const double recoil = std::min(0.0, dot(free, along)) - dot(v, along);
  return recoil > 0.0 ? v + recoil * along : v;
}

/// The same for its rotation, rad/s.
double without_recoil(const RigidBody& body, double turning) {
  if (body.pushed_turn == 0.0) return turning;
  const double sign = std::copysign(1.0, body.pushed_turn);
  const double free = body.angular_velocity + body.inverse_inertia * body.angular_impulse;
  return sign * std::max(sign * turning, std::min(0.0, sign * free));
}

}  // namespace

void store_cords(IslandState& state) {
  if (state.coupled) find_slips(state);
  for (const Member& member : state.members) store_cord(state, member);
}

void store_bodies(const IslandState& state) {
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    RigidBody& body = state.rigid[at(state.bodies[k].index)];
    if (body.inverse_mass == 0.0) continue;
    const std::size_t center = state.center(k);
    const std::size_t angle = state.angle(k);
    const Vec2 velocity = without_recoil(body, state.dt, state.velocities[center]);
    const double turning = without_recoil(body, state.velocities[angle].x);
    body.impulse = (1.0 / body.inverse_mass) * (velocity - body.velocity - state.dt * body.acceleration);
    if (state.bodies[k].turns) body.angular_impulse = (turning - body.angular_velocity) / body.inverse_inertia;
    body.moved = state.positions[center] - body.position;
    body.turned = state.positions[angle].x;
    body.solved = true;
  }
}

}  // namespace ribbon
