#include "ribbon/island/substeps.h"

#include <algorithm>

#include "ribbon/cord_forces.h"
#include "ribbon/island/momentum.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

constexpr int max_tighter_retries = 3;  // of a substep of implicit Euler that gained energy
constexpr double retried_gain = 2e-3;   // of the scene's energy, above which it is retried
constexpr double gross_gain = 1e-2;     // the same, tolerated of a retry: no integrator damps more
constexpr double retry_share = 0.3;     // of the work of an attempt, after which it has not enough left for retries
// Newton steps in the halves of a substep. (5,000 slack links on a load of 10⁶ kg that turn about so much in steps of a
// second take 4,200. With 600 near contacts, a ball shot at a loose cord lost its velocity instead of pushing the cord
// away: `*ShotAtTenAndAHundredRadiiATick*`.)
constexpr int max_halved_work = 16000;
constexpr int max_unsolved_work = 4000;  // the same once a part is kept that is not solved
// Times that a substep is halved, and its beginning: what was thrown apart finds back at once.
constexpr int max_halvings = 10;
constexpr int max_first_halvings = 20;

/// What the tolerance leaves in a stiff cord, times its tension, is energy too. It mostly goes with a hundredth of it.
double smaller_tolerance(const IslandState& state) { return std::max(1e-2 * state.tolerance, state.min_tolerance); }

bool has_rings(const IslandState& state) {
  return std::any_of(state.members.begin(), state.members.end(),
                     [](const Member& member) { return member.cord->has_rings; });
}

/// Returns to the start of a substep that gained energy, for a retry with another tolerance.
void begin_retry(const StepContext& context, double tolerance) {
  ++context.work.report.energy_gains;
  context.return_to_start();
  context.contacts.impacts.scale_impulses(0.0);
  context.state.tolerance = tolerance;
}

/// Returns whether something would begin to touch in free motion.
bool will_touch(const StepContext& context, double time, double dt) {
  const IslandState& state = context.state;
  const SubstepStart& start = state.start;
  std::vector<Vec2>& end = context.stages.trial();
  context.contacts.scene.anchors.set_kinematic_targets(time + dt);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    end[p] = start.positions[p] + dt * start.velocities[p] + (dt * dt) * state.free_accelerations[p];
  }
  return context.contacts.sweep.collision_free_fraction(context.contacts.scene, start.positions, end,
                                                        KinematicTime::target) < 1.0;
}

}  // namespace

void Substeps::resize(std::size_t slots, std::size_t tensions) {
  integrators_.resize(slots);
  whole_.positions.resize(slots);
  whole_.velocities.resize(slots);
  whole_.tensions.resize(tensions);
}

bool Substeps::take(const StepContext& context, double time, double dt, Restitution& restitution) {
  context.contacts.impacts.scale_impulses(0.0);
  context.begin_substep(time, dt);
  const CordEnergy before = context.energy_before();
  if (!take_second_order(context, time, dt, before)) {
    if (take_damped(context, time, dt, before)) {
      if (context.state.turning_cells) {
        if (!end_turning(context, before)) return false;
      } else {
        context.guard.remove_spurious_motion(context.state, context.contacts, before);
      }
    } else {
      if (!context.state.keeps_unsolved) return false;
      context.stages.store_corrections(context.state);
      context.report_unconverged(0.0, 0.0);
      context.guard.remove_spurious_energy(context.state, context.contacts, before);
    }
  }
  end(context, before, dt, restitution);
  return true;
}

/// Where cells were turned back, takes out of the motion what that has gained. Returns false if it has gained much
/// more.
bool Substeps::end_turning(const StepContext& context, const CordEnergy& before) {
  IslandState& state = context.state;
  const double left = context.guard.remove_spurious_energy(state, context.contacts, before);
  state.turning_gained = left > gross_gain && !state.turned_at_any_cost;
  return !state.turning_gained;
}

void Substeps::end(const StepContext& context, const CordEnergy& before, double dt, Restitution& restitution) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  if (!contacts.empty()) {
    const bool rebounds = restitution.apply(context, before, dt);
    if (restore_momentum(state, contacts) || rebounds) context.guard.discard_measurement();
  }
  context.guard.measure(state, contacts);
  if (state.overstretched) limit_speeds(state);
  context.guard.account(state, contacts, before);
  if (contacts.empty()) return;
  state.touch_changed = contacts.active.changed();
  contacts.store(state.positions);
}

/// Takes the substep with TR-BDF2, or with SDIRK2 where there is no acceleration to begin with. A second-order
/// integrator bounces where a contact or the push of a support begins or ends, or where the cord draws back a body that
/// was pushed off it. There implicit Euler goes first and BDF2 follows. Returns false, at the start of the substep, if
/// it has to be redone by implicit Euler.
bool Substeps::take_second_order(const StepContext& context, double time, double dt, const CordEnergy& before) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  if (state.accuracy.integrator == Integrator::implicit_euler || state.unlocking) return false;
  if (has_rings(state)) return false;             // they begin anew in each step: the tensions would swing by as much
  if (state.jolted && time == 0.0) return false;  // one tension for all of the jolt, by which a cord slips or does not
  const bool in_contact = !contacts.empty() && contacts.active.any();
  const bool free = !in_contact && (contacts.empty() || !will_touch(context, time, dt));
  const bool returns =
      std::any_of(state.held.begin(), state.held.end(), [](const HeldBody& held) { return held.returns; });
  if (!returns && (free || (in_contact && !state.touch_changed))) {
    const bool converged =
        free && !state.restart ? integrators_.tr_bdf2(context, time, dt) : integrators_.sdirk2(context, time, dt);
    state.restart = !free;
    const bool changed = state.supports.changed || (!contacts.empty() && contacts.changed_at(state.positions));
    if (!changed) return accept(context, converged, before);
    context.return_to_start();
  }
  state.restart = true;
  ++context.work.report.impacts;
  return accept(context, integrators_.euler_bdf2(context, time, dt), before);
}

/// Returns whether the substep converged and gained no energy. If not, it returns to the start.
bool Substeps::accept(const StepContext& context, bool converged, const CordEnergy& before) {
  if (converged && !is_thrown(context.state) && !context.gained_energy(before, EnergyGuard::tolerated_gain))
    return true;
  IslandReport& report = context.work.report;
  ++(converged ? report.energy_gains : report.fallbacks);
  context.state.restart = true;  // the acceleration of implicit Euler is of first order
  context.return_to_start();
  return false;
}

/// Takes the substep with implicit Euler. Where nothing may touch or slip, or with a large budget of work, it is halved
/// if it does not converge. Returns false if it is not solved.
bool Substeps::take_damped(const StepContext& context, double time, double dt, const CordEnergy& before) {
  IslandState& state = context.state;
  const bool may_slip =
      std::any_of(state.held.begin(), state.held.end(), [](const HeldBody& b) { return b.may_slip(); });
  const double tolerance = state.tolerance;
  const bool solved = (context.contacts.empty() && !may_slip) || context.work.has_large_budget()
                          ? take_halved(context, time, dt, before)
                          : take_whole(context, time, dt, before);
  state.tolerance = tolerance;
  return solved;
}

/// If a smaller tolerance does not help, or if there is not enough work left for it, what the usual one leaves is kept.
bool Substeps::take_whole(const StepContext& context, double time, double dt, const CordEnergy& before) {
  const double usual = context.state.tolerance;
  const auto is_solved = [&] {
    return !context.work.attempt_is_over() && Integrators::implicit_euler(context, time, dt) &&
           !is_thrown(context.state);
  };
  if (!is_solved()) return false;
  if (!context.gained_energy(before, retried_gain)) return true;
  if (context.work.attempt_is_over(retry_share)) return !context.gained_energy(before, gross_gain);
  for (const double tolerance : {smaller_tolerance(context.state), usual}) {
    begin_retry(context, tolerance);
    if (is_solved() && !context.gained_energy(before, gross_gain)) return true;
  }
  return false;
}

/// In the end all of the substep is redone by halves.
bool Substeps::take_halved(const StepContext& context, double time, double dt, const CordEnergy& before) {
  for (int k = 0;; ++k) {
    const bool solved =
        (k != max_tighter_retries && Integrators::implicit_euler(context, time, dt)) || halve(context, time, dt);
    const double tolerated = k == 0 ? retried_gain : gross_gain;
    if ((!solved && !context.state.keeps_unsolved) || !context.gained_energy(before, tolerated)) return solved;
    if (k == max_tighter_retries || context.work.halving_is_over(context.state.unlocking)) return false;
    begin_retry(context, smaller_tolerance(context.state));
  }
}

/// Redoes the substep by halves. Returns false if part of it is not solved.
bool Substeps::halve(const StepContext& context, double time, double dt) {
  context.return_to_start();
  ++context.work.report.halvings;
  whole_ = context.state.start;
  Halving halving{time, context.work.report.iterations};
  const bool solved = take_halves(context, time, dt, 1, halving);
  context.state.start = whole_;
  return solved;
}

/// Takes implicit Euler in two halves, each of which is halved again where it does not converge. Returns false if that
/// does not help: in the midst of the substep, unless such parts are kept.
bool Substeps::take_halves(const StepContext& context, double time, double dt, int depth, Halving& halving) {
  StepWork& work = context.work;
  for (const double from : {time, time + 0.5 * dt}) {
    context.begin_substep(from, 0.5 * dt);
    if (Integrators::implicit_euler(context, from, 0.5 * dt)) continue;
    if (depth >= (from == halving.time ? max_first_halvings : max_halvings) ||
        work.report.iterations - halving.iterations > (halving.solved ? max_halved_work : max_unsolved_work) ||
        work.halving_is_over(context.state.unlocking)) {
      halving.solved = false;
      if (!context.state.keeps_unsolved) return false;
      continue;
    }
    context.return_to_start();
    ++work.report.halvings;
    if (!take_halves(context, from, 0.5 * dt, depth + 1, halving) && !context.state.keeps_unsolved) return false;
  }
  return halving.solved;
}

}  // namespace ribbon
