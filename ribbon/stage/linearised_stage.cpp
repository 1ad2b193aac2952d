#include "ribbon/stage/linearised_stage.h"

#include <algorithm>
#include <cmath>

#include "ribbon/system/grips.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/supports.h"

namespace ribbon {
namespace {

constexpr int contact_searches = 3;  // times that contacts are looked for
constexpr int max_linearisations = 24;
constexpr int impact_linearisations = 2;     // of a piece that takes an impact: no direction changes much
constexpr int miss_linearisations = 3;       // more, for each time of
constexpr int max_misses = 4;                // times that contacts are linearised which the solution would have missed
constexpr int truncated_linearisations = 4;  // at most, of a truncated solve
constexpr double shrinking = 0.5;  // of the last correction of a truncated solve, the most that the next one may be
// Tolerances: after a larger correction the next linearisation is far from the solution, while contacts are looked for.
constexpr double far_share = 0.1;
constexpr int full_linearisations = 5;  // after which a step has to reduce the energy
constexpr double min_fraction = 1.0 / 64.0;
constexpr double torn_ratio = 1e7;  // of a tension to the link's inertia times its length: more than anything possible
constexpr int length_restorations = 5;     // of cords that were stopped
constexpr int truncated_restorations = 4;  // the same in a truncated solve: more give cords of heaps energy

/// N, the largest inertia force of the direction.
double inertia_force(const StageContext& context, const Stage& stage) {
  double max = 0.0;
  for (std::size_t p = 0; p < context.state.points; ++p) {
    max = std::max(max, stage.inertia[p] * length(context.newton.direction()[p]));
  }
  return max;
}

/// Returns whether a link's tension is larger than anything possible makes it.
bool is_torn_apart(const IslandState& state, const Stage& stage) {
  return std::any_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    const double most = torn_ratio * stage.inertia[member.first_point] * member.cord->state.rest[0];
    const auto tensions = IslandState::tensions_of(member, state.tensions);
    return std::any_of(tensions.begin(), tensions.end(), [most](double tension) { return tension > most; });
  });
}

/// Returns whether something is torn apart, and the stage is now proximal because of it. Not at a wheel, which slips by
/// the tensions.
bool becomes_proximal(const StageContext& context, Stage& stage) {
  const IslandState& state = context.state;
  if (stage.is_proximal || !state.wheels.empty() || !is_torn_apart(state, stage)) return false;
  stage.is_proximal = true;
  return true;
}

/// The tensions of extensible cords are those of their shapes.
void forget_inextensible_tensions(IslandState& state) {
  for (const Member& member : state.members) {
    if (std::isfinite(member.cord->def.stretch_stiffness)) continue;
    const auto tensions = IslandState::tensions_of(member, state.tensions);
    std::fill(tensions.begin(), tensions.end(), 0.0);
  }
}

void forget_tensions(IslandState& state) { std::fill(state.tensions.begin(), state.tensions.end(), 0.0); }

}  // namespace

void LinearisedStage::resize(std::size_t slots, std::size_t tensions) {
  best_.resize(slots);
  groups_.resize(slots);
  link_lengths_.resize(slots);
  best_tensions_.resize(tensions);
}

void LinearisedStage::reserve(const IslandState& state, const Contacts& contacts) {
  solver_.reserve(2 * contacts.scene.pairs.capacity() + state.tensions.capacity() + state.held.capacity() +
                      state.supports.all.capacity(),
                  state.positions.capacity() + state.duals + state.held.capacity());
  bar_rows_.reserve(state.tensions.capacity());
  solved_positions_.reserve(state.positions.capacity());
  solved_tensions_.reserve(state.tensions.capacity());
  solved_held_.reserve(state.held.capacity());
}

LinearisedResult LinearisedStage::solve(const StageContext& context, const MotionBounds& bounds,
                                        const StageRequest& request, Stage& stage, ContactSolve kind) {
  IslandState& state = context.state;
  for (HeldBody& held : state.held) held.limited = held.may_slip();
  state.supports.are_rows = true;
  begin(context, request);
  stage.min_geometric_ratio = Stage::definite_geometric_ratio;
  stage.bars_are_rows = kind != ContactSolve::truncated;  // two active sets would not find which are slack
  Course course;
  const bool impact = kind == ContactSolve::linearised_impact;
  if (kind == ContactSolve::truncated) {
    if (becomes_proximal(context, stage)) forget_inextensible_tensions(state);
    truncate(context, request, stage, course);
  } else {
    const int max = impact ? impact_linearisations : max_linearisations;
    for (int k = 0; k < max + course.misses * miss_linearisations && !course.result.converged; ++k) {
      if (k > 0 && context.work.linearising_is_over()) break;
      if (iterate(context, request, stage, k, course) == Iteration::ended) break;
    }
    end(context, stage, course);
  }
  for (HeldBody& held : state.held) held.limited = false;
  state.supports.are_rows = false;
  LinearisedResult& result = course.result;
  if (!context.contacts.empty()) {
    result.cut = !groups_.keep_apart(context, bounds, request.from);
    if (result.cut && (kind == ContactSolve::truncated || state.wheels.empty())) {
      restore_lengths(context, bounds, request, stage,
                      kind == ContactSolve::truncated ? truncated_restorations : length_restorations);
    }
    context.contacts.record_impacts(state.positions, request.time_weight);
  }
  result.converged = result.converged || (impact && result.position_error < std::numeric_limits<double>::infinity());
  return result;
}

/// Cords begin where they were, what is driven where it ends. Contacts are first looked for along the displacement
/// without any.
void LinearisedStage::begin(const StageContext& context, const StageRequest& request) const {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  for (HeldBody& held : state.held) held.slip_sign = held.slip_force = 0.0;
  if (!contacts.empty()) {
    contacts.compliant.begin_stage(contacts.scene.pairs);
    contacts.scene.anchors.set_kinematic_targets(request.time);
    contacts.scene.anchors.advance_kinematics(1.0);
    contacts.linearised.clear();
    contacts.linearise(request.from, state.positions);
  }
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] == 0) state.positions[p] = request.from[p];
  }
  state.place_gaps(request.time);
  context.newton.reset_penalty();
}

/// One linearisation.
LinearisedStage::Iteration LinearisedStage::iterate(const StageContext& context, const StageRequest& request,
                                                    Stage& stage, int k, Course& course) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  NewtonSolver& newton = context.newton;
  LinearisedResult& result = course.result;
  const bool others =
      !contacts.empty() && k > 0 && k < contact_searches && contacts.linearise(request.from, state.positions);
  if (becomes_proximal(context, stage) && k > 0) forget_tensions(state);
  append_rows(context, stage);
  if (k >= contact_searches) {
    store_best(context, stage, course);
    if (k == full_linearisations && return_to_best(context, stage)) append_rows(context, stage);
  }
  const bool far = k < contact_searches && result.position_error > far_share * state.tolerance;
  // Where active sets did not lead to the solution, they do next time in one of eight linearisations, up to the first
  // one with contacts that are fixed, and in two of three after it.
  const bool sets_will_fail =
      k > 0 && k <= contact_searches && solver_.last_method() == ConvexSolver::Method::interior_point;
  const auto first = sets_will_fail ? ConvexSolver::Method::interior_point : ConvexSolver::Method::active_sets;
  const ConvexSolver::Result solved = solver_.solve(context, stage, far, first);
  if (solved == ConvexSolver::Result::failed) {
    // The tensions of what was torn apart make a matrix that is definite in no precision: once without them.
    if (k > 0) return Iteration::ended;
    forget_tensions(state);
    return Iteration::next;
  }
  result.position_error = newton.largest_displacement(state);
  if (!(result.position_error <= NewtonSolver::max_displacement)) return Iteration::ended;
  result.force_error = inertia_force(context, stage);
  newton.store_corrections(state);
  bar_rows_.take(solver_.rows(), newton.next_tensions());
  newton.raise_penalty();
  const double fraction = k < full_linearisations ? 1.0 : step_fraction(context, stage);
  result.converged = k > 0 && result.position_error <= state.tolerance && solved == ConvexSolver::Result::exact &&
                     !newton.slip_began() && !others;
  if (fraction == 0.0) return Iteration::ended;  // nearer to the solution than the energy can tell, or stuck
  newton.move(state, newton.trial(), fraction);
  state.positions.swap(newton.trial());
  newton.take_tensions(state);
  if (!contacts.empty()) contacts.take_forces(solver_.rows(), k < contact_searches);
  take_slip_rows(state, solver_.rows());
  settle(context, request, course);
  return Iteration::next;
}

/// Linearises until the correction is within the tolerance, but not often. Contacts and limits of friction are found
/// anew each time. Without a solution the position error is infinite.
void LinearisedStage::truncate(const StageContext& context, const StageRequest& request, const Stage& stage,
                               Course& course) {
  IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  LinearisedResult& result = course.result;
  double moved = 0.0;  // m, by the last linearisation
  for (int k = 0; k < truncated_linearisations && !result.converged; ++k) {
    if (k > 0) context.contacts.linearise(request.from, state.positions);
    append_rows(context, stage);
    const bool solved = solver_.solve_truncated(context, stage);
    result.position_error = solved ? newton.largest_displacement(state) : std::numeric_limits<double>::infinity();
    if (!(result.position_error <= NewtonSolver::max_displacement)) return;
    result.force_error = inertia_force(context, stage);
    newton.store_corrections(state);
    const double max = k > 0 ? std::max(shrinking * moved, state.tolerance) : result.position_error;
    moved = std::min(max, result.position_error);
    newton.move(state, newton.trial(), moved < result.position_error ? moved / result.position_error : 1.0);
    state.positions.swap(newton.trial());
    link_lengths_.restore(state, stage.inertia);
    if (moved < result.position_error) continue;
    newton.take_tensions(state);
    context.contacts.take_forces(solver_.rows(), true);
    take_slip_rows(state, solver_.rows());
    result.converged = k > 0 && result.position_error <= state.tolerance && !became_stretched(state);
  }
}

/// Judges whether the iterate is the solution. If contacts are missed in it, they are linearised and the solve goes on.
void LinearisedStage::settle(const StageContext& context, const StageRequest& request, Course& course) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  course.result.converged = course.result.converged && !became_stretched(state);
  if (!course.result.converged || course.misses >= max_misses || contacts.empty()) return;
  store_solved(context);
  if (!contacts.linearise_missed(request.from, state.positions, state.tolerance)) return;
  ++course.misses;
  course.result.converged = course.has_best = false;
}

/// If the solve did not end at a solution, returns to the last one that missed contacts, or to the best iterate. What
/// that has stretched gets its length back: otherwise the motion of its cord would be taken back. So does what the
/// tolerance has left of a stretch. Not at a wheel, where lengths are not those of links alone.
void LinearisedStage::end(const StageContext& context, const Stage& stage, Course& course) {
  IslandState& state = context.state;
  bool& converged = course.result.converged;
  if (!converged && course.misses > 0) {
    return_to_solved(context);
    converged = true;
  } else if (!converged && course.has_best) {
    append_rows(context, stage);
    return_to_best(context, stage);
  }
  const bool is_exact = converged && (state.driven || !became_stretched(state, LinkLengths::restored_strain));
  if (!is_exact && state.wheels.empty()) link_lengths_.restore(state, stage.inertia);
}

/// An inextensible cord that turns is compressed at a share of its way. Lengths that are restored may take it through
/// something again.
void LinearisedStage::restore_lengths(const StageContext& context, const MotionBounds& bounds,
                                      const StageRequest& request, const Stage& stage, int most) {
  IslandState& state = context.state;
  for (int k = 0; k < most; ++k) {
    if (largest_strain(state, state.positions) <= LinkLengths::restored_strain) return;
    link_lengths_.restore(state, stage.inertia);
    if (groups_.keep_apart(context, bounds, request.from)) return;
  }
}

/// Writes all limited rows about the current positions.
void LinearisedStage::append_rows(const StageContext& context, const Stage& stage) {
  LimitedRows& rows = solver_.rows();
  rows.clear();
  if (!context.contacts.empty()) {
    context.contacts.append_rows(context.state.positions, context.state.dt / stage.q, rows);
  }
  if (stage.bars_are_rows) bar_rows_.append(context.state, stage, rows);
  append_support_rows(context.state, rows);
  append_slip_rows(context.state, stage.inertia, rows);
}

/// Returns what the linearised problem minimises at x, J, with its rows linear about the current positions.
double LinearisedStage::energy(const StageContext& context, const Stage& stage, std::span<const Vec2> x) {
  std::vector<Vec2>& direction = context.newton.direction();
  for (std::size_t p = 0; p < x.size(); ++p) direction[p] = x[p] - context.state.positions[p];
  return context.newton.potential(context.state, stage, x, true) + solver_.rows().potential(direction, 1.0);
}

bool LinearisedStage::is_worse_than_best(const StageContext& context, const Stage& stage) {
  return !(energy(context, stage, context.state.positions) < energy(context, stage, best_));
}

void LinearisedStage::store_best(const StageContext& context, const Stage& stage, Course& course) {
  if (!course.has_best || !is_worse_than_best(context, stage)) {
    best_ = context.state.positions;
    best_tensions_ = context.state.tensions;
  }
  course.has_best = true;
}

/// Returns to the best positions, unless the current ones are better. Returns whether it did.
bool LinearisedStage::return_to_best(const StageContext& context, const Stage& stage) {
  if (!is_worse_than_best(context, stage)) return false;
  context.state.positions = best_;
  context.state.tensions = best_tensions_;
  return true;
}

/// Returns the first of 1, ½, ¼ … of the direction that reduces the energy, or 2 if that reduces it further: what is
/// crushed gets nearer to its solution by half of the distance each time. Returns 0 if none does.
double LinearisedStage::step_fraction(const StageContext& context, const Stage& stage) {
  NewtonSolver& newton = context.newton;
  const auto value = [&](double fraction) {
    newton.move(context.state, newton.trial(), fraction);
    return newton.potential(context.state, stage, newton.trial(), true) +
           solver_.rows().potential(newton.direction(), fraction);
  };
  const double before = value(0.0);
  for (double fraction = 1.0; fraction >= min_fraction; fraction *= 0.5) {
    const double after = value(fraction);
    if (!(after < before)) continue;
    return fraction == 1.0 && value(2.0) < after ? 2.0 : fraction;
  }
  return 0.0;
}

void LinearisedStage::store_solved(const StageContext& context) {
  solved_positions_ = context.state.positions;
  solved_tensions_ = context.state.tensions;
  solved_held_ = context.state.held;
  context.contacts.linearised.store(context.contacts.forces);
}

void LinearisedStage::return_to_solved(const StageContext& context) const {
  context.state.positions = solved_positions_;
  context.state.tensions = solved_tensions_;
  context.state.held = solved_held_;
  context.contacts.linearised.restore(context.contacts.forces);
}

}  // namespace ribbon
