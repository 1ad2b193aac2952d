#include <algorithm>
#include <cmath>

#include "ribbon/island/island.h"

// The solve of one implicit stage: Newton steps, a line search, and the bodies' part in both.

namespace ribbon {
namespace {

constexpr int searched_iterations = 24;   // Newton steps of a stage with a line search
constexpr double penalty_factor = 2.0;    // by which the exact penalty of a search is above the tensions
constexpr double shortest_step = 1e-6;    // of a Newton step, below which a line search gives up
constexpr int judging_iterations = 7;     // Newton steps in which a stage has to find out which bars are slack
constexpr double misjudged_share = 1e-6;  // of the tolerance, by which one that is nearly slack may be misjudged
constexpr double most_motion = 1e12;      // m, of a Newton step, beyond which it is none
constexpr std::size_t system_blocks = 4;  // of a matrix, a point, by which work is counted

}  // namespace

/// Everything is prepared for `time` since the step began, the state before being `from`; solved, and the state at its
/// end taken over. Solved or not, that is finite.
bool Island::solve_stage(double time, double q, std::span<const Vec2> from, CordReport& report) {
  ++report.stages;
  const double inverse_q2 = 1.0 / (q * q);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    inertia_[p] = masses_[p] * inverse_q2;
    force_[p] = masses_[p] * gravity_;
  }
  for (HeldBody& held : held_) held.share = time / step_dt_;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    force_[center(k)] = masses_[center(k)] * bodies_[k].acceleration;
    force_[angle(k)] = {};
  }
  place_driven(time);
  for (const Member& member : members_) {
    load_member(member, time, q);
    climb(member);
  }
  Stage stage{q, predicted_, velocity_, inertia_, force_, constrained_, carried_};
  stage.implicit_euler = euler_;
  const bool converged = posing_             ? posed_steps(stage, time, from, report)
                         : contacts_.empty() ? free_steps(stage, report)
                                             : touching_steps(stage, time, from, report);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    accelerations_[p] = inverse_q2 * (positions_[p] - predicted_[p]);
    velocities_[p] = velocity_[p] + q * accelerations_[p];
  }
  for (const Member& member : members_) {
    if (!euler_) break;
    member.cord->elasticity_->add_rotational_damping(stage_of(stage, member),
                                                     part(positions_, member.first, member.count),
                                                     part(tensions_, member.first_tension, member.tensions));
  }
  return converged;
}

/// Driven points go evenly from where the step found them to their targets.
void Island::place_driven(double time) {
  for (std::size_t p = 0; p < constrained_.size(); ++p) {
    if (constrained_[p] == 0) continue;
    positions_[p] = predicted_[p] = starts_[p] + time * drives_[p];
    velocity_[p] = drives_[p];
  }
}

/// What a cord alone declares: loads, drag, and rest lengths while it is reeled.
void Island::load_member(const Member& member, double time, double q) {
  Cord& cord = *member.cord;
  for (std::size_t p = 0; p < cord.loads_.size(); ++p) force_[member.first + p] += cord.loads_[p];
  if (cord.def_.drag > 0.0) add_drag(member, q);
  if (winding_ && !cord.reel_targets_.empty()) {
    const double share = time / step_dt_;
    for (std::size_t e = 0; e < cord.rest_lengths_.size(); ++e) {
      cord.rest_lengths_[e] = cord.reel_start_[e] + share * (cord.reel_end_[e] - cord.reel_start_[e]);
    }
    cord.elasticity_->set_rest_lengths(cord.rest_lengths_);
  }
}

/// The cord's own points are slowed, and not what hangs on them: −c·v = −c·ṽ − q·c·a, c = drag · mass.
void Island::add_drag(const Member& member, double q) {
  for (std::size_t i = 0; i < member.count; ++i) {
    const std::size_t p = member.first + i;
    const double c = member.cord->def_.drag * member.cord->own_masses_[i];
    inertia_[p] += c / q;
    force_[p] -= c * velocity_[p];
  }
}

bool Island::free_steps(Stage& stage, CordReport& report) {
  guess_ = positions_;
  tension_guess_ = tensions_;
  if (full_steps(stage, report)) return true;
  ++report.searches;
  positions_ = guess_;
  tensions_ = tension_guess_;
  stage.min_geometric_ratio = Stage::definite_geometric_ratio;
  return searched_steps(stage, report);
}

/// A linear system, by the blocks of its matrix that there were last.
void Island::count_system(CordReport& report) {
  ++report.iterations;
  const std::size_t band = system_blocks * count_;
  report.work += static_cast<std::int64_t>(has_pattern_ ? blocks_.size() + blocks_.off_diagonal_blocks() : band);
  report.work += contacts_.take_visits();
}

/// Whether the step's work has come to this share of what it may.
bool Island::is_spent(const CordReport& report, double share) const {
  return static_cast<double>(report.work) >= share * most_work();
}

/// What a step may take, in the unit of CordReport::work.
double Island::most_work() const {
  const double points = static_cast<double>(count_ + bodies_.size());
  return static_cast<double>(system_blocks) * points * accuracy_.max_work;
}

/// How far the point that moves most goes, m; not finite if any of it is not.
double Island::furthest() const {
  double most2 = 0.0;
  double all2 = 0.0;
  const auto take = [&](Vec2 step) {
    const double size2 = dot(step, step);
    most2 = std::max(most2, size2);
    all2 += size2;
  };
  for (const Vec2 step : std::span(direction_).first(count_)) take(step);
  for (const HeldBody& held : held_)
    take(direction_[angle(held.body)].x * perp(held.arm_at(positions_[angle(held.body)].x)));
  if (together_) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) take(direction_[center(k)]);
  }
  return std::isfinite(all2) ? std::sqrt(most2) : all2;
}

/// Where a body is follows from its point and its angle.
void Island::close_arms(std::span<Vec2> x) const {
  if (together_) return;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    x[center(k)] = x[held_[k].point] - held_[k].arm_at(x[angle(k)].x);
  }
}

bool Island::newton_step(Stage& stage) {
  return together_ || contacts_.any() ? newton_step_together(stage) : newton_step_alone(stage);
}

/// The bodies' part first, then the points', then how far the bodies turn.
bool Island::newton_step_alone(Stage& stage) {
  close_arms(positions_);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    held_steps_[k] =
        held_step(held_[k], held_[k].arm_at(positions_[angle(k)].x), inertia_[center(k)], inertia_[angle(k)],
                  stage.residual(center(k), positions_[center(k)]), stage.residual(angle(k), positions_[angle(k)]).x);
    carried_[k] = held_steps_[k].load(held_[k].point, stage.residual(center(k), positions_[center(k)]));
  }
  const Member& member = members_[0];
  const std::size_t n = member.tensions;
  if (!member.cord->elasticity_->newton_step(stage_of(stage, member), part(positions_, 0, count_),
                                             part(tensions_, 0, n), part(direction_, 0, count_), part(next_, 0, n))) {
    return false;
  }
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const double turning = held_steps_[k].turning(direction_[held_[k].point]);
    direction_[angle(k)] = {turning, 0.0};
    direction_[center(k)] = direction_[held_[k].point] - turning * held_steps_[k].u;
  }
  contacts_.update(direction_);
  return true;
}

/// A cord's part of a stage.
Stage Island::stage_of(const Stage& all, const Member& member) {
  Stage stage = all;
  stage.predicted = all.predicted.subspan(member.first, member.count);
  stage.velocity = all.velocity.subspan(member.first, member.count);
  stage.inertia = all.inertia.subspan(member.first, member.count);
  stage.force = all.force.subspan(member.first, member.count);
  stage.constrained = all.constrained.subspan(member.first, member.count);
  return stage;
}

/// From positions_ by a share of the step. Bodies go straight, so that forces are balanced and momentum is kept to the
/// last bits; the arm that this leaves open is of second order in a step below the tolerance.
void Island::move(std::span<Vec2> x, double share) const {
  for (std::size_t p = 0; p < x.size(); ++p) x[p] = positions_[p] + share * direction_[p];
}

bool Island::full_steps(Stage& stage, CordReport& report) {
  for (int iteration = 0; iteration < accuracy_.max_iterations; ++iteration) {
    count_system(report);
    if (!newton_step(stage)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    move(positions_, 1.0);
    tensions_.swap(next_);
    if (moved <= tolerance_ && !slips_ && are_bars_settled(stage, iteration)) return true;
  }
  return false;
}

/// Whether no bar was taken for slack or taut that is not, so that the last step may be the last: by and by, for where
/// nothing pulls it may be either.
bool Island::are_bars_settled(const Stage& stage, int iteration) {
  if (iteration >= judging_iterations) return true;
  for (const Member& member : members_) {
    const double way = member.cord->elasticity_->active_set_error(
        stage_of(stage, member), part(positions_, member.first, member.count),
        part(tensions_, member.first_tension, member.tensions));
    if (way > misjudged_share * tolerance_) return false;
  }
  return true;
}

/// Newton's direction is one of descent, for its matrix is positive definite; each step is halved until the stage's
/// energy falls.
bool Island::searched_steps(Stage& stage, CordReport& report) {
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
  for (int iteration = 0; iteration < searched_iterations; ++iteration) {
    count_system(report);
    if (!newton_step(stage)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    for (std::size_t e = 0; e < next_.size(); ++e) {
      most_tensions_[e] = std::max(most_tensions_[e], penalty_factor * std::abs(next_[e]));
    }
    const double value = merit(stage, positions_);
    for (double share = 1.0;; share *= 0.5) {
      if (share < shortest_step) return false;
      move(trial_, share);
      if (moved <= tolerance_) break;
      close_arms(trial_);
      if (merit(stage, trial_) < value) break;
    }
    positions_.swap(trial_);
    tensions_.swap(next_);
    if (moved <= tolerance_ && !slips_ && are_bars_settled(stage, iteration)) return true;
  }
  return false;
}

/// What the stage minimises, J.
double Island::merit(const Stage& stage, std::span<const Vec2> x) {
  double sum = 0.0;
  for (const Member& member : members_) {
    sum += member.cord->elasticity_->potential(stage_of(stage, member), x.subspan(member.first, member.count),
                                               part(most_tensions_, member.first_tension, member.tensions));
  }
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (constrained_[p] != 0) continue;
    const Vec2 moved = x[p] - predicted_[p];
    sum += 0.5 * inertia_[p] * dot(moved, moved) - dot(force_[p], moved);
  }
  if (together_ || posing_) sum += hold_potential(x);
  if (!contacts_.empty() && !posing_) sum += contacts_.potential(x);
  return sum;
}

}  // namespace ribbon
