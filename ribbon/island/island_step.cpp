#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/island/island.h"

namespace ribbon {
namespace {

constexpr int sharper_tries = 3;  // of a substep of implicit Euler that gained energy
// Newton steps in the halves of a substep, as long as all of them are solved, and once one was given up. (5,000 slack
// links on a load of 10⁶ kg turn about so much in steps of a second that they take 4,200.)
constexpr int most_halved_work = 16000;
constexpr int most_vain_work = 4000;
// Times it is halved; and its beginning, for who was thrown apart finds his way back at once.
constexpr int most_halves = 10;
constexpr int most_first_halves = 20;

constexpr double halving_share = 0.5;      // of the work that a step may take,
constexpr int most_halving_systems = 180;  // and systems, unless there is work to spend

constexpr double gross_gain = 1e-2;  // of the scene's energy, that a substep of implicit Euler may gain: there is
                                     // nothing more damped to turn to

using std::numbers::sqrt2;

}  // namespace

/// One substep from `start` on, s since the step began, and its guard: what Newton does not solve, or what gains energy
/// all the same, is taken again by implicit Euler. False if that does not do either.
bool Island::substep(double start, double dt, CordReport& report) {
  guarded_dt_ = dt;
  begin_substep(start, dt);
  contacts_.impacts.scale_impulses(0.0);
  const Energy before = driven_ ? Energy{} : total_energy();
  if (!second_order(start, dt, before, report) && !damped_substep(start, dt, before, report)) {
    if (!is_patient()) return false;
    ++report.unconverged;
    calm(before);
  }
  if (!driven_) energy_after_ = total_energy();
  if (!contacts_.empty()) {
    rebound(before, dt);
    keep_momentum(dt);
    if (!driven_) energy_after_ = total_energy();
  }
  if (!driven_) account(before);
  if (contacts_.empty()) return true;
  touch_changed_ = contacts_.active.changed();
  contacts_.store(positions_);
  return true;
}

/// False, and back at the start, if the substep is one for implicit Euler. Where somebody begins or ceases to touch,
/// what is of second order rebounds as nothing does: there implicit Euler goes first, and BDF2 after it.
bool Island::second_order(double start, double dt, const Energy& before, CordReport& report) {
  if (accuracy_.integrator == Integrator::implicit_euler || unlocking_) return false;
  const bool touching = !contacts_.empty() && contacts_.active.any();
  const bool calm = !touching && (contacts_.empty() || !will_touch(start, dt));
  if (calm || (touching && !touch_changed_)) {
    const bool converged = calm && !restart_ ? tr_bdf2(start, dt, report) : sdirk2(start, dt, report);
    restart_ = !calm;
    if (contacts_.empty() || !contacts_.changed_at(positions_)) return is_good(converged, before, report);
    return_to_start();
  }
  restart_ = true;
  ++report.impacts;
  return is_good(euler_bdf2(start, dt, report), before, report);
}

/// If not, back at the start.
bool Island::is_good(bool converged, const Energy& before, CordReport& report) {
  if (converged && !gained_energy(before, tolerated_gain)) return true;
  converged ? ++report.energy_gains : ++report.fallbacks;
  restart_ = true;  // the acceleration of implicit Euler is one of first order
  return_to_start();
  return false;
}

/// Whether somebody would touch who went on as before, and fell.
bool Island::will_touch(double start, double dt) {
  contacts_.scene.anchors.set_kinematic_targets(start + dt);
  const Vec2 fall = (dt * dt) * gravity_;
  for (std::size_t p = 0; p < trial_.size(); ++p) trial_[p] = x0_[p] + dt * v0_[p] + (p < count_ ? fall : Vec2{});
  for (std::size_t k = 0; k < bodies_.size(); ++k) trial_[center(k)] += (dt * dt) * bodies_[k].acceleration;
  return contacts_.sweep.collision_free_fraction(contacts_.scene, x0_, trial_, KinematicTime::target) < 1.0;
}

/// Implicit Euler, by halves where it does not converge and nothing may touch or slip, or there is work to spend. False
/// if that did not solve it.
bool Island::damped_substep(double start, double dt, const Energy& before, CordReport& report) {
  const bool slips = std::any_of(held_.begin(), held_.end(), [](const HeldBody& held) { return held.may_slip(); });
  if ((contacts_.empty() && !slips) || is_patient()) return halved_substep(start, dt, before, report);
  return !is_tried(report) && implicit_euler(start, dt, report) && !gained_energy(before, gross_gain);
}

/// Whether a step has taken as much as it may take by halves. Cells that turn back take what there is.
bool Island::is_halved_out(const CordReport& report) const {
  return is_spent(report, halving_share) || (!is_patient() && !unlocking_ && report.iterations >= most_halving_systems);
}

/// Of a stiff cord what the tolerance leaves open, times a tension, can be energy too: then all of it again to a
/// hundredth of the tolerance, in the end by halves.
bool Island::halved_substep(double start, double dt, const Energy& before, CordReport& report) {
  const double tolerance = tolerance_;
  bool converged = false;
  for (int k = 0;; ++k) {
    converged = k != sharper_tries && implicit_euler(start, dt, report);
    if (!converged) {
      return_to_start();
      ++report.halvings;
      x_start_ = x0_;
      v_start_ = v0_;
      tension_start_ = tension0_;
      Halving halving{start, report.iterations};
      halves(start, dt, 1, halving, report);
      converged = !halving.gave_up;
      x0_ = x_start_;
      v0_ = v_start_;
      tension0_ = tension_start_;
      begin_ = start;
    }
    if (!gained_energy(before, gross_gain)) break;
    converged = false;
    if (k == sharper_tries || is_halved_out(report)) break;
    ++report.energy_gains;
    return_to_start();
    tolerance_ = std::max(1e-2 * tolerance_, least_tolerance_);
  }
  tolerance_ = tolerance;
  return converged;
}

void Island::begin_substep(double start, double dt) {
  begin_ = start;
  x0_ = positions_;
  v0_ = velocities_;
  tension0_ = tensions_;
  if (contacts_.empty()) return;
  contacts_.scene.anchors.place_kinematics(start);
  contacts_.begin_substep(positions_, (start + dt) / step_dt_);
}

void Island::return_to_start() {
  contacts_.scene.anchors.place_kinematics(begin_);
  contacts_.impacts.scale_impulses(0.0);
  positions_ = x0_;
  velocities_ = v0_;
  tensions_ = tension0_;
}

// Every stage has the form x = x̃ + q²·a, v = ṽ + q·a; x̃ is called predicted_ and ṽ velocity_. Its Newton steps begin
// where positions_ are.

/// Trapezoidal rule over γ·dt, then BDF2 over the whole, γ = 2 − √2, which gives both the same q = γ·dt/2 (Hosea &
/// Shampine 1996).
bool Island::tr_bdf2(double start, double dt, CordReport& report) {
  const double gamma = 2.0 - sqrt2;
  const double q = 0.5 * gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + q * accelerations_[p];
    predicted_[p] = x0_[p] + q * (v0_[p] + velocity_[p]);
    positions_[p] = predicted_[p] + (q * q) * accelerations_[p];
  }
  stage_weight_ = q / (gamma * (2.0 - gamma));  // as bdf2_stage takes this stage's velocity
  return solve_stage(start + gamma * dt, q, x0_, report) && bdf2_stage(start, dt, gamma, report);
}

/// The same, its first stage by implicit Euler.
bool Island::euler_bdf2(double start, double dt, CordReport& report) {
  const double gamma = 2.0 - sqrt2;
  if (!implicit_euler(start, gamma * dt, report)) return false;
  contacts_.impacts.scale_impulses(1.0 / (gamma * (2.0 - gamma)));  // as bdf2_stage takes the first stage's velocity
  return bdf2_stage(start, dt, gamma, report);
}

/// From the start of a substep and a stage at γ·dt to its end.
bool Island::bdf2_stage(double start, double dt, double gamma, CordReport& report) {
  x1_ = positions_;
  v1_ = velocities_;
  const double q = 0.5 * gamma * dt;
  const double c1 = 1.0 / (gamma * (2.0 - gamma));
  const double c0 = (1.0 - gamma) * (1.0 - gamma) * c1;
  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = c1 * v1_[p] - c0 * v0_[p];
    predicted_[p] = c1 * x1_[p] - c0 * x0_[p] + q * velocity_[p];
    positions_[p] = x1_[p] + rest * v1_[p] + (0.5 * rest * rest) * accelerations_[p];
  }
  stage_weight_ = q;
  return solve_stage(start + dt, q, x1_, report);
}

/// Two implicit stages at γ·dt and dt, γ = 1 − 1/√2, stiffly accurate (Alexander 1977): of the same order, and for it
/// needs no acceleration from before, the first step after something was constrained, released, loaded or moved.
bool Island::sdirk2(double start, double dt, CordReport& report) {
  const double gamma = 1.0 - 1.0 / sqrt2;
  const double q = gamma * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  stage_weight_ = dt - q;
  if (!solve_stage(start + q, q, x0_, report)) return false;
  x1_ = positions_;
  v1_ = velocities_;

  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p] + rest * accelerations_[p];
    predicted_[p] = x0_[p] + rest * v1_[p] + q * velocity_[p];
    positions_[p] = predicted_[p];
  }
  stage_weight_ = q;
  return solve_stage(start + dt, q, x1_, report);
}

bool Island::implicit_euler(double start, double dt, CordReport& report) {
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    velocity_[p] = v0_[p];
    predicted_[p] = x0_[p] + dt * velocity_[p];
    positions_[p] = predicted_[p];
  }
  stage_weight_ = dt;
  euler_ = true;
  const bool converged = solve_stage(start + dt, dt, x0_, report);
  euler_ = false;
  return converged;
}

/// Implicit Euler by two halves, each of them halved again where it does not converge, until it is given up.
void Island::halves(double start, double dt, int depth, Halving& halving, CordReport& report) {
  for (const double from : {start, start + 0.5 * dt}) {
    begin_substep(from, 0.5 * dt);
    if (implicit_euler(from, 0.5 * dt, report)) continue;
    const int work = report.iterations - halving.begun;
    if (depth >= (from == halving.start ? most_first_halves : most_halves) ||
        work > (halving.gave_up ? most_vain_work : most_halved_work) || is_halved_out(report)) {
      halving.gave_up = true;
      continue;
    }
    return_to_start();
    ++report.halvings;
    halves(from, 0.5 * dt, depth + 1, halving, report);
  }
}

}  // namespace ribbon
