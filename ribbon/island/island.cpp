#include "ribbon/island/island.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "ribbon/geometry/rotation.h"

// How a step begins and ends: what the cords have, who drives and holds them, and what they and the bodies get back.

namespace ribbon {
namespace {

constexpr double same_velocity = 1e-5;       // m/s or rad/s, and as a share, that single precision explains
constexpr double loosest_share = 0.2;        // of a link, above which no tolerance is taken
constexpr double resolved_digits = 16.0;     // in roundings of the largest coordinate, below which none is
constexpr double posed_widening = 2.0;       // of the room, where contacts are posed once
constexpr double posed_near_widening = 8.0;  // the same near by along an outline
constexpr double noise_share = 0.1;          // of the tolerance, that a point may move in a step without meaning it

Accuracy sharper(const Accuracy& a, const Accuracy& b) {
  return {a.integrator == Integrator::tr_bdf2 ? a.integrator : b.integrator,
          std::max(a.substeps, b.substeps),
          std::max(a.max_iterations, b.max_iterations),
          std::min(a.tolerance, b.tolerance),
          std::max(a.max_work, b.max_work),
          a.soft_contacts && b.soft_contacts};
}

}  // namespace

CordReport Island::step(std::span<const IslandCord> cords, std::span<RigidBody> bodies, double dt, Vec2 gravity) {
  assert(dt > 0.0 && dt <= 1.0 && is_finite(gravity));
  gravity_ = gravity;
  step_dt_ = dt;
  rigid_ = bodies;
  CordReport report;
  if (sleep_on(cords)) return report;
  widenings_.assign(cords.size(), 1.0);
  near_widenings_.assign(cords.size(), 1.0);
  poses_ = false;
  for (;;) {
    begin_step(cords, dt);
    before_take_ = report;
    if (take_substeps(dt, report) && !widen()) break;
    unwind();
  }
  report.work += contacts_.take_visits();
  finish_step(dt, report);
  count_rest(dt, report);
  return report;
}

/// False if its contacts have to be posed once: then all of the step is taken again so, and looks for them further off,
/// for that is not to be taken again often.
bool Island::take_substeps(double dt, CordReport& report) {
  if (poses_) {
    posed_step(dt, report);
    return true;
  }
  const double substep_dt = dt / accuracy_.substeps;
  for (int n = 0; n < accuracy_.substeps; ++n) {
    if (substep(n * substep_dt, substep_dt, report)) continue;
    poses_ = true;
    for (double& widening : widenings_) widening = std::max(widening, posed_widening);
    for (double& widening : near_widenings_) widening = std::max(widening, posed_near_widening);
    return false;
  }
  return true;
}

void Island::begin_step(std::span<const IslandCord> cords, double dt) {
  driven_ = winding_ = unlocking_ = restart_ = false;
  ledger_ = 0.0;
  balance_ = 0.0;
  has_fill_order_ = false;
  members_.clear();
  bodies_.clear();
  held_.clear();
  count_ = 0;
  duals_ = 0;
  std::size_t tensions = 0;
  accuracy_ = cords[0].cord->def_.accuracy;
  for (const IslandCord& cord : cords) {
    const std::size_t size = cord.cord->count();
    members_.push_back(
        {cord.cord, cord.met, count_, size, tensions, cord.cord->tensions_.size(), duals_, 0, 0, cord.id});
    duals_ += cord.cord->elasticity_->dual_count();
    count_ += size;
    tensions += cord.cord->tensions_.size();
    accuracy_ = sharper(accuracy_, cord.cord->def_.accuracy);
  }
  set_sizes(count_, tensions);
  for (const Member& member : members_) take_over(member);
  find_tolerance();
  for (Member& member : members_) {
    drive_points(member, dt);
    take_hold(member);
    member.mass = pressing_mass(member);
    wind(member, dt);
    member.cord->include_damping();
    std::copy(member.cord->tensions_.begin(), member.cord->tensions_.end(),
              tensions_.begin() + static_cast<std::ptrdiff_t>(member.first_tension));
    unlocking_ = member.cord->elasticity_->unlock(member.cord->positions_) || unlocking_;
  }
  find_contacts(dt);
  set_sizes(count_ + 2 * bodies_.size(), tensions + 2 * held_.size());
  place_bodies();
  for (const Member& member : members_) remember_bodies(member);
  together_ = !is_alone();
  if (meets_) step_start_ = positions_;
  if (meets_ || together_) {
    limited_.reserve(2 * contacts_.capacity() + held_.capacity());
    load_.reserve(positions_.capacity() + duals_ + held_.capacity());
    solved_positions_.reserve(positions_.capacity());
    solved_tensions_.reserve(tensions_.capacity());
    solved_held_.reserve(held_.capacity());
  }
  driven_ = driven_ || (unlocking_ && !poses_);
  double mass = 0.0;
  double longest = 0.0;
  for (const Member& member : members_) longest = std::max(longest, member.cord->def_.length);
  for (std::size_t p = 0; p < count_; ++p) mass += masses_[p];
  for (std::size_t k = 0; k < bodies_.size(); ++k) mass += masses_[center(k)];
  const double noise = noise_share * tolerance_ / step_dt_;
  weight_scale_ = mass * (length(gravity_) * longest + noise * noise);
}

/// Whether it is one cord of which every body holds another point, so that its own elasticity can do the solve.
bool Island::is_alone() const {
  if (members_.size() != 1 || held_.size() != bodies_.size()) return false;
  for (std::size_t k = 0; k < held_.size(); ++k) {
    if (held_[k].body != k || !held_[k].is_plain() || rigid_[at(held_[k].rigid)].inverse_mass == 0.0) return false;
    if (k > 0 && held_[k].point <= held_[k - 1].point) return false;
  }
  return true;
}

/// Makes every array long enough.
void Island::set_sizes(std::size_t slots, std::size_t tensions) {
  for (auto* all : {&positions_, &velocities_, &accelerations_, &x0_, &v0_, &x_start_, &v_start_, &x1_, &v1_,
                    &predicted_, &velocity_, &guess_, &force_, &direction_, &trial_, &starts_, &drives_, &best_}) {
    all->resize(slots);
  }
  for (auto* all :
       {&tensions_, &tension0_, &tension_start_, &tension_guess_, &next_, &most_tensions_, &best_tensions_}) {
    all->resize(tensions);
  }
  masses_.resize(slots);
  inertia_.resize(slots);
  constrained_.resize(slots);
  groups_.resize(slots);
  group_shares_.resize(slots);
  held_steps_.resize(held_.size());
  carried_.resize(held_.size());
}

void Island::reserve(const Cord& cord, std::size_t grips) {
  const std::size_t slots = cord.count() + 2 * grips;
  held_.reserve(grips);
  bodies_.reserve(grips);
  held_steps_.reserve(grips);
  carried_.reserve(grips);
  members_.reserve(1);
  widenings_.reserve(1);
  near_widenings_.reserve(1);
  set_sizes(slots, cord.tensions_.size() + 2 * grips);
}

void Island::take_over(const Member& member) {
  Cord& cord = *member.cord;
  cord.exclude_damping();
  const auto to = static_cast<std::ptrdiff_t>(member.first);
  std::copy(cord.positions_.begin(), cord.positions_.end(), positions_.begin() + to);
  std::copy(cord.velocities_.begin(), cord.velocities_.end(), velocities_.begin() + to);
  std::copy(cord.accelerations_.begin(), cord.accelerations_.end(), accelerations_.begin() + to);
  std::copy(cord.masses_.begin(), cord.masses_.end(), masses_.begin() + to);
  ledger_ += cord.regainable_energy_;
  balance_ += cord.energy_drift_;
  restart_ = restart_ || cord.restart_;
}

/// A tolerance above a fifth of a link would not hold it, one below what a coordinate can resolve could not be met.
void Island::find_tolerance() {
  tolerance_ = accuracy_.tolerance;
  least_tolerance_ = 0.0;
  for (const Member& member : members_) {
    const Cord& cord = *member.cord;
    const Vec2 x = cord.positions_[0];
    const double largest = std::abs(x.x) + std::abs(x.y) + cord.def_.length;  // of a coordinate, about
    least_tolerance_ = std::max(least_tolerance_, resolved_digits * std::numeric_limits<double>::epsilon() * largest);
    double shortest = cord.def_.length / (cord.def_.points - 1);
    for (std::size_t e = 0; e < cord.reel_targets_.size(); ++e) {
      shortest = std::min({shortest, cord.rest_lengths_[e], cord.reel_targets_[e]});
    }
    tolerance_ = std::min(tolerance_, loosest_share * shortest);
  }
  tolerance_ = std::max(tolerance_, least_tolerance_);
}

void Island::drive_points(const Member& member, double dt) {
  for (std::size_t i = 0; i < member.count; ++i) {
    const std::size_t p = member.first + i;
    constrained_[p] = member.cord->kinds_[i] == PointKind::free ? 0 : 1;
    if (constrained_[p] != 0) drive(p, (1.0 / dt) * (member.cord->targets_[i] - positions_[p]));
  }
}

void Island::drive(std::size_t p, Vec2 velocity) {
  constrained_[p] = 1;
  starts_[p] = positions_[p];
  drives_[p] = velocity;
  driven_ = driven_ || !(drives_[p] == Vec2{});
  restart_ = restart_ || !(velocities_[p] == drives_[p]);
  velocities_[p] = drives_[p];
}

/// Which of the island's bodies this one is; one more, if it is new.
std::size_t Island::body_slot(int index) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k].index == index) return k;
  }
  const RigidBody& body = rigid_[at(index)];
  bodies_.push_back({index, body.inverse_inertia > 0.0, body.acceleration});
  return bodies_.size() - 1;
}

void Island::place_bodies() {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const RigidBody& body = rigid_[at(bodies_[k].index)];
    positions_[center(k)] = body.position;
    positions_[angle(k)] = {};
    velocities_[center(k)] = body.velocity + body.inverse_mass * body.impulse;
    velocities_[angle(k)] = {body.angular_velocity + body.inverse_inertia * body.angular_impulse, 0.0};
    accelerations_[center(k)] = {};
    accelerations_[angle(k)] = {};
    const bool led = body.inverse_mass == 0.0;
    masses_[center(k)] = led ? 0.0 : 1.0 / body.inverse_mass;
    masses_[angle(k)] = led ? 0.0 : bodies_[k].turns ? 1.0 / body.inverse_inertia : 1.0;
    constrained_[center(k)] = led ? 1 : 0;
    constrained_[angle(k)] = led || !bodies_[k].turns ? 1 : 0;
    for (const std::size_t slot : {center(k), angle(k)}) {
      starts_[slot] = positions_[slot];
      drives_[slot] = velocities_[slot];
    }
    driven_ = driven_ || (led && !(body.velocity == Vec2{} && body.angular_velocity == 0.0));
  }
}

/// The acceleration of a body that held the same point in the last step. Another velocity than it was left with, by
/// something else it met, makes it worthless.
void Island::remember_bodies(const Member& member) {
  const auto& holders = member.cord->holders_;
  restart_ = restart_ || holders.size() != member.last_hold - member.first_hold;
  for (std::size_t k = member.first_hold; k < member.last_hold && !restart_; ++k) {
    const Cord::Holder& before = holders[k - member.first_hold];
    const std::size_t body = held_[k].body;
    accelerations_[center(body)] = before.acceleration;
    accelerations_[angle(body)] = {before.angular_acceleration, 0.0};
    const double jump = length(velocities_[center(body)] - before.velocity);
    const double turn = std::abs(velocities_[angle(body)].x - before.turning);
    restart_ = at(before.point) + member.first != held_[k].point ||
               jump > same_velocity * (1.0 + length(before.velocity)) ||
               turn > same_velocity * (1.0 + std::abs(before.turning));
  }
}

/// Where the reels take the links' rest lengths in this step. One that arrives makes its speed jump.
void Island::wind(const Member& member, double dt) {
  Cord& cord = *member.cord;
  bool winding = false;
  for (std::size_t e = 0; e < cord.reel_targets_.size(); ++e) {
    const double left = cord.reel_targets_[e] - cord.rest_lengths_[e];
    const double most = cord.reel_speeds_[e] * dt;
    cord.reel_start_[e] = cord.rest_lengths_[e];
    cord.reel_end_[e] =
        std::abs(left) <= most ? cord.reel_targets_[e] : cord.rest_lengths_[e] + std::copysign(most, left);
    winding = winding || left != 0.0;
    restart_ = restart_ || (left != 0.0 && std::abs(left) <= most);
  }
  winding_ = winding_ || winding;
  driven_ = driven_ || winding;
}

/// Reels go back to where the step began.
void Island::unwind() {
  for (const Member& member : members_) {
    if (!member.cord->reel_targets_.empty()) member.cord->rest_lengths_ = member.cord->reel_start_;
  }
}

void Island::finish_step(double dt, CordReport& report) {
  if (unlocking_) ++report.unlocked;
  if (together_) slip();
  for (const Member& member : members_) finish_member(member);
  remember_contacts();
  let_go(dt);
}

void Island::finish_member(const Member& member) {
  Cord& cord = *member.cord;
  const auto from = static_cast<std::ptrdiff_t>(member.first);
  const auto to = from + static_cast<std::ptrdiff_t>(member.count);
  std::copy(positions_.begin() + from, positions_.begin() + to, cord.positions_.begin());
  std::copy(velocities_.begin() + from, velocities_.begin() + to, cord.velocities_.begin());
  std::copy(accelerations_.begin() + from, accelerations_.begin() + to, cord.accelerations_.begin());
  const auto tension = tensions_.begin() + static_cast<std::ptrdiff_t>(member.first_tension);
  std::copy(tension, tension + static_cast<std::ptrdiff_t>(member.tensions), cord.tensions_.begin());
  for (std::size_t p = 0; p < member.count; ++p) {
    if (cord.kinds_[p] != PointKind::free) cord.positions_[p] = cord.targets_[p];  // to the last bit
  }
  // Energies beyond all numbers leave none that a state could have.
  const auto share = [this](double all) {
    return std::isfinite(all) ? all / static_cast<double>(members_.size()) : 0.0;
  };
  cord.regainable_energy_ = share(ledger_);
  cord.energy_drift_ = share(balance_);
  cord.restart_ = restart_;
  cord.sweep_.reset();
  for (std::size_t e = 0; e < cord.reel_targets_.size(); ++e) {
    cord.restart_ =
        cord.restart_ || (cord.reel_end_[e] == cord.reel_targets_[e] && cord.reel_start_[e] != cord.reel_end_[e]);
  }
  if (!cord.reel_targets_.empty()) {
    cord.rest_lengths_ = cord.reel_end_;
    cord.elasticity_->set_rest_lengths(cord.rest_lengths_);
  }
  cord.holders_.clear();
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k) {
    const std::size_t body = held_[k].body;
    cord.holders_.push_back({static_cast<int>(held_[k].point - member.first), velocities_[center(body)],
                             velocities_[angle(body)].x, accelerations_[center(body)], accelerations_[angle(body)].x,
                             static_cast<int>(held_[k].grip), pull_of(k, step_dt_), held_[k].slid});
  }
  if (!unlocking_) return;
  cord.exclude_damping();
  damp_deformation(member);
  cord.restart_ = true;
}

/// Tells the bodies how they moved, and gives them what took them there.
void Island::let_go(double dt) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    RigidBody& body = rigid_[at(bodies_[k].index)];
    if (body.inverse_mass == 0.0) continue;
    const Vec2 velocity = velocities_[center(k)];
    const double turning = velocities_[angle(k)].x;
    body.impulse = (1.0 / body.inverse_mass) * (velocity - body.velocity - dt * body.acceleration);
    if (bodies_[k].turns) body.angular_impulse = (turning - body.angular_velocity) / body.inverse_inertia;
    body.moved = positions_[center(k)] - body.position;
    body.turned = positions_[angle(k)].x;
    body.met = true;
  }
}

/// What crushed or turned cells give back when they open would go on as a swing: half the velocity at which the free
/// points deform is taken away, and none of that at which they move and turn as one.
void Island::damp_deformation(const Member& member) {
  Cord& cord = *member.cord;
  double mass = 0.0;
  Vec2 middle;
  Vec2 momentum;
  for (std::size_t p = 0; p < member.count; ++p) {
    mass += cord.masses_[p];
    middle += cord.masses_[p] * cord.positions_[p];
    momentum += cord.masses_[p] * cord.velocities_[p];
  }
  middle = (1.0 / mass) * middle;
  const Vec2 mean = (1.0 / mass) * momentum;
  double inertia = 0.0;
  double spin = 0.0;
  for (std::size_t p = 0; p < member.count; ++p) {
    const Vec2 arm = cord.positions_[p] - middle;
    inertia += cord.masses_[p] * dot(arm, arm);
    spin += cord.masses_[p] * cross(arm, cord.velocities_[p]);
  }
  const double turning = inertia > 0.0 ? spin / inertia : 0.0;
  for (std::size_t p = 0; p < member.count; ++p) {
    if (constrained_[member.first + p] != 0) continue;
    const Vec2 rigid = mean + turning * perp(cord.positions_[p] - middle);
    cord.velocities_[p] = 0.5 * (cord.velocities_[p] + rigid);
  }
}

}  // namespace ribbon
