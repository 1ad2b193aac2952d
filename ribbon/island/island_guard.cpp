#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ribbon/island/island.h"

// The guard of energy, lengths and momentum: what a substep may not have gained or lost, and how it is taken back.

namespace ribbon {
namespace {

// Of the scene's energy, M·g·L or what moves and is stretched if that is more, besides what a cord may gain in all:
// what it may take back of recent losses, and how much of those is forgotten a substep.
constexpr double kept_gain = 5e-7;  // more than it ever had, that is left to it,
constexpr double slow_gain = 1e-8;  // and may still grow by in a substep, as its order lets a smooth motion do
constexpr double returnable_share = 2e-3;
constexpr double ledger_decay = 0.9;

constexpr int most_backs = 6;           // times that a posed piece goes half of its way back
constexpr double unsolved_gain = 1e-3;  // of the scene's energy, that it may not have gained
constexpr double most_stretch = 5e-3;   // of an inextensible link, as little as it may be stretched then

}  // namespace

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

/// The last resort where what came from nowhere in a posed piece is not in velocities: back the way that it came, by
/// halves, and in the end to where it was. Of what is driven no more is known than that nothing should be faster than
/// anything was. True if something was taken back.
bool Island::go_back(const Energy& before) {
  if (driven_) return limit_speeds();
  if (most_stretched(x0_) > most_stretch) return false;
  const auto is_whole = [&] { return !gained_energy(before, unsolved_gain) && !is_stretched(); };
  if (is_whole()) return false;
  x1_ = positions_;
  v1_ = velocities_;
  contacts_.pose_none();
  double share = 1.0;
  for (int k = 0; k < most_backs; ++k) {
    share = k + 1 < most_backs ? 0.5 * share : 0.0;
    go_to_start(share);
    if (is_whole()) break;
  }
  return true;
}

/// To a share of the way from the start of the piece to x1_, with that share of v1_. The elastic tensions change by as
/// much as those of the shape do: what a piece begins with after one that was not solved is not the shape's own.
void Island::go_to_start(double share) {
  positions_ = x0_;
  velocities_ = v0_;
  tensions_ = tension0_;
  add_damping(-1.0);
  best_tensions_ = tensions_;
  find_tensions();
  for (std::size_t e = 0; e < tensions_.size(); ++e) best_tensions_[e] -= tensions_[e];
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    positions_[p] += share * (x1_[p] - x0_[p]);
    velocities_[p] = share * v1_[p];
  }
  find_tensions();
  for (const Member& member : members_) {
    for (std::size_t e = member.first_tension; e < member.first_tension + member.tensions; ++e) {
      tensions_[e] += best_tensions_[e];
      if (member.cord->def_.tension_only) tensions_[e] = std::max(0.0, tensions_[e]);
    }
  }
  add_damping(1.0);
}

/// Those of the shape alone; what grips pull with is left.
void Island::find_tensions() {
  for (const Member& member : members_) {
    member.cord->elasticity_->find_tensions(part(positions_, member.first, member.count),
                                            part(tensions_, member.first_tension, member.tensions));
  }
}

/// Whether a link of an inextensible cord is as it may not be, and what hit it was not so fast that it goes further in
/// a step than the cord is long: that is stopped by what it stretches.
bool Island::is_stretched() const {
  return most_stretched(positions_) > most_stretch && fastest_before() * step_dt_ < shortest_cord();
}

/// Whether a link of an inextensible cord has become as it may not be, so that all of it would go back.
bool Island::stretches() const { return most_stretched(positions_) > std::max(most_stretch, most_stretched(x0_)); }

/// m/s, of all that moves, when the piece began.
double Island::fastest_before() const {
  double fastest = 0.0;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (!is_angle(p)) fastest = std::max(fastest, length(v0_[p]));
    if (p < count_ && constrained_[p] != 0) fastest = std::max(fastest, length(drives_[p]));
  }
  return fastest;
}

/// m
double Island::shortest_cord() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Member& member : members_) {
    shortest =
        std::min(shortest, std::accumulate(member.cord->rest_lengths_.begin(), member.cord->rest_lengths_.end(), 0.0));
  }
  return shortest;
}

/// By how much of its length the link of an inextensible cord is off that is off most.
double Island::most_stretched(std::span<const Vec2> x) const {
  double most = 0.0;
  for (const Member& member : members_) {
    const CordDef& def = member.cord->def_;
    if (std::isfinite(def.stretch_stiffness)) continue;
    for (std::size_t link = 0; link + 1 < member.count; ++link) {
      const std::size_t p = member.first + link;
      const double strain = length(x[p + 1] - x[p]) / member.cord->rest_lengths_[link] - 1.0;
      most = std::max(most, def.tension_only ? strain : std::abs(strain));
    }
  }
  return most;
}

/// Takes what is faster than that back to it. True if something was.
bool Island::limit_speeds() {
  const double most = fastest_before() + length(gravity_) * step_dt_;
  bool any = false;
  add_damping(-1.0);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (is_angle(p) || constrained_[p] != 0) continue;
    const double speed = length(velocities_[p]);
    if (!(speed > most)) continue;
    velocities_[p] = (most / speed) * velocities_[p];
    any = true;
  }
  add_damping(1.0);
  return any;
}

}  // namespace ribbon
