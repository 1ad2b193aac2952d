#include "ribbon/stage/newton_solver.h"

#include <algorithm>
#include <cmath>

#include "ribbon/system/grips.h"
#include "ribbon/system/stretch.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/wheels.h"

namespace ribbon {
namespace {

constexpr double penalty_factor = 2.0;     // slope of the exact penalty, times the tension
constexpr int judging_iterations = 7;      // in which a stage has to find out which bars are slack
constexpr double misjudged_share = 1e-6;   // of the tolerance, by which a bar that is nearly slack may be misjudged
constexpr double unexpected_share = 1e-2;  // of the tolerance, by which a support that is not loaded may move a body
constexpr int searched_iterations = 24;    // Newton steps of a stage with a line search
constexpr double free_strain = 1e-3;       // of inextensible links, the most that a solution without contacts leaves
constexpr int strict_iterations = 8;       // full Newton steps of a stage that are judged by that

/// Returns the strain that a solution may leave: more where drives, or ties of what is apart, may stretch the links.
double most_strain(const IslandState& state) { return state.driven || state.ties.apart ? max_strain : free_strain; }

}  // namespace

void NewtonSolver::resize(std::size_t slots, std::size_t tensions, std::size_t grips) {
  direction_.resize(slots);
  trial_.resize(slots);
  next_.resize(tensions);
  eliminated_.resize(tensions);
  penalty_.resize(tensions);
  held_steps_.resize(grips);
  carried_.resize(grips);
}

void NewtonSolver::reserve(std::size_t grips) {
  held_steps_.reserve(grips);
  carried_.reserve(grips);
}

bool NewtonSolver::find_direction(IslandState& state, const Stage& stage, Contacts& contacts) {
  return state.coupled || contacts.active.any() ? find_coupled_direction(state, stage, contacts)
                                                : find_single_direction(state, stage, contacts);
}

bool NewtonSolver::find_coupled_direction(IslandState& state, const Stage& stage, Contacts& contacts) {
  system_.make_pattern(state, contacts);
  supports_changed_ = find_loaded(state);
  system_.load(state, stage);
  contacts.load(state.positions, system_.matrix(), system_.right_side());
  if (!system_.solve(state)) return false;
  system_.copy_direction(direction_);
  slip_began_ = system_.update(state, stage, direction_, next_);
  contacts.take_solution(direction_);
  return true;
}

bool NewtonSolver::take_solution(IslandState& state, const Stage& stage) {
  system_.copy_direction(direction_);
  if (!std::all_of(direction_.begin(), direction_.end(), [](Vec2 v) { return is_finite(v); })) return false;
  slip_began_ = system_.update(state, stage, direction_, next_);
  return true;
}

/// First the part of the bodies, then the points, then how far the bodies turn; see HeldBody.
bool NewtonSolver::find_single_direction(IslandState& state, Stage stage, Contacts& contacts) {
  slip_began_ = supports_changed_ = false;
  close_arms(state, state.positions);
  const std::vector<Vec2>& x = state.positions;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    const std::size_t center = state.center(k);
    const std::size_t angle = state.angle(k);
    const Vec2 residual = stage.residual(center, x[center]);
    held_steps_[k] = held_step(state.held[k], state.held[k].arm_at(x[angle].x), stage.inertia[center],
                               stage.inertia[angle], residual, stage.residual(angle, x[angle]).x);
    carried_[k] = held_steps_[k].load(state.held[k].point, residual);
  }
  stage.condensed_bodies = carried_;
  const Member& member = state.members[0];
  if (!member.cord->elasticity->newton_step(
          IslandState::stage_of(stage, member), IslandState::points_of(member, x),
          IslandState::tensions_of(member, state.tensions), IslandState::points_of(member, direction_),
          IslandState::tensions_of(member, next_), IslandState::tensions_of(member, eliminated_))) {
    return false;
  }
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    const Vec2 of_point = direction_[state.held[k].point];
    const double turning = held_steps_[k].turning(of_point);
    direction_[state.angle(k)] = {turning, 0.0};
    direction_[state.center(k)] = of_point - turning * held_steps_[k].u;
  }
  contacts.take_solution(direction_);
  return true;
}

double NewtonSolver::largest_displacement(const IslandState& state) const {
  double max2 = 0.0;
  double all2 = 0.0;
  const auto include = [&](Vec2 step) {
    const double size2 = dot(step, step);
    max2 = std::max(max2, size2);
    all2 += size2;
  };
  for (const Vec2 step : std::span(direction_).first(state.points)) include(step);
  for (const HeldBody& held : state.held) {
    const std::size_t angle = state.angle(held.solved_index);
    include(direction_[angle].x * perp(held.arm_at(state.positions[angle].x)));
  }
  if (state.coupled) {
    for (std::size_t k = 0; k < state.bodies.size(); ++k) include(direction_[state.center(k)]);
    for (std::size_t k = 0; k < state.wheels.size(); ++k) include(direction_[state.groove(k)]);
  }
  return std::isfinite(all2) ? std::sqrt(max2) : all2;
}

void NewtonSolver::store_corrections(IslandState& state) const {
  for (Member& member : state.members) {
    double largest2 = 0.0;
    for (const Vec2 step : IslandState::points_of(member, direction_)) largest2 = std::max(largest2, dot(step, step));
    member.last_correction = std::min(std::sqrt(largest2), max_displacement);
  }
}

void NewtonSolver::move(const IslandState& state, std::span<Vec2> x, double fraction) const {
  for (std::size_t p = 0; p < x.size(); ++p) x[p] = state.positions[p] + fraction * direction_[p];
}

void NewtonSolver::close_arms(const IslandState& state, std::span<Vec2> x) {
  if (state.coupled) return;
  for (std::size_t k = 0; k < state.held.size(); ++k) {
    x[state.center(k)] = x[state.held[k].point] - state.held[k].arm_at(x[state.angle(k)].x);
  }
}

bool NewtonSolver::is_settled(IslandState& state, const Stage& stage, int iteration) const {
  if (!are_supports_settled(state, stage.inertia, unexpected_share * state.tolerance)) return false;
  if (iteration >= judging_iterations) return true;
  return std::none_of(state.members.begin(), state.members.end(), [&](const Member& member) {
    const double misjudged = member.cord->elasticity->active_set_error(
        IslandState::stage_of(stage, member), IslandState::points_of(member, state.positions),
        IslandState::tensions_of(member, state.tensions));
    return misjudged > misjudged_share * state.tolerance;
  });
}

void NewtonSolver::reset_penalty() { std::fill(penalty_.begin(), penalty_.end(), 0.0); }

void NewtonSolver::raise_penalty() {
  for (std::size_t e = 0; e < next_.size(); ++e) {
    penalty_[e] = std::max(penalty_[e], penalty_factor * std::abs(next_[e]));
  }
}

double NewtonSolver::potential(IslandState& state, const Stage& stage, std::span<const Vec2> x, bool with_grips) const {
  double sum = 0.0;
  for (const Member& member : state.members) {
    sum += member.cord->elasticity->potential(IslandState::stage_of(stage, member), IslandState::points_of(member, x),
                                              IslandState::tensions_of(member, penalty_));
  }
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (state.constrained[p] != 0) continue;
    const Vec2 moved = x[p] - stage.predicted[p];
    sum += 0.5 * stage.inertia[p] * dot(moved, moved) - dot(stage.force[p], moved);
    if (!stage.resistance.empty()) sum += 0.5 * dot(moved, stage.resistance[p] * moved);
  }
  sum += support_potential(state, x);
  if (!with_grips) return sum;
  return sum + grip_potential(state, penalty_, x) + wheel_potential(state, penalty_, x);
}

void FreeStage::resize(std::size_t slots, std::size_t tensions) {
  guess_.resize(slots);
  tension_guess_.resize(tensions);
}

bool FreeStage::solve(const StageContext& context, Stage& stage) {
  IslandState& state = context.state;
  guess_ = state.positions;
  tension_guess_ = state.tensions;
  if (full_steps(context, stage)) return true;
  ++context.work.report.searches;
  state.positions = guess_;
  state.tensions = tension_guess_;
  stage.min_geometric_ratio = Stage::definite_geometric_ratio;
  return searched_steps(context, stage);
}

bool FreeStage::full_steps(const StageContext& context, const Stage& stage) {
  IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  for (int iteration = 0; iteration < state.accuracy.max_iterations; ++iteration) {
    context.count_system();
    if (!newton.find_direction(state, stage, context.contacts)) return false;
    const double moved = newton.largest_displacement(state);
    if (!(moved <= NewtonSolver::max_displacement)) return false;
    newton.move(state, state.positions, 1.0);
    newton.take_tensions(state);
    const double strain = iteration < strict_iterations ? most_strain(state) : max_strain;
    if (moved <= state.tolerance && !newton.slip_began() && !became_stretched(state, strain) &&
        newton.is_settled(state, stage, iteration)) {
      return true;
    }
  }
  return false;
}

/// The matrix is positive definite, so Newton's direction is one of descent. Each step is halved until the stage's
/// energy falls.
bool FreeStage::searched_steps(const StageContext& context, const Stage& stage) {
  IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  newton.reset_penalty();
  const auto energy = [&](std::span<const Vec2> x) { return newton.potential(state, stage, x, state.coupled); };
  for (int iteration = 0; iteration < searched_iterations; ++iteration) {
    context.count_system();
    if (!newton.find_direction(state, stage, context.contacts)) return false;
    const double moved = newton.largest_displacement(state);
    if (!(moved <= NewtonSolver::max_displacement)) return false;
    newton.raise_penalty();
    const double value = energy(state.positions);
    for (double fraction = 1.0;; fraction *= 0.5) {
      if (fraction < NewtonSolver::min_fraction) return false;
      newton.move(state, newton.trial(), fraction);
      if (moved <= state.tolerance) break;
      NewtonSolver::close_arms(state, newton.trial());
      if (energy(newton.trial()) < value) break;
    }
    state.positions.swap(newton.trial());
    newton.take_tensions(state);
    if (moved <= state.tolerance && !newton.slip_began() && !became_stretched(state, most_strain(state)) &&
        newton.is_settled(state, stage, iteration)) {
      return true;
    }
  }
  return false;
}

}  // namespace ribbon
