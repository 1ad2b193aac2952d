#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "ribbon/complex.h"
#include "ribbon/cord.h"

namespace ribbon {
namespace {

constexpr int sharper_tries = 3;          // of a substep of implicit Euler that gained energy
constexpr int most_work = 2000;           // Newton steps in the halves of a substep
constexpr int most_halves = 6;            // times a substep of implicit Euler is halved
constexpr double drawn_share = 0.25;      // of a link, that a point is drawn to a hand that is elsewhere in a step
constexpr double unworthy_travel = 1e-3;  // of a link, that a hand may move on its body without counting as work
constexpr double same_velocity = 1e-5;    // m/s or rad/s, and as a share, that single precision explains
constexpr double loosest_share = 0.2;     // of a link, above which no tolerance is taken
constexpr double resolved_digits = 16.0;  // in roundings of the largest coordinate, below which none is

// Of the scene's energy, M·g·L or what moves and is stretched if that is more: what a cord may gain in all, what it may
// take back of recent losses, and how much of those is forgotten a substep.
constexpr double tolerated_gain = 5e-4;
constexpr double gross_gain = 1e-2;  // what a substep of implicit Euler may: there is nothing more damped to turn to
constexpr double returnable_share = 2e-3;
constexpr double ledger_decay = 0.9;

using std::numbers::sqrt2;

}  // namespace

CordReport Cord::step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  assert(dt > 0.0 && dt <= 1.0 && is_finite(gravity));
  CordReport report;
  begin_step(dt, gravity, surroundings);
  const double substep_dt = dt / def_.accuracy.substeps;
  for (int n = 0; n < def_.accuracy.substeps; ++n) substep(n * substep_dt, substep_dt, report);
  finish_step(dt, surroundings, report);
  return report;
}

void Cord::begin_step(double dt, Vec2 gravity, const Surroundings& surroundings) {
  gravity_ = gravity;
  step_dt_ = dt;
  driven_ = false;
  find_tolerance();
  set_damping_apart();
  drive_points(dt);
  take_hold(dt, surroundings);
  wind(dt);
  put_damping_back();
  double mass = 0.0;
  for (std::size_t p = 0; p < count(); ++p) mass += masses_[p];
  for (std::size_t k = 0; k < held_.size(); ++k) mass += masses_[center(k)];
  weight_scale_ = mass * length(gravity) * def_.length;
  unlocking_ = elasticity_->unlock(positions());
  driven_ = driven_ || unlocking_;
}

/// A tolerance above a fifth of a link would not hold it, one below what a coordinate can resolve could not be met.
void Cord::find_tolerance() {
  const double largest = std::abs(positions_[0].x) + std::abs(positions_[0].y) + def_.length;  // of a coordinate, about
  least_tolerance_ = resolved_digits * std::numeric_limits<double>::epsilon() * largest;
  double shortest = def_.length / (def_.points - 1);
  for (std::size_t e = 0; e < rest_targets_.size(); ++e) shortest = std::min({shortest, rest_[e], rest_targets_[e]});
  tolerance_ = std::max(std::min(def_.accuracy.tolerance, loosest_share * shortest), least_tolerance_);
}

void Cord::drive_points(double dt) {
  for (std::size_t p = 0; p < count(); ++p) {
    constrained_[p] = kinds_[p] == PointKind::free ? 0 : 1;
    if (constrained_[p] == 0) continue;
    starts_[p] = positions_[p];
    drives_[p] = (1.0 / dt) * (targets_[p] - positions_[p]);
    driven_ = driven_ || !(drives_[p] == Vec2{});
    restart_ = restart_ || !(velocities_[p] == drives_[p]);
    velocities_[p] = drives_[p];
  }
}

/// Bodies that nothing pushes drive the points that they hold, the others are solved with the cord. One that has
/// another velocity than it was left with, by something else it met, makes the acceleration from before worthless.
void Cord::take_hold(double dt, const Surroundings& surroundings) {
  held_.clear();
  for (const Grip& grip : surroundings.grips) {
    const RigidBody& body = surroundings.bodies[slot(grip.body)];
    if (body.inverse_mass > 0.0) {
      add_holder(grip, body);
    } else if (constrained_[slot(grip.point)] == 0) {
      const std::size_t p = slot(grip.point);
      const Vec2 hand = times(rotation(dt * body.angular_velocity), grip.offset + grip.travel);
      constrained_[p] = 1;
      starts_[p] = positions_[p];
      drives_[p] = (1.0 / dt) * (body.position + dt * body.velocity + hand - positions_[p]);
      driven_ = driven_ || !(drives_[p] == Vec2{});
      restart_ = restart_ || !(velocities_[p] == drives_[p]);
      velocities_[p] = drives_[p];
    }
  }
  set_slots(held_.size());
  held_steps_.resize(held_.size());
  carried_.resize(held_.size());
  restart_ = restart_ || held_.size() != holders_.size();
  for (std::size_t k = 0; k < held_.size(); ++k) {
    const RigidBody& body = surroundings.bodies[slot(held_[k].body)];
    positions_[center(k)] = body.position;
    positions_[angle(k)] = {};
    velocities_[center(k)] = body.velocity + body.inverse_mass * body.impulse;
    velocities_[angle(k)] = {body.angular_velocity + body.inverse_inertia * body.angular_impulse, 0.0};
    masses_[center(k)] = 1.0 / body.inverse_mass;
    masses_[angle(k)] = held_[k].turns ? 1.0 / body.inverse_inertia : 1.0;
    driven_ = driven_ || length(held_[k].travel) > unworthy_travel * rest_[0];
    if (restart_) continue;
    const Holder& before = holders_[k];
    accelerations_[center(k)] = before.acceleration;
    accelerations_[angle(k)] = {before.angular_acceleration, 0.0};
    const double jump = length(velocities_[center(k)] - before.velocity);
    const double turn = std::abs(velocities_[angle(k)].x - before.turning);
    restart_ = before.point != static_cast<int>(held_[k].point) ||
               jump > same_velocity * (1.0 + length(before.velocity)) ||
               turn > same_velocity * (1.0 + std::abs(before.turning));
  }
}

/// The arm begins where the point is, so that nothing jumps, and ends at the hand, or as much nearer as a point may be
/// drawn in a step.
void Cord::add_holder(const Grip& grip, const RigidBody& body) {
  HeldBody held;
  held.point = slot(grip.point);
  held.body = grip.body;
  held.turns = body.inverse_inertia > 0.0;
  held.acceleration = body.acceleration;
  held.arm = positions_[held.point] - body.position;
  const Vec2 off = grip.offset - held.arm;
  const double most = drawn_share * rest_[0];
  held.travel = grip.travel + (length(off) > most ? (most / length(off)) * off : off);
  const auto after = std::upper_bound(held_.begin(), held_.end(), held.point,
                                      [](std::size_t point, const HeldBody& other) { return point < other.point; });
  held_.insert(after, held);
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

void Cord::finish_step(double dt, const Surroundings& surroundings, CordReport& report) {
  for (std::size_t p = 0; p < count(); ++p) {
    if (kinds_[p] != PointKind::free) positions_[p] = targets_[p];  // to the last bit
  }
  let_go(dt, surroundings);
  if (winding_) {
    rest_ = rest_end_;
    elasticity_->set_rest_lengths(rest_);
    restart_ = restart_ || arriving_;
    arriving_ = false;
  }
  if (unlocking_) {
    ++report.unlocked;
    set_damping_apart();
    damp_deformation();
    restart_ = true;
  }
}

/// Tells the bodies how they moved, and gives them what took them there.
void Cord::let_go(double dt, const Surroundings& surroundings) {
  holders_.resize(held_.size());
  for (std::size_t k = 0; k < held_.size(); ++k) {
    RigidBody& body = surroundings.bodies[slot(held_[k].body)];
    const Vec2 velocity = velocities_[center(k)];
    const double turning = velocities_[angle(k)].x;
    holders_[k] = {static_cast<int>(held_[k].point), velocity, turning, accelerations_[center(k)],
                   accelerations_[angle(k)].x};
    body.impulse = (1.0 / body.inverse_mass) * (velocity - body.velocity - dt * body.acceleration);
    if (held_[k].turns) body.angular_impulse = (turning - body.angular_velocity) / body.inverse_inertia;
    body.moved = positions_[center(k)] - body.position;
    body.turned = positions_[angle(k)].x;
  }
}

/// What crushed or turned cells give back when they open would go on as a swing: half the velocity at which the free
/// points deform is taken away, and none of that at which they move and turn as one.
void Cord::damp_deformation() {
  double mass = 0.0;
  Vec2 center;
  Vec2 momentum;
  for (std::size_t p = 0; p < count(); ++p) {
    mass += masses_[p];
    center += masses_[p] * positions_[p];
    momentum += masses_[p] * velocities_[p];
  }
  center = (1.0 / mass) * center;
  const Vec2 mean = (1.0 / mass) * momentum;
  double inertia = 0.0;
  double spin = 0.0;
  for (std::size_t p = 0; p < count(); ++p) {
    const Vec2 arm = positions_[p] - center;
    inertia += masses_[p] * dot(arm, arm);
    spin += masses_[p] * cross(arm, velocities_[p]);
  }
  const double turning = inertia > 0.0 ? spin / inertia : 0.0;
  for (std::size_t p = 0; p < count(); ++p) {
    if (constrained_[p] != 0) continue;
    const Vec2 rigid = mean + turning * perp(positions_[p] - center);
    velocities_[p] = 0.5 * (velocities_[p] + rigid);
  }
}

/// One substep from `start` on, s since the step began, and its guard: what Newton does not solve, or what gains energy
/// all the same, is taken again by implicit Euler, and that by halves.
void Cord::substep(double start, double dt, CordReport& report) {
  const Energy before = driven_ ? Energy{} : total_energy();
  begin_substep();
  if (second_order(start, dt, before, report)) return;
  if (!damped_substep(start, dt, before, report)) ++report.unconverged;
  if (driven_) return;
  energy_after_ = total_energy();
  account(before);
}

/// False, and back at the start, if the substep is one for implicit Euler.
bool Cord::second_order(double start, double dt, const Energy& before, CordReport& report) {
  if (def_.accuracy.integrator == Integrator::implicit_euler || unlocking_) return false;
  const bool converged = restart_ ? sdirk2(start, dt, report) : tr_bdf2(start, dt, report);
  restart_ = false;
  if (converged && !gained_energy(before, tolerated_gain)) {
    if (!driven_) account(before);
    return true;
  }
  converged ? ++report.energy_gains : ++report.fallbacks;
  restart_ = true;  // the acceleration of implicit Euler is one of first order
  return_to_start();
  return false;
}

/// Implicit Euler, by halves where it does not converge. Of a stiff cord what the tolerance leaves open, times a
/// tension, can be energy too: then all of it again to a hundredth of the tolerance.
bool Cord::damped_substep(double start, double dt, const Energy& before, CordReport& report) {
  const double tolerance = tolerance_;
  bool converged = false;
  for (int k = 0;; ++k) {
    converged = implicit_euler(start, dt, report);
    if (!converged) {
      return_to_start();
      ++report.halvings;
      x_start_ = x0_;
      v_start_ = v0_;
      tension_start_ = tension0_;
      converged = halves(start, dt, 1, report.iterations + most_work, report);
      x0_ = x_start_;
      v0_ = v_start_;
      tension0_ = tension_start_;
    }
    if (!gained_energy(before, gross_gain)) break;
    converged = false;
    if (k == sharper_tries) break;
    ++report.energy_gains;
    return_to_start();
    tolerance_ = std::max(1e-2 * tolerance_, least_tolerance_);
  }
  tolerance_ = tolerance;
  return converged;
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
bool Cord::gained_energy(const Energy& before, double tolerated) {
  if (driven_) return false;
  energy_after_ = total_energy();
  return !(energy_after_.total() - before.total() <= ledger_ + tolerated * energy_scale(before));
}

void Cord::account(const Energy& before) {
  const double kept = ledger_ > 0.0 ? ledger_decay * ledger_ : ledger_;
  const double scale = energy_scale(before);
  ledger_ =
      std::clamp(kept + before.total() - energy_after_.total(), -tolerated_gain * scale, returnable_share * scale);
}

Cord::Energy Cord::total_energy() const {
  Energy sum = energy(gravity_);
  for (std::size_t k = 0; k < held_.size(); ++k) {
    for (const std::size_t i : {center(k), angle(k)})
      sum.kinetic += 0.5 * masses_[i] * dot(velocities_[i], velocities_[i]);
    sum.potential -= masses_[center(k)] * dot(held_[k].acceleration, positions_[center(k)]);
  }
  return sum;
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

/// Implicit Euler by two halves, each of them halved again where it does not converge, until so many Newton steps are
/// spent.
bool Cord::halves(double start, double dt, int depth, int most_iterations, CordReport& report) {
  bool all = true;
  for (const double from : {start, start + 0.5 * dt}) {
    begin_substep();
    if (implicit_euler(from, 0.5 * dt, report)) continue;
    if (depth == most_halves || report.iterations > most_iterations) {
      all = false;
      continue;
    }
    return_to_start();
    ++report.halvings;
    all = halves(from, 0.5 * dt, depth + 1, most_iterations, report) && all;
  }
  return all;
}

}  // namespace ribbon
