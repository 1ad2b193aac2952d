#include "ribbon/collision/motion_bounds.h"

#include <algorithm>
#include <cmath>

#include "ribbon/collision/outline.h"
#include "ribbon/geometry/separation.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/overstretch.h"

namespace ribbon {
namespace {

constexpr double turned_share = 0.3;  // of its own displacement, by which something may be turned aside in a step
constexpr double link_share = 0.25;   // of a link, part of every bound
constexpr double near_share = 0.25;   // of a link, bound of what is near along the outline
// Enlargement of a bound that something left: as far as it went and a little more, but within these limits.
constexpr double spare = 1.5;
constexpr double min_enlargement = 2.0;
constexpr double max_enlargement = 8.0;
constexpr double max_total_enlargement = 500.0;
constexpr double linearised_enlargement = 2.0;
constexpr double linearised_near_enlargement = 8.0;
constexpr double surely_within = 0.9;  // of a bound: whatever is so near the end of its free motion has not left it
constexpr int halvings = 10;           // to find where something leaves its bound

/// Returns the speed of the fastest point of a cord, or of the fastest body that holds it, m/s.
double highest_speed(const IslandState& state, const Member& member) {
  double highest2 = 0.0;
  const auto include = [&highest2](Vec2 v) { highest2 = std::max(highest2, dot(v, v)); };
  for (const Vec2& v : IslandState::points_of(member, state.velocities)) include(v);
  for (const Grip& grip : member.surroundings.grips) include(state.rigid[at(grip.body)].velocity);
  return std::sqrt(highest2);
}

}  // namespace

double MotionBounds::bound_of(const CordParts& parts, const Surroundings& surroundings,
                              std::span<const RigidBody> bodies, double dt, Vec2 gravity) {
  const Cord::State& cord = parts.state;
  double own2 = 0.0;
  double other2 = 0.0;
  double pulled = 0.0;  // m/s²
  for (std::size_t p = 0; p < cord.loads.size(); ++p) {
    pulled = std::max(pulled, length(cord.loads[p]) / cord.masses[p]);
  }
  for (std::size_t p = 0; p < cord.positions.size(); ++p) {
    const bool is_free = cord.kinds[p] == PointKind::free;
    const Vec2 v = is_free ? cord.velocities[p] : (1.0 / dt) * (cord.targets[p] - cord.positions[p]);
    own2 = std::max(own2, dot(v, v));
  }
  const auto include = [&](int body) {
    const Vec2 v = bodies[at(body)].velocity;
    other2 = std::max(other2, dot(v, v));
  };
  for (const RigidCircle& circle : surroundings.circles) include(circle.body);
  for (const RigidSegment& segment : surroundings.segments) include(segment.body);
  const double turned = dt * (turned_share * std::sqrt(own2) + std::sqrt(other2));
  const double pull = std::min(cord.rest[0], dt * dt * pulled);  // links stop what would go further
  return link_share * cord.rest[0] +
         2.0 * dt * dt * std::max(1.0, std::abs(parts.def.gravity_scale)) * length(gravity) + turned + pull +
         dt * max_medium_push(parts, surroundings, dt, gravity).delta_v + regained_length(parts);
}

void MotionBounds::begin_step(std::size_t members) {
  bounds_.assign(members, {});
  may_stop_ = false;
}

void MotionBounds::enlarge_for_linearised() {
  may_stop_ = true;
  for (Bound& bound : bounds_) {
    bound.enlargement = std::max(bound.enlargement, linearised_enlargement);
    bound.near_enlargement = std::max(bound.near_enlargement, linearised_near_enlargement);
  }
}

void MotionBounds::find(const IslandState& state) {
  enabled_ = true;
  ends_.resize(state.points);
  for (std::size_t p = 0; p < state.points; ++p) {
    ends_[p] = state.positions[p] + state.dt * state.velocities[p];
    if (state.constrained[p] == 0) ends_[p] += (state.dt * state.dt) * state.free_accelerations[p];
  }
  body_bound_ = 0.0;
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    const Member& member = state.members[m];
    const double bound = bound_of(*member.cord, member.surroundings, state.rigid, state.dt, state.gravity);
    bounds_[m].all = bounds_[m].enlargement * bound;
    if (may_stop_) bounds_[m].all = std::max(bounds_[m].all, bound + state.dt * highest_speed(state, member));
    bounds_[m].near = bounds_[m].near_enlargement * near_share * member.cord->state.rest[0];
    body_bound_ = std::max(body_bound_, bounds_[m].all);
  }
}

Box MotionBounds::anchor_box(const IslandState& state, const RigidBody& body, Vec2 arm) const {
  const Vec2 now = body.position + arm;
  const Vec2 end = now + state.dt * (body.velocity + body.angular_velocity * perp(arm));
  const double turned = std::abs(state.dt * body.angular_velocity) + std::abs(body.pushed_turn);
  return box_around(body.start_of(arm), end,
                    0.5 * turned * turned * length(arm) + (body.inverse_mass > 0.0 ? body_bound_ : 0.0));
}

bool MotionBounds::enlarge(const IslandState& state) {
  if (!enabled_) return false;
  const double of_bodies = excess_of_bodies(state);
  bool any = false;
  const auto enlarge_by = [&any](double& enlargement, double excess) {
    if (excess <= 1.0 || enlargement > max_total_enlargement) return;
    enlargement *= excess < max_enlargement ? std::max(min_enlargement, spare * excess) : max_enlargement;
    any = true;
  };
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    enlarge_by(bounds_[m].enlargement, std::max(of_bodies, excess(state, m)));
    if (state.members[m].cord->def.self_contact) enlarge_by(bounds_[m].near_enlargement, near_excess(state, m));
  }
  return any;
}

/// Returns how far bodies have moved from the line of their free motion, as a multiple of their bound.
double MotionBounds::excess_of_bodies(const IslandState& state) const {
  double max = 0.0;
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const RigidBody& body = state.rigid_of(state.bodies[k]);
    const Vec2 end = body.position + state.dt * body.velocity;
    const double excess = find_separation(state.positions[state.center(k)], body.start(), end).distance / body_bound_;
    max = excess <= max ? max : excess;  // NaN counts as an excess
  }
  return max;
}

/// Returns the same of the points of a cord.
double MotionBounds::excess(const IslandState& state, std::size_t m) const {
  const Member& member = state.members[m];
  const double bound = bounds_[m].all;
  double max = 0.0;
  const double within2 = surely_within * surely_within * bound * bound;
  for (std::size_t p = member.first_point; p < member.end_point(); ++p) {
    const Vec2 off = state.positions[p] - ends_[p];
    if (dot(off, off) <= within2) continue;
    const double excess = find_separation(state.positions[p], start_[p], ends_[p]).distance / bound;
    max = excess <= max ? max : excess;
  }
  return max;
}

/// Returns how much further a point has moved than one near it along the outline that it may have touched, as a
/// multiple of the bound for that.
double MotionBounds::near_excess(const IslandState& state, std::size_t m) const {
  const Member& member = state.members[m];
  const std::vector<int>& outline = member.cord->outline;
  const auto off = [&](std::size_t k) {
    const std::size_t p = member.first_point + at(outline[k % outline.size()]);
    return state.positions[p] - ends_[p];
  };
  double max2 = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) max2 = std::max(max2, dot(off(k), off(k)));
  const double bound2 = bounds_[m].near * bounds_[m].near;
  if (4.0 * max2 <= bound2) return 0.0;
  const bool closed = member.cord->def.rows > 1;
  const auto may_have = [&](int k, int link) { return may_have_touched(state, member, k, link); };
  double apart2 = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    for (std::size_t other = k + 1; other <= k + at(close_links) && (closed || other < outline.size()); ++other) {
      const Vec2 apart = off(other) - off(k);
      if (dot(apart, apart) <= std::max(bound2, apart2)) continue;
      const int a = static_cast<int>(k);
      const int b = static_cast<int>(other % outline.size());
      if (may_have(a, b) || may_have(a, b - 1) || may_have(b, a) || may_have(b, a - 1)) apart2 = dot(apart, apart);
    }
  }
  return std::sqrt(apart2) / bounds_[m].near;
}

/// Returns whether a point of an outline may have come within contact distance of a link of it in the step.
bool MotionBounds::may_have_touched(const IslandState& state, const Member& member, int k, int link) const {
  const CordDef& def = member.cord->def;
  const int n = static_cast<int>(member.cord->outline.size());
  if (def.rows == 1 && (link < 0 || link + 1 >= n)) return false;
  if (are_neighbours(def, k, link)) return false;
  const std::size_t disc = outline_slot(member, k);
  const std::size_t a = outline_slot(member, link);
  const std::size_t b = outline_slot(member, link + 1);
  const auto displacement = [&](std::size_t p) { return state.positions[p] - start_[p]; };
  const Vec2 past_a = displacement(disc) - displacement(a);
  const Vec2 past_b = displacement(disc) - displacement(b);
  const double reached = 2.0 * def.radius + std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  return !(find_separation(start_[disc], start_[a], start_[b]).distance > reached);
}

bool MotionBounds::limit(const IslandState& state, std::span<const Vec2> from, std::span<const int> groups,
                         std::span<double> shares) const {
  bool all_within = true;
  const auto limit_slot = [&](std::size_t slot, Vec2 start, Vec2 end, double bound) {
    if (state.constrained[slot] != 0) return;
    const double share = share_within(from[slot], state.positions[slot], start, end, bound);
    if (share == 1.0) return;
    all_within = false;
    double& of_group = shares[at(groups[slot])];
    of_group = std::min(of_group, share);
  };
  for (std::size_t m = 0; m < state.members.size(); ++m) {
    for (std::size_t p = state.members[m].first_point; p < state.members[m].end_point(); ++p) {
      limit_slot(p, start_[p], ends_[p], bounds_[m].all);
    }
  }
  for (std::size_t k = 0; k < state.bodies.size(); ++k) {
    const RigidBody& body = state.rigid_of(state.bodies[k]);
    limit_slot(state.center(k), body.start(), body.position + state.dt * body.velocity, body_bound_);
  }
  return all_within;
}

/// Returns the share of the displacement that stays within the bound, 1 if all of it does.
double MotionBounds::share_within(Vec2 from, Vec2 to, Vec2 start, Vec2 end, double bound) const {
  const auto is_out = [&](double share) {
    return !(find_separation(from + share * (to - from), start, end).distance <= bound);
  };
  if (!is_out(1.0)) return 1.0;
  double inside = 0.0;
  double outside = 1.0;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (is_out(middle) ? outside : inside) = middle;
  }
  return inside;
}

}  // namespace ribbon
