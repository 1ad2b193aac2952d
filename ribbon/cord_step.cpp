#include <algorithm>
#include <cassert>
#include <cmath>

#include "ribbon/cord.h"

namespace ribbon {
namespace {

constexpr int searched_iterations = 24;  // Newton steps of a stage with a line search
constexpr int most_halves = 6;           // times a substep of implicit Euler is halved
constexpr double penalty_factor = 2.0;   // by which the exact penalty of a search is above the tensions
// Least geometric stiffness of a bar in a search, as a share of the inertia of its ends: what is pushed together has a
// negative one, and without it Newton converges slowly; two bars a point of 2·share each leave the matrix positive
// definite.
constexpr double bearable_push = -0.24;
constexpr double shortest_step = 1e-6;  // of a Newton step, below which a line search gives up
constexpr double most_motion = 1e12;    // m, of a Newton step, beyond which it is none

// Of the scene's energy, M·g·L or what moves and is stretched if that is more: what a cord may gain in all, what it may
// take back of recent losses, and how much of those is forgotten a substep.
constexpr double tolerated_gain = 5e-4;
constexpr double returnable_share = 2e-3;
constexpr double ledger_decay = 0.9;

const double sqrt2 = std::sqrt(2.0);

}  // namespace

CordReport Cord::step(double dt, Vec2 gravity) {
  assert(dt > 0.0 && dt <= 1.0 && is_finite(gravity));
  CordReport report;
  begin_step(dt, gravity);
  const double substep_dt = dt / def_.accuracy.substeps;
  for (int n = 0; n < def_.accuracy.substeps; ++n) substep(n * substep_dt, substep_dt, report);
  finish_step(report);
  return report;
}

void Cord::begin_step(double dt, Vec2 gravity) {
  gravity_ = gravity;
  step_dt_ = dt;
  driven_ = false;
  double mass = 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    mass += masses_[p];
    constrained_[p] = kinds_[p] == PointKind::free ? 0 : 1;
    if (constrained_[p] == 0) continue;
    starts_[p] = positions_[p];
    drives_[p] = (1.0 / dt) * (targets_[p] - positions_[p]);
    driven_ = driven_ || !(drives_[p] == Vec2{});
    restart_ = restart_ || !(velocities_[p] == drives_[p]);
    velocities_[p] = drives_[p];
  }
  weight_scale_ = mass * length(gravity) * def_.length;
  wind(dt);
  unlocking_ = elasticity_->unlock(positions_);
}

/// Where the reels take the links' rest lengths in this step. One that arrives makes its speed jump.
void Cord::wind(double dt) {
  winding_ = false;
  for (std::size_t e = 0; e < rest_targets_.size(); ++e) {
    const double left = rest_targets_[e] - rest_[e];
    const double most = rest_speeds_[e] * dt;
    rest_start_[e] = rest_[e];
    rest_end_[e] = std::abs(left) <= most ? rest_targets_[e] : rest_[e] + std::copysign(most, left);
    winding_ = winding_ || left != 0.0;
    arriving_ = arriving_ || (left != 0.0 && std::abs(left) <= most);
  }
  driven_ = driven_ || winding_;
  restart_ = restart_ || arriving_;
}

void Cord::finish_step(CordReport& report) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0) positions_[p] = targets_[p];  // to the last bit
  }
  if (winding_) {
    rest_ = rest_end_;
    elasticity_->set_rest_lengths(rest_);
    restart_ = restart_ || arriving_;
    arriving_ = false;
  }
  if (unlocking_) {
    ++report.unlocked;
    damp_deformation();
    restart_ = true;
  }
}

/// What crushed or turned cells give back when they open would go on as a swing: half the velocity at which the free
/// points deform is taken away, and none of that at which they move and turn as one.
void Cord::damp_deformation() {
  double mass = 0.0;
  Vec2 center;
  Vec2 momentum;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    mass += masses_[p];
    center += masses_[p] * positions_[p];
    momentum += masses_[p] * velocities_[p];
  }
  center = (1.0 / mass) * center;
  const Vec2 mean = (1.0 / mass) * momentum;
  double inertia = 0.0;
  double spin = 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    const Vec2 arm = positions_[p] - center;
    inertia += masses_[p] * dot(arm, arm);
    spin += masses_[p] * cross(arm, velocities_[p]);
  }
  const double turning = inertia > 0.0 ? spin / inertia : 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0) continue;
    const Vec2 rigid = mean + turning * perp(positions_[p] - center);
    velocities_[p] = 0.5 * (velocities_[p] + rigid);
  }
}

/// One substep from `start` on, s since the step began, and its guard: what Newton does not solve, or what gains energy
/// all the same, is taken again by implicit Euler, and that by halves.
void Cord::substep(double start, double dt, CordReport& report) {
  const Energy before = driven_ ? Energy{} : energy(gravity_);
  begin_substep();
  if (second_order(start, dt, before, report)) return;
  if (!implicit_euler(start, dt, report)) {
    return_to_start();
    ++report.halvings;
    if (!halves(start, dt, 1, report)) ++report.unconverged;
  }
  if (driven_) return;
  energy_after_ = energy(gravity_);
  account(before);
}

/// False, and back at the start, if the substep is one for implicit Euler.
bool Cord::second_order(double start, double dt, const Energy& before, CordReport& report) {
  if (def_.accuracy.integrator == Integrator::implicit_euler || unlocking_) return false;
  const bool converged = restart_ ? sdirk2(start, dt, report) : tr_bdf2(start, dt, report);
  restart_ = false;
  if (converged && !gained_energy(before)) {
    if (!driven_) account(before);
    return true;
  }
  converged ? ++report.energy_gains : ++report.fallbacks;
  restart_ = true;  // the acceleration of implicit Euler is one of first order
  return_to_start();
  return false;
}

void Cord::begin_substep() {
  x0_ = positions_;
  v0_ = velocities_;
  tension0_ = tensions_;
}

void Cord::return_to_start() {
  positions_ = x0_;
  velocities_ = v0_;
  tensions_ = tension0_;
}

/// A ledger: what waves lost they may give back in the next substeps, and beyond that a little may come from rounding
/// and the tolerance, until as much has been lost again. That is all a cord that nothing drives can ever gain.
bool Cord::gained_energy(const Energy& before) {
  if (driven_) return false;
  energy_after_ = energy(gravity_);
  return !(energy_after_.total() - before.total() <= ledger_ + tolerated_gain * energy_scale(before));
}

void Cord::account(const Energy& before) {
  const double kept = ledger_ > 0.0 ? ledger_decay * ledger_ : ledger_;
  const double scale = energy_scale(before);
  ledger_ =
      std::clamp(kept + before.total() - energy_after_.total(), -tolerated_gain * scale, returnable_share * scale);
}

double Cord::energy_scale(const Energy& energy) const {
  return std::max(weight_scale_, energy.kinetic + energy.elastic);
}

// Every stage has the form x = x̃ + q²·a, v = ṽ + q·a; x̃ is called predicted_ and ṽ velocity_. Its Newton steps begin
// where positions_ are.

/// Trapezoidal rule over γ·dt, then BDF2 over the whole, γ = 2 − √2, which gives both the same q = γ·dt/2 (Hosea &
/// Shampine 1996).
bool Cord::tr_bdf2(double start, double dt, CordReport& report) {
  const double gamma = 2.0 - sqrt2;
  const double q = 0.5 * gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + q * accelerations_[p];
    predicted_[p] = x0_[p] + q * (v0_[p] + velocity_[p]);
    positions_[p] = predicted_[p] + (q * q) * accelerations_[p];
  }
  if (!solve_stage(start + gamma * dt, q, report)) return false;
  x1_ = positions_;
  v1_ = velocities_;

  const double c1 = 1.0 / (gamma * (2.0 - gamma));
  const double c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = c1 * v1_[p] - c0 * v0_[p];
    predicted_[p] = c1 * x1_[p] - c0 * x0_[p] + q * velocity_[p];
    positions_[p] = x1_[p] + rest * v1_[p] + (0.5 * rest * rest) * accelerations_[p];
  }
  return solve_stage(start + dt, q, report);
}

/// Two implicit stages at γ·dt and dt, γ = 1 − 1/√2, stiffly accurate (Alexander 1977): of the same order, and for it
/// needs no acceleration from before, the first step after something was constrained, released, loaded or moved.
bool Cord::sdirk2(double start, double dt, CordReport& report) {
  const double gamma = 1.0 - 1.0 / sqrt2;
  const double q = gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  if (!solve_stage(start + q, q, report)) return false;
  v1_ = velocities_;

  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + rest * accelerations_[p];
    predicted_[p] = x0_[p] + rest * v1_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  return solve_stage(start + dt, q, report);
}

bool Cord::implicit_euler(double start, double dt, CordReport& report) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + dt * velocity_[p];
    positions_[p] = predicted_[p];
  }
  return solve_stage(start + dt, dt, report);
}

/// Implicit Euler by two halves, each of them halved again where it does not converge.
bool Cord::halves(double start, double dt, int depth, CordReport& report) {
  bool all = true;
  for (const double from : {start, start + 0.5 * dt}) {
    begin_substep();
    if (implicit_euler(from, 0.5 * dt, report)) continue;
    if (depth == most_halves) {
      all = false;
      continue;
    }
    return_to_start();
    ++report.halvings;
    all = halves(from, 0.5 * dt, depth + 1, report) && all;
  }
  return all;
}

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
  for (std::size_t p = 0; p < loads_.size(); ++p) force_[p] += loads_[p];
  if (def_.drag > 0.0) add_drag(q);
  guess_ = positions_;
  tension_guess_ = tensions_;
  Stage stage{q, predicted_, velocity_, inertia_, force_, constrained_};
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
  for (std::size_t p = 0; p < positions_.size(); ++p) {
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
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    const double c = def_.drag * own_mass(p);
    inertia_[p] += c / q;
    force_[p] -= c * velocity_[p];
  }
}

/// How far the point that moves most goes, m.
double Cord::furthest() const {
  double most2 = 0.0;
  for (const Vec2 step : direction_) {
    const double size2 = dot(step, step);
    if (!(size2 <= most2)) most2 = size2;  // NaN stays
  }
  return std::sqrt(most2);
}

bool Cord::full_steps(const Stage& stage, CordReport& report) {
  for (int iteration = 0; iteration < def_.accuracy.max_iterations; ++iteration) {
    ++report.iterations;
    if (!elasticity_->newton_step(stage, positions_, tensions_, direction_, next_)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    for (std::size_t p = 0; p < positions_.size(); ++p) positions_[p] += direction_[p];
    tensions_.swap(next_);
    if (moved <= def_.accuracy.tolerance) return true;
  }
  return false;
}

/// Newton's direction is one of descent, for its matrix is positive definite; each step is halved until the stage's
/// energy falls.
bool Cord::searched_steps(const Stage& stage, CordReport& report) {
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
  for (int iteration = 0; iteration < searched_iterations; ++iteration) {
    ++report.iterations;
    if (!elasticity_->newton_step(stage, positions_, tensions_, direction_, next_)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    for (std::size_t e = 0; e < next_.size(); ++e) {
      most_tensions_[e] = std::max(most_tensions_[e], penalty_factor * std::abs(next_[e]));
    }
    const double value = merit(stage, positions_);
    for (double share = 1.0;; share *= 0.5) {
      if (share < shortest_step) return false;
      for (std::size_t p = 0; p < positions_.size(); ++p) trial_[p] = positions_[p] + share * direction_[p];
      if (moved <= def_.accuracy.tolerance || merit(stage, trial_) < value) break;
    }
    positions_.swap(trial_);
    tensions_.swap(next_);
    if (moved <= def_.accuracy.tolerance) return true;
  }
  return false;
}

/// What the stage minimises, J.
double Cord::merit(const Stage& stage, std::span<const Vec2> x) {
  double sum = elasticity_->potential(stage, x, most_tensions_);
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (stage.constrained[p] != 0) continue;
    const Vec2 moved = x[p] - stage.predicted[p];
    sum += 0.5 * stage.inertia[p] * dot(moved, moved) - dot(stage.force[p], moved);
  }
  return sum;
}

}  // namespace ribbon
