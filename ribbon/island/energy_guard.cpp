#include "ribbon/island/energy_guard.h"

#include <algorithm>
#include <cmath>

#include "ribbon/cord_forces.h"
#include "ribbon/island/momentum.h"
#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/wheels.h"

namespace ribbon {
namespace {

// Shares of the scene's energy, which is M·g·L, or the kinetic and elastic energy if that is larger:
constexpr double max_regainable = 2e-3;           // of a smooth motion, whose integration sways about the exact energy
constexpr double max_regainable_touching = 7e-4;  // where a contact begins, or a grip slips, no gain is smooth
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

/// Returns an upper bound, J, for the work of drag on an island in a substep. With the velocity V of the frame, a point
/// that moves at v gets the power
///
///     −c·v·(v − V) = −c·|v − V|² − c·V·(v − V) ≤ c·|V|·|v − V|.
double max_drag_work(const IslandState& state) {
  const double speed = length(state.frame_velocity);
  if (speed == 0.0) return 0.0;
  double work = 0.0;
  for (const Member& member : state.members) {
    const CordParts& cord = *member.cord;
    for (std::size_t i = 0; cord.def.drag > 0.0 && i < member.points; ++i) {
      const std::size_t p = member.first_point + i;
      const double relative = std::max(length(state.start.velocities[p] - state.frame_velocity),
                                       length(state.velocities[p] - state.frame_velocity));
      work += cord.def.drag * cord.own_masses[i] * speed * relative * state.start.dt;
    }
  }
  return work;
}

/// Returns whether a point is constrained because it is on a wheel. The wheel moves it, and what its motor does is
/// known.
bool is_moved_by_wheel(const IslandState& state, std::size_t point) {
  return std::any_of(state.wheels.begin(), state.wheels.end(),
                     [point](const Wheel& wheel) { return wheel.before < point && point < wheel.after; });
}

/// Returns an upper bound, J, for the work that is done in a substep, as far as it is known.
double max_known_work(const IslandState& state) { return grip_work(state) + wheel_work(state) + max_drag_work(state); }

bool is_smooth(const IslandState& state, const Contacts& contacts) {
  return contacts.empty() &&
         std::none_of(state.held.begin(), state.held.end(), [](const HeldBody& held) { return held.slip_sign != 0.0; });
}

/// Adds the pushes to the velocities.
void add_pushes(IslandState& state, double factor) {
  for (std::size_t p = 0; p < state.pushes.size(); ++p) state.velocities[p] += factor * state.pushes[p];
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

/// What drives: points that are pinned or dragged, kinematic bodies that hold the cord, and supports. If there are
/// none, the first kinematic body that may be touched tells the frame; it and all others drive as soon as they are.
void EnergyGuard::find_frame(IslandState& state, const Contacts& contacts) {
  bool found = false;
  state.frame_velocity = {};
  const auto add = [&](Vec2 velocity) {
    if (!found) state.frame_velocity = velocity;
    found = true;
    state.driven = state.driven || !is_at_rest(velocity, state.frame_velocity);
  };
  for (std::size_t p = 0; p < state.points; ++p) {
    if (state.constrained[p] != 0 && !is_moved_by_wheel(state, p)) add(state.drive_velocities[p]);
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    if (state.constrained[state.center(k)] == 0) continue;
    add(state.drive_velocities[state.center(k)]);
    state.driven = state.driven || state.drive_velocities[state.angle(k)].x != 0.0;
  }
  for (const BodySupport& support : state.supports.all) {
    if (!support.gives_way()) add({});
    state.driven = state.driven || support.speed != 0.0;
  }
  if (!found) {
    for (const BodyAnchor& anchor : contacts.scene.anchors.bodies()) {
      if (!found && anchor.is_kinematic()) add(anchor.velocity);
    }
  }
  state.driven = state.driven || (state.frame_velocity != Vec2{} && (state.in_medium || !state.wheels.empty()));
}

void EnergyGuard::find_scale(const IslandState& state) {
  double mass = 0.0;
  double longest = 0.0;
  double loads = 0.0;
  double scale = 1.0;  // bodies fall with the world's gravity
  for (const Member& member : state.members) {
    longest = std::max(longest, member.cord->def.length);
    scale = std::max(scale, std::abs(member.cord->def.gravity_scale));
    for (const Vec2 load : member.cord->state.loads) loads += length(load);
  }
  for (std::size_t p = 0; p < state.points; ++p) mass += state.masses[p];
  for (std::size_t k = 0; k < state.bodies.size(); ++k) mass += state.masses[state.center(k)];
  const double noise = noise_displacement * state.tolerance / state.dt;
  weight_scale_ = mass * (scale * length(state.gravity) * longest + noise * noise) + loads * longest;
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

void EnergyGuard::begin_pushes(IslandState& state) {
  was_pushed_ = false;
  known_work_ = 0.0;
  if (state.pushes.empty()) return;
  add_pushes(state, -1.0);
  unpushed_ = energy_without_contacts(state).total();
  add_pushes(state, 1.0);
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const std::size_t center = state.center(k);
    unpushed_ -= state.masses[center] * state.dt * dot(state.free_accelerations[center], state.pushes[center]);
  }
}

void EnergyGuard::end_pushes(IslandState& state) const {
  if (state.pushes.empty()) return;
  add_pushes(state, -1.0);
  if (was_pushed_) return;
  const double gain = energy_without_contacts(state).total() - unpushed_ - known_work_;
  if (gain > 0.0) slow_down(state, gain);
}

CordEnergy EnergyGuard::total_energy(IslandState& state, Contacts& contacts) {
  Energy sum = energy_without_contacts(state);
  if (!contacts.empty()) {
    contacts.active.update(contacts.scene, state.positions);
    sum.elastic += contacts.energy();
  }
  return sum;
}

CordEnergy EnergyGuard::energy_without_contacts(IslandState& state) {
  Energy sum;
  sum.elastic = wheel_energy(state) + support_energy(state);
  sum.potential = wheel_load_energy(state);
  const std::vector<Vec2>& x = state.positions;
  const Vec2 frame = state.frame_velocity;
  const Vec2 origin = state.now * frame;
  for (const Member& member : state.members) {
    const CordParts& cord = *member.cord;
    sum.elastic += cord.elasticity->energy(state.motion_of(member), IslandState::tensions_of(member, state.tensions));
    for (std::size_t p = 0; p < cord.state.loads.size(); ++p) {
      sum.potential -= dot(cord.state.loads[p], x[member.first_point + p] - origin);
    }
  }
  for (std::size_t p = 0; p < state.points; ++p) {
    const Vec2 v = state.velocities[p] - frame;
    sum.kinetic += 0.5 * state.masses[p] * dot(v, v);
    sum.potential -= state.masses[p] * dot(state.free_accelerations[p], x[p] - origin);
  }
  for (std::size_t p = state.points; p < state.slots(); ++p) {
    const Vec2 v = state.is_scalar(p) ? state.velocities[p] : state.velocities[p] - frame;
    sum.kinetic += 0.5 * state.masses[p] * dot(v, v);
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const std::size_t center = state.center(k);
    sum.potential -= state.masses[center] * dot(state.free_accelerations[center], x[center] - origin);
  }
  return sum;
}

bool EnergyGuard::is_moved(const IslandState& state, const Contacts& contacts) {
  return state.driven || contacts.impacts.touch_moving(contacts.scene, state.frame_velocity);
}

bool EnergyGuard::is_driven(const IslandState& state, const Contacts& contacts) {
  return is_moved(state, contacts) || contacts.impacts.touch_belt(contacts.scene);
}

void EnergyGuard::measure(IslandState& state, Contacts& contacts) {
  if (is_pushed(state, contacts)) {
    was_pushed_ = true;
  } else {
    measure_once(state, contacts);
    if (!state.pushes.empty()) known_work_ += max_known_work(state);
  }
}

void EnergyGuard::measure_once(IslandState& state, Contacts& contacts) {
  if (!is_measured_) after_ = total_energy(state, contacts);
  is_measured_ = true;
}

bool EnergyGuard::gained_energy(IslandState& state, Contacts& contacts, const Energy& before, double tolerated) {
  discard_measurement();
  if (is_driven(state, contacts)) return false;
  measure_once(state, contacts);
  return is_gain(state, contacts, before, tolerated);
}

/// Returns whether the energy that was measured is more than the one before and what may be added to it.
bool EnergyGuard::is_gain(const IslandState& state, const Contacts& contacts, const Energy& before,
                          double tolerated) const {
  const double share = tolerated * scale(before);
  double allowed = regainable_ + share;
  if (!is_smooth(state, contacts) && regainable_ > 0.0) {
    allowed = std::max(std::min(regainable_, max_regainable_touching * scale(before)), share);
  }
  const double gain = after_.total() - before.total();
  const double known = max_known_work(state) + allowed;
  if (gain <= known) return false;
  return !(state.in_medium && gain <= known + max_medium_work(state));
}

double EnergyGuard::remove_spurious_energy(IslandState& state, Contacts& contacts, const Energy& before) {
  if (!gained_energy(state, contacts, before, tolerated_gain)) return 0.0;
  const double gain = std::max(0.0, after_.total() - before.total());
  slow_down(state, gain);
  discard_measurement();
  return std::max(0.0, gain - after_.kinetic) / scale(before);
}

void EnergyGuard::remove_spurious_motion(IslandState& state, Contacts& contacts, const Energy& before) {
  if (is_driven(state, contacts)) return;
  measure_once(state, contacts);
  if (!is_gain(state, contacts, before, tolerated_gain)) return;
  const double motion = after_.kinetic - before.kinetic + after_.potential - before.potential;
  slow_down(state, std::clamp(motion, 0.0, std::max(0.0, after_.total() - before.total())));
  discard_measurement();
}

void EnergyGuard::account(IslandState& state, const Contacts& contacts, const Energy& before) {
  if (is_pushed(state, contacts)) return;
  const double kept = regainable_ > 0.0 ? regainable_decay * regainable_ : regainable_;
  const double scene = scale(before);
  const double lost = before.total() - after_.total();
  const double unexplained = lost < 0.0 ? std::min(0.0, lost + max_known_work(state)) : lost;
  const double most = is_smooth(state, contacts) ? max_regainable : max_regainable_touching;
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
