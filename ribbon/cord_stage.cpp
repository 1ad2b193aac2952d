#include <algorithm>
#include <cmath>

#include "ribbon/cord.h"

// The solve of one implicit stage: Newton steps, a line search, and the bodies' part in both.

namespace ribbon {
namespace {

constexpr int searched_iterations = 24;  // Newton steps of a stage with a line search
constexpr double penalty_factor = 2.0;   // by which the exact penalty of a search is above the tensions
// Least geometric stiffness of a bar in a search, as a share of the inertia of its ends: what is pushed together has a
// negative one, and without it Newton converges slowly; two bars a point of 2·share each leave the matrix positive
// definite.
constexpr double bearable_push = -0.24;
constexpr double shortest_step = 1e-6;  // of a Newton step, below which a line search gives up
constexpr double most_motion = 1e12;    // m, of a Newton step, beyond which it is none

}  // namespace

/// Everything is prepared for `time` since the step began; solved, and the state at its end taken over. Solved or not,
/// that is finite.
bool Cord::solve_stage(double time, double q, CordReport& report) {
  ++report.stages;
  place_driven(time);
  const double inverse_q2 = 1.0 / (q * q);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    inertia_[p] = masses_[p] * inverse_q2;
    force_[p] = masses_[p] * gravity_;
  }
  for (std::size_t k = 0; k < held_.size(); ++k) {
    held_[k].share = time / step_dt_;
    force_[center(k)] = masses_[center(k)] * held_[k].acceleration;
    force_[angle(k)] = {};
  }
  for (std::size_t p = 0; p < loads_.size(); ++p) force_[p] += loads_[p];
  if (def_.drag > 0.0) add_drag(q);
  guess_ = positions_;
  tension_guess_ = tensions_;
  Stage stage{q,       points(predicted_), points(velocity_), points(inertia_), points(force_), points(constrained_),
              carried_};
  bool converged = full_steps(stage, report);
  if (!converged) {
    ++report.searches;
    positions_ = guess_;
    tensions_ = tension_guess_;
    stage.least_geometric = bearable_push;
    converged = searched_steps(stage, report);
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    accelerations_[p] = inverse_q2 * (positions_[p] - predicted_[p]);
    velocities_[p] = velocity_[p] + q * accelerations_[p];
  }
  return converged;
}

/// Driven points go evenly from where the step found them to their targets, rest lengths likewise.
void Cord::place_driven(double time) {
  for (std::size_t p = 0; p < count(); ++p) {
    if (constrained_[p] == 0) continue;
    positions_[p] = predicted_[p] = starts_[p] + time * drives_[p];
    velocity_[p] = drives_[p];
  }
  if (!winding_) return;
  const double share = time / step_dt_;
  for (std::size_t e = 0; e < rest_.size(); ++e) {
    rest_[e] = rest_start_[e] + share * (rest_end_[e] - rest_start_[e]);
  }
  elasticity_->set_rest_lengths(rest_);
}

/// The cord's own points are slowed, and not what hangs on them: −c·v = −c·ṽ − q·c·a, c = drag · mass.
void Cord::add_drag(double q) {
  for (std::size_t p = 0; p < count(); ++p) {
    const double c = def_.drag * own_mass(p);
    inertia_[p] += c / q;
    force_[p] -= c * velocity_[p];
  }
}

/// How far the point that moves most goes, m.
double Cord::furthest() const {
  double most2 = 0.0;
  const auto take = [&most2](Vec2 step) {
    const double size2 = dot(step, step);
    if (!(size2 <= most2)) most2 = size2;  // NaN stays
  };
  for (const Vec2 step : points(direction_)) take(step);
  for (std::size_t k = 0; k < held_.size(); ++k) take(direction_[angle(k)].x * held_steps_[k].u);
  return std::sqrt(most2);
}

/// Where a body is follows from its point and its angle.
void Cord::close_arms(std::span<Vec2> x) const {
  for (std::size_t k = 0; k < held_.size(); ++k) {
    x[center(k)] = x[held_[k].point] - held_[k].arm_at(x[angle(k)].x);
  }
}

/// The bodies' part first, then the points', then how far the bodies turn.
bool Cord::newton_step(Stage& stage) {
  close_arms(positions_);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const auto residual = [&](std::size_t i) { return force_[i] - inertia_[i] * (positions_[i] - predicted_[i]); };
    held_steps_[k] = held_step(held_[k], held_[k].arm_at(positions_[angle(k)].x), inertia_[center(k)],
                               inertia_[angle(k)], residual(center(k)), residual(angle(k)).x);
    carried_[k] = held_steps_[k].load(held_[k].point, residual(center(k)));
  }
  if (!elasticity_->newton_step(stage, positions(), tensions_, points(direction_), next_)) return false;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const double turning = held_steps_[k].turning(direction_[held_[k].point]);
    direction_[angle(k)] = {turning, 0.0};
    direction_[center(k)] = direction_[held_[k].point] - turning * held_steps_[k].u;
  }
  return true;
}

/// From positions_ by a share of the step. Bodies go straight, so that forces are balanced and momentum is kept to the
/// last bits; the arm that this leaves open is of second order in a step below the tolerance.
void Cord::move(std::span<Vec2> x, double share) const {
  for (std::size_t p = 0; p < x.size(); ++p) x[p] = positions_[p] + share * direction_[p];
}

bool Cord::full_steps(Stage& stage, CordReport& report) {
  for (int iteration = 0; iteration < def_.accuracy.max_iterations; ++iteration) {
    ++report.iterations;
    if (!newton_step(stage)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    move(positions_, 1.0);
    tensions_.swap(next_);
    if (moved <= tolerance_) return true;
  }
  return false;
}

/// Newton's direction is one of descent, for its matrix is positive definite; each step is halved until the stage's
/// energy falls.
bool Cord::searched_steps(Stage& stage, CordReport& report) {
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
  for (int iteration = 0; iteration < searched_iterations; ++iteration) {
    ++report.iterations;
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
    if (moved <= tolerance_) return true;
  }
  return false;
}

/// What the stage minimises, J.
double Cord::merit(const Stage& stage, std::span<const Vec2> x) {
  double sum = elasticity_->potential(stage, x.first(count()), most_tensions_);
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (constrained_[p] != 0) continue;
    const Vec2 moved = x[p] - predicted_[p];
    sum += 0.5 * inertia_[p] * dot(moved, moved) - dot(force_[p], moved);
  }
  return sum;
}

}  // namespace ribbon
