#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/island.h"

namespace ribbon {
namespace {

constexpr int sharper_tries = 3;  // of a substep of implicit Euler that gained energy
// Newton steps in the halves of a substep, as long as all of them are solved, and once one was given up. (5,000 slack
// links on a load of 10⁶ kg turn about so much in steps of a second that they take 4,200.)
constexpr int most_work = 16000;
constexpr int most_vain_work = 4000;
// Times it is halved; and its beginning, for who was thrown apart finds his way back at once.
constexpr int most_halves = 10;
constexpr int most_first_halves = 20;

constexpr double halving_share = 0.5;  // of the work that a step may take

// Of the scene's energy, M·g·L or what moves and is stretched if that is more: what a cord may gain in all, what it may
// take back of recent losses, and how much of those is forgotten a substep.
constexpr double tolerated_gain = 5e-4;
constexpr double kept_gain = 5e-7;   // more than it ever had, that is left to it,
constexpr double slow_gain = 1e-8;   // and may still grow by in a substep, as its order lets a smooth motion do
constexpr double gross_gain = 1e-2;  // what a substep of implicit Euler may: there is nothing more damped to turn to
constexpr double returnable_share = 2e-3;
constexpr double ledger_decay = 0.9;

using std::numbers::sqrt2;

}  // namespace

/// One substep from `start` on, s since the step began, and its guard: what Newton does not solve, or what gains energy
/// all the same, is taken again by implicit Euler. False if that does not do either.
bool Island::substep(double start, double dt, CordReport& report) {
  guarded_dt_ = dt;
  begin_substep(start, dt);
  contacts_.scale_impulses(0.0);
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
  touch_changed_ = contacts_.changed();
  contacts_.finish(positions_);
  return true;
}

/// False, and back at the start, if the substep is one for implicit Euler. Where somebody begins or ceases to touch,
/// what is of second order rebounds as nothing does: there implicit Euler goes first, and BDF2 after it.
bool Island::second_order(double start, double dt, const Energy& before, CordReport& report) {
  if (accuracy_.integrator == Integrator::implicit_euler || unlocking_) return false;
  const bool touching = !contacts_.empty() && contacts_.any();
  const bool calm = !touching && (contacts_.empty() || !will_touch(start, dt));
  if (calm || (touching && !touch_changed_)) {
    const bool converged = calm && !restart_ ? tr_bdf2(start, dt, report) : sdirk2(start, dt, report);
    restart_ = !calm;
    if (contacts_.empty() || !contacts_.change(positions_)) return is_good(converged, before, report);
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
  contacts_.aim(start + dt);
  const Vec2 fall = (dt * dt) * gravity_;
  for (std::size_t p = 0; p < trial_.size(); ++p) trial_[p] = x0_[p] + dt * v0_[p] + (p < count_ ? fall : Vec2{});
  for (std::size_t k = 0; k < bodies_.size(); ++k) trial_[center(k)] += (dt * dt) * bodies_[k].acceleration;
  return contacts_.free_way(x0_, trial_, true, 1.0) < 1.0;
}

/// Implicit Euler, by halves where it does not converge and nothing may touch or slip, or there is work to spend. False
/// if that did not solve it.
bool Island::damped_substep(double start, double dt, const Energy& before, CordReport& report) {
  const bool slips = std::any_of(held_.begin(), held_.end(), [](const HeldBody& held) { return held.may_slip(); });
  if ((contacts_.empty() && !slips) || is_patient()) return halved_substep(start, dt, before, report);
  return !is_tried(report) && implicit_euler(start, dt, report) && !gained_energy(before, gross_gain);
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
    if (k == sharper_tries || is_spent(report, halving_share)) break;
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
  contacts_.place_led(start);
  contacts_.begin(positions_, (start + dt) / step_dt_);
}

void Island::return_to_start() {
  contacts_.place_led(begin_);
  contacts_.scale_impulses(0.0);
  positions_ = x0_;
  velocities_ = v0_;
  tensions_ = tension0_;
}

/// A ledger: what waves lost they may give back in the next substeps, and beyond that a little may come from rounding
/// and the tolerance, until as much has been lost again. That is all a cord that nothing drives can ever gain.
bool Island::gained_energy(const Energy& before, double tolerated) {
  if (driven_) return false;
  energy_after_ = total_energy();
  const double work = work_of_hands(guarded_dt_);
  return !(energy_after_.total() - before.total() <= ledger_ + work + tolerated * energy_scale(before));
}

/// An impact by implicit Euler takes some angular momentum of what is free, and so large a force loses digits of the
/// linear one: both are given back, to everything as one.
void Island::keep_momentum(double dt) {
  if (!contacts_.were_hit() || driven_ || contacts_.leans()) return;
  if (!is_free()) return;
  double inertia = 0.0;
  const double before = spin(x0_, v0_, inertia);
  const double after = spin(positions_, velocities_, inertia);
  const double turning = (before - after) / inertia;
  const Vec2 middle = mean(positions_);
  const Vec2 way = mean(v0_) + dt * gravity_ - mean(velocities_);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_angle(p)) {
      if (constrained_[p] == 0) velocities_[p].x += turning;
    } else {
      velocities_[p] += way + turning * perp(positions_[p] - middle);
    }
  }
}

/// Whether nothing but gravity acts on any of it from outside.
bool Island::is_free() const {
  const auto is_zero = [](char constrained) { return constrained == 0; };
  const auto falls = [this](const Body& body) { return body.acceleration == gravity_; };
  const auto is_left_alone = [](const Member& member) {
    return member.cord->loads_.empty() && member.cord->def_.drag == 0.0;
  };
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (constrained_[center(k)] != 0) return false;
  }
  return std::all_of(constrained_.begin(), constrained_.begin() + static_cast<std::ptrdiff_t>(count_), is_zero) &&
         std::all_of(members_.begin(), members_.end(), is_left_alone) &&
         std::all_of(bodies_.begin(), bodies_.end(), falls);
}

/// kg·m²/s, about the common centre of mass; sets the moment of inertia, kg·m².
double Island::spin(std::span<const Vec2> x, std::span<const Vec2> v, double& inertia) const {
  const Vec2 middle = mean(x);
  double sum = 0.0;
  inertia = 0.0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (is_angle(p)) {
      if (constrained_[p] != 0) continue;
      sum += masses_[p] * v[p].x;
      inertia += masses_[p];
    } else {
      const Vec2 arm = x[p] - middle;
      sum += masses_[p] * cross(arm, v[p]);
      inertia += masses_[p] * dot(arm, arm);
    }
  }
  return sum;
}

/// Of points and bodies by their masses.
Vec2 Island::mean(std::span<const Vec2> x) const {
  Vec2 sum;
  double mass = 0.0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (is_angle(p)) continue;
    sum += masses_[p] * x[p];
    mass += masses_[p];
  }
  return (1.0 / mass) * sum;
}

/// The last resort where nothing was solved: what energy has come from nowhere is taken out of the velocities.
void Island::calm(const Energy& before) {
  if (gained_energy(before, tolerated_gain)) slow_down(energy_after_.total() - before.total());
}

/// Takes so much energy [J] out of the velocities, or as much as there is: of what is free not out of its motion as
/// one.
void Island::slow_down(double excess) {
  double turning = 0.0;
  Vec2 way;
  const Vec2 middle = mean(positions_);
  if (is_free()) {
    double inertia = 0.0;
    turning = spin(positions_, velocities_, inertia);
    turning = inertia > 0.0 ? turning / inertia : 0.0;
    way = mean(velocities_);
  }
  const auto as_one = [&](std::size_t p) {
    return is_angle(p) ? Vec2{turning, 0.0} : way + turning * perp(positions_[p] - middle);
  };
  double kinetic = 0.0;
  for (std::size_t p = 0; p < velocities_.size(); ++p) {
    const Vec2 own = velocities_[p] - as_one(p);
    if (constrained_[p] == 0) kinetic += 0.5 * masses_[p] * dot(own, own);
  }
  const double share = kinetic > excess ? std::sqrt((kinetic - excess) / kinetic) : 0.0;
  add_damping(-1.0);
  for (std::size_t p = 0; p < velocities_.size(); ++p) {
    if (constrained_[p] == 0) velocities_[p] = as_one(p) + share * (velocities_[p] - as_one(p));
  }
  add_damping(1.0);
}

/// Takes what damping is of the tensions off, or puts it back: who changes velocities leaves the elastic part as it is.
void Island::add_damping(double sign) {
  for (const Member& member : members_) {
    if (member.cord->def_.damping == 0.0) continue;
    const Motion at{part(positions_, member.first, member.count), part(velocities_, member.first, member.count)};
    member.cord->elasticity_->add_damping(at, sign, part(tensions_, member.first_tension, member.tensions));
  }
}

void Island::account(const Energy& before) {
  const double kept = ledger_ > 0.0 ? ledger_decay * ledger_ : ledger_;
  const double scale = energy_scale(before);
  const double lost = before.total() - energy_after_.total();
  const double unexplained = lost < 0.0 ? std::min(0.0, lost + work_of_hands(guarded_dt_)) : lost;
  ledger_ = std::clamp(kept + unexplained, -tolerated_gain * scale, returnable_share * scale);
  if (contacts_.were_hit() && unexplained < 0.0) return;  // what comes out of something deep may gain
  balance_ += unexplained;
  const double excess = -balance_ - kept_gain * scale;
  if (excess <= 0.0 || unexplained > -slow_gain * scale) return;
  slow_down(excess);
  balance_ += excess;
}

Cord::Energy Island::total_energy() {
  Energy sum;
  for (const Member& member : members_) {
    const Cord& cord = *member.cord;
    const Motion at{part(positions_, member.first, member.count), part(velocities_, member.first, member.count)};
    sum.elastic += cord.elasticity_->energy(at, part(tensions_, member.first_tension, member.tensions));
    for (std::size_t p = 0; p < cord.loads_.size(); ++p) {
      sum.potential -= dot(cord.loads_[p], positions_[member.first + p]);
    }
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    sum.kinetic += 0.5 * masses_[p] * dot(velocities_[p], velocities_[p]);
  }
  for (std::size_t p = 0; p < count_; ++p) sum.potential -= masses_[p] * dot(gravity_, positions_[p]);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    sum.potential -= masses_[center(k)] * dot(bodies_[k].acceleration, positions_[center(k)]);
  }
  if (!contacts_.empty()) {
    contacts_.evaluate(positions_);
    sum.elastic += contacts_.energy();
  }
  return sum;
}

double Island::energy_scale(const Energy& energy) const {
  return std::max(weight_scale_, energy.kinetic + energy.elastic);
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
  contacts_.scale_impulses(1.0 / (gamma * (2.0 - gamma)));  // as bdf2_stage takes the first stage's velocity
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
        work > (halving.gave_up ? most_vain_work : most_work) || is_spent(report, halving_share)) {
      halving.gave_up = true;
      continue;
    }
    return_to_start();
    ++report.halvings;
    halves(from, 0.5 * dt, depth + 1, halving, report);
  }
}

}  // namespace ribbon
