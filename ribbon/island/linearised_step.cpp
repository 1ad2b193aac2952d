#include "ribbon/island/linearised_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ribbon/cord_forces.h"
#include "ribbon/island/momentum.h"

namespace ribbon {
namespace {

constexpr int max_pieces = 10;
constexpr double max_last_error = 1e-3;  // m, of the last short piece, that is kept
constexpr double lost_lengths = 10.0;    // of the longest cord, beyond which what is not solved is lost
constexpr double impact_share = 0.05;    // of the least contact distance, that anything moves in a piece with an impact

/// Returns the time until a moving body would be in a cord in free motion, s; `max` if none would. Cords in each other
/// and in what stands still do not count: a rope that is drawn tight on itself would have many such impacts in a step,
/// because nothing holds it together in free motion. While overstretched links regain their lengths, they do: what
/// caught a rope lets it go more often in short pieces of a step.
double time_to_impact(const StepContext& context, double start, double max) {
  const IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  if (contacts.empty()) return max;
  contacts.scene.anchors.place_kinematics(start);
  contacts.scene.anchors.set_kinematic_targets(start + max);
  std::vector<Vec2>& end = context.stages.trial();
  for (std::size_t p = 0; p < state.slots(); ++p) {
    Vec2 displacement = max * state.velocities[p];
    if (p < state.points) {
      if (state.constrained[p] != 0) {
        displacement = max * state.drive_velocities[p];
      } else {
        displacement += (max * max) * state.free_accelerations[p];
      }
    }
    end[p] = state.positions[p] + displacement;
  }
  return max * contacts.sweep.fraction_to_impact(contacts.scene, state.positions, end,
                                                 state.overstretched ? ImpactsOf::all : ImpactsOf::moving_bodies);
}

/// Returns the time in which nothing moves further than a small part of the least contact distance, s.
double impact_time(const StepContext& context, double max) {
  const IslandState& state = context.state;
  double highest = 0.0;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (!state.is_scalar(p)) highest = std::max(highest, length(state.velocities[p]));
  }
  const double distance = impact_share * context.contacts.scene.pairs.min_contact_distance();
  return highest * max > distance ? distance / highest : max;
}

/// Returns whether an inextensible cord was stopped, or another one that is still where the piece began. The truncated
/// solve of an extensible cord that is crushed would be taken back because of its energy.
bool leaves_hanging(const IslandState& state) {
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    if (!member.stopped) return false;
    if (!std::isfinite(member.cord->def.stretch_stiffness)) return true;
    for (std::size_t p = member.first_point; p < member.end_point(); ++p) {
      if (length(state.positions[p] - state.start.positions[p]) > state.tolerance) return false;
    }
    return true;
  });
}

}  // namespace

void LinearisedStep::take(const StepContext& context, Restitution& restitution, bool may_truncate) {
  IslandState& state = context.state;
  StepWork& work = context.work;
  ++work.report.posed;
  work.begin_linearised();
  context.begin_substep(0.0, state.dt);
  const CordEnergy before = context.energy_before();
  contact_energy_ = context.contacts.energy_of_forces();
  is_impact_ = impact_is_due_ = was_pushed_ = false;
  double time = 0.0;
  double max = state.dt;
  for (int piece = 1; time < state.dt; ++piece) {
    const double left = state.dt - time;
    const bool last = piece >= max_pieces || work.redoing_is_over();
    const double dt = last ? left : std::min(max, next_piece(context, time, left));
    if (last) is_impact_ = impact_is_due_ = false;
    const ContactSolve solve = is_impact_ ? ContactSolve::linearised_impact : ContactSolve::linearised;
    Piece taken = take_piece(context, time, dt, solve);
    const bool good = taken.solved && !taken.result.cut;
    // The rest in one piece would be stopped as all of the step was: what hangs between two hands hangs for good.
    const bool is_last_free =
        !taken.result.cut && taken.result.position_error <= max_last_error && work.redoing_is_over();
    const bool is_repeat = dt == left && (piece >= max_pieces || work.redoing_is_over());
    if (!good && !last && !is_repeat && !is_last_free) {
      context.return_to_start();
      max = 0.5 * dt;
      is_impact_ = true;  // or nothing was in the way
      impact_is_due_ = false;
      continue;
    }
    const bool hangs = !taken.solved && taken.result.cut && leaves_hanging(state);
    const bool may_be_retaken = is_lost(state, taken) || (hangs && !work.has_spent());
    if (may_truncate && may_be_retaken) taken = retake_truncated(context, time, dt);
    end_piece(context, taken, dt, restitution);
    time = dt == left ? state.dt : time + dt;
    max = state.dt - time;
  }
  if (!was_pushed_) context.guard.account(state, context.contacts, before);
}

bool LinearisedStep::take_truncated(const StepContext& context, Restitution& restitution) {
  IslandState& state = context.state;
  context.work.begin_linearised();
  context.begin_substep(0.0, state.dt);
  const CordEnergy before = context.energy_before();
  contact_energy_ = context.contacts.energy_of_forces();
  was_pushed_ = false;
  const Piece taken = take_piece(context, 0.0, state.dt, ContactSolve::truncated);
  if (!(taken.result.position_error <= NewtonSolver::max_displacement)) {
    context.return_to_start();
    return false;
  }
  end_piece(context, taken, state.dt, restitution);
  if (!was_pushed_) context.guard.account(state, context.contacts, before);
  return true;
}

/// Returns the length of the next piece, s: up to an impact, through it, or all that is left if there is none or it has
/// just been taken.
double LinearisedStep::next_piece(const StepContext& context, double time, double left) {
  if (std::exchange(is_impact_, false)) return left;
  if (!std::exchange(impact_is_due_, false)) {
    const double free = time_to_impact(context, time, left);
    impact_is_due_ = free < left;
    if (free > 0.0) return free;
  }
  impact_is_due_ = false;
  is_impact_ = true;
  return impact_time(context, left);
}

/// The tolerance of a piece is that of the step times its share of the step.
LinearisedStep::Piece LinearisedStep::take_piece(const StepContext& context, double time, double dt,
                                                 ContactSolve solve) const {
  IslandState& state = context.state;
  context.contacts.impacts.scale_impulses(0.0);
  context.begin_substep(time, dt);
  Piece piece{};
  if (!state.driven) {
    piece.before = EnergyGuard::total_energy(state, context.contacts);
    piece.before.elastic += contact_energy_ - context.contacts.energy();
  }
  piece.truncated = solve == ContactSolve::truncated;
  context.stages.set_contact_solve(solve);
  const double tolerance = state.tolerance;
  state.tolerance = std::max(dt / state.dt * tolerance, std::min(state.min_tolerance, tolerance));
  piece.solved = Integrators::implicit_euler(context, time, dt);
  state.tolerance = tolerance;
  context.stages.set_contact_solve(ContactSolve::newton);
  piece.result = context.stages.linearised_result();
  return piece;
}

/// Returns whether a piece ended far beyond all that its cords reach. Kept, it would tear them.
bool LinearisedStep::is_lost(const IslandState& state, const Piece& piece) {
  double longest = 0.0;
  for (const Member& member : state.members) longest = std::max(longest, member.cord->def.length);
  return !piece.solved && !(piece.result.position_error <= lost_lengths * longest);
}

/// Retakes a piece that is lost, or that is not solved and in which something was stopped. In the next step that would
/// find the same problem, fail at it again, and hang where it is.
LinearisedStep::Piece LinearisedStep::retake_truncated(const StepContext& context, double time, double dt) const {
  context.return_to_start();
  return take_piece(context, time, dt, ContactSolve::truncated);
}

/// Reports the piece, and ends it.
void LinearisedStep::end_piece(const StepContext& context, const Piece& piece, double dt, Restitution& restitution) {
  if (!piece.solved) {
    const double position_error = std::min(piece.result.position_error, NewtonSolver::max_displacement);
    context.report_unconverged(position_error, piece.result.force_error);
  }
  if (take_back(context, piece, dt, restitution) || piece.result.cut) ++context.work.report.cuts;
  for (Member& member : context.state.members) {
    if (piece.result.cut && member.stopped) ++member.report.cuts;
  }
}

/// The energy of linearised contacts follows from their forces. Their depths do not tell, because normals and places
/// are kept. Returns whether some of the motion was taken back.
bool LinearisedStep::take_back(const StepContext& context, const Piece& piece, double dt, Restitution& restitution) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  const bool fits_shape = piece.solved && !piece.result.cut;
  if (!piece.truncated && !fits_shape) rollback_.fit_tensions(context);
  context.guard.remove_spurious_energy(state, contacts, piece.before);
  if (piece.truncated) rollback_.fit_tensions(context);
  bool changed = rollback_.apply(context, piece.before, piece.truncated);
  if (!contacts.empty()) {
    restitution.apply(context, piece.before, dt);
    restore_momentum(state, contacts);
    if (EnergyGuard::is_pushed(state, contacts)) changed = limit_speeds(state) || changed;
  }
  if (state.overstretched) changed = limit_speeds(state) || changed;
  context.guard.discard_measurement();
  context.guard.measure(state, contacts);
  was_pushed_ = was_pushed_ || EnergyGuard::is_pushed(state, contacts);
  state.restart = true;
  if (contacts.empty()) return changed;
  contact_energy_ = contacts.energy();
  state.touch_changed = contacts.active.changed();
  contacts.store(state.positions);
  contacts.impacts.scale_impulses(0.0);
  return changed;
}

}  // namespace ribbon
