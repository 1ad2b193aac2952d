#include "ribbon/island/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "ribbon/island/momentum.h"
#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/wheels.h"

namespace ribbon {
namespace {

// Shares of the scene's energy, which is M·g·L, or the kinetic and elastic energy if that is larger:
constexpr double max_regainable = 2e-3;           // of a smooth motion, whose integration sways about the exact energy
constexpr double max_regainable_touching = 7e-4;  // where a contact begins, a gain is not smooth
constexpr double max_total_gain = 5e-7;           // a cord may have gained so much in all,
constexpr double max_gain_rate = 1e-8;  // and more as long as a substep adds no more than this, as a smooth motion does
constexpr double regainable_decay = 0.9;    // of what may be regained, in a substep
constexpr double noise_displacement = 0.1;  // tolerances that a point at rest may move in a step

/// Returns an upper bound, J, for the work of media on an island in a step.
double max_medium_work(const IslandState& state) {
  const double speed = highest_start_speed(state);
  double work = 0.0;
  for (const Member& member : state.members) {
    if (!member.in_medium) continue;
    const MediumPush push = max_medium_push(*member.cord, member.surroundings, state.dt, state.gravity);
    work += push.impulse * (speed + push.relative_speed);
  }
  return work;
}

}  // namespace

void EnergyGuard::begin_step(const IslandState& state) {
  regainable_ = 0.0;
  drift_ = 0.0;
  for (const Member& member : state.members) {
    regainable_ += member.cord->state.regainable_energy;
    drift_ += member.cord->state.energy_drift;
  }
}

void EnergyGuard::find_scale(const IslandState& state) {
  double mass = 0.0;
  double longest = 0.0;
  double scale = 1.0;  // bodies fall with the world's gravity
  for (const Member& member : state.members) {
    longest = std::max(longest, member.cord->def.length);
    scale = std::max(scale, std::abs(member.cord->def.gravity_scale));
  }
  for (std::size_t p = 0; p < state.points; ++p) mass += state.masses[p];
  for (std::size_t k = 0; k < state.bodies.size(); ++k) mass += state.masses[state.center(k)];
  const double noise = noise_displacement * state.tolerance / state.dt;
  weight_scale_ = mass * (scale * length(state.gravity) * longest + noise * noise);
}

void EnergyGuard::store(const IslandState& state) const {
  // A state cannot store an energy that is not finite.
  const auto share = [&](double all) {
    return std::isfinite(all) ? all / static_cast<double>(state.members.size()) : 0.0;
  };
  for (const Member& member : state.members) {
    member.cord->state.regainable_energy = share(regainable_);
    member.cord->state.energy_drift = share(drift_);
  }
}

Cord::Energy EnergyGuard::total_energy(IslandState& state, Contacts& contacts) {
  Energy sum;
  sum.elastic = wheel_energy(state);
  sum.potential = wheel_load_energy(state);
  const std::vector<Vec2>& x = state.positions;
  for (const Member& member : state.members) {
    const CordParts& cord = *member.cord;
    sum.elastic += cord.elasticity->energy(state.motion_of(member), IslandState::tensions_of(member, state.tensions));
    for (std::size_t p = 0; p < cord.state.loads.size(); ++p) {
      sum.potential -= dot(cord.state.loads[p], x[member.first_point + p]);
    }
  }
  for (std::size_t p = 0; p < state.slots(); ++p) {
    sum.kinetic += 0.5 * state.masses[p] * dot(state.velocities[p], state.velocities[p]);
  }
  for (std::size_t p = 0; p < state.points; ++p)
    sum.potential -= state.masses[p] * dot(state.free_accelerations[p], x[p]);
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const std::size_t center = state.center(k);
    sum.potential -= state.masses[center] * dot(state.free_accelerations[center], x[center]);
  }
  if (!contacts.empty()) {
    contacts.active.update(contacts.scene, x);
    sum.elastic += contacts.energy();
  }
  return sum;
}

void EnergyGuard::measure(IslandState& state, Contacts& contacts) {
  if (!state.is_pushed()) after_ = total_energy(state, contacts);
}

bool EnergyGuard::gained_energy(IslandState& state, Contacts& contacts, const Energy& before, double tolerated) {
  if (state.driven) return false;
  after_ = total_energy(state, contacts);
  const double share = tolerated * scale(before);
  double allowed = regainable_ + share;
  if (!contacts.empty() && regainable_ > 0.0) {
    allowed = std::max(std::min(regainable_, max_regainable_touching * scale(before)), share);
  }
  const double gain = after_.total() - before.total();
  const double known = grip_work(state) + wheel_work(state) + allowed;
  if (gain <= known) return false;
  return !(state.in_medium && gain <= known + max_medium_work(state));
}

void EnergyGuard::remove_spurious_energy(IslandState& state, Contacts& contacts, const Energy& before) {
  if (!gained_energy(state, contacts, before, tolerated_gain)) return;
  slow_down(state, std::max(0.0, after_.total() - before.total()));
}

void EnergyGuard::remove_spurious_motion(IslandState& state, Contacts& contacts, const Energy& before) {
  if (!gained_energy(state, contacts, before, tolerated_gain)) return;
  const double motion = after_.kinetic - before.kinetic + after_.potential - before.potential;
  slow_down(state, std::clamp(motion, 0.0, std::max(0.0, after_.total() - before.total())));
}

void EnergyGuard::account(IslandState& state, const Contacts& contacts, const Energy& before) {
  const double kept = regainable_ > 0.0 ? regainable_decay * regainable_ : regainable_;
  const double scene = scale(before);
  const double lost = before.total() - after_.total();
  const double unexplained = lost < 0.0 ? std::min(0.0, lost + (grip_work(state) + wheel_work(state))) : lost;
  const double most = contacts.empty() ? max_regainable : max_regainable_touching;
  regainable_ = std::clamp(kept + unexplained, -tolerated_gain * scene, most * scene);
  if (contacts.impacts.any() && unexplained < 0.0) return;  // what comes out of a deep penetration may gain
  drift_ += unexplained;
  const double excess = -drift_ - max_total_gain * scene;
  if (excess <= 0.0 || unexplained > -max_gain_rate * scene) return;
  slow_down(state, excess);
  drift_ += excess;
}

double EnergyGuard::scale(const Energy& energy) const {
  return std::max(weight_scale_, energy.kinetic + energy.elastic);
}

}  // namespace ribbon
