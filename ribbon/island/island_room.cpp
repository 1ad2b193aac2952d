#include <algorithm>
#include <cmath>

#include "ribbon/island/island.h"

// How far from its straight way anything may go in a step, in which its contacts are looked for.

namespace ribbon {
namespace {

// Of the room of what left it: as far as it went and a little more, but no less than this and no more than that.
constexpr double spare_room = 1.5;
constexpr double least_widening_once = 2.0;
constexpr double most_widening_once = 8.0;
constexpr double most_widening = 500.0;
constexpr double surely_kept = 0.9;  // of his room, that who is so near the end of his way has kept to, whatever rounds
constexpr int room_halvings = 10;    // of a share, to find where something leaves its room

}  // namespace

double Island::room_of(const IslandCord& island_cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity) {
  const Cord& cord = *island_cord.cord;
  double own2 = 0.0;
  double other2 = 0.0;
  double pulled = 0.0;  // m/s²
  for (std::size_t p = 0; p < cord.loads_.size(); ++p) {
    pulled = std::max(pulled, length(cord.loads_[p]) / cord.masses_[p]);
  }
  for (std::size_t p = 0; p < cord.count(); ++p) {
    const bool is_free = cord.kinds_[p] == PointKind::free;
    const Vec2 v = is_free ? cord.velocities_[p] : (1.0 / dt) * (cord.targets_[p] - cord.positions_[p]);
    own2 = std::max(own2, dot(v, v));
  }
  const auto take = [&](int body) {
    const Vec2 v = bodies[at(body)].velocity;
    other2 = std::max(other2, dot(v, v));
  };
  for (const RigidCircle& circle : island_cord.met.circles) take(circle.body);
  for (const RigidSegment& segment : island_cord.met.segments) take(segment.body);
  const double turned = dt * (turned_share * std::sqrt(own2) + std::sqrt(other2));
  const double pull = std::min(cord.rest_length(0), dt * dt * pulled);  // further goes only what its links let go
  return 0.25 * cord.rest_length(0) + 2.0 * dt * dt * length(gravity) + turned + pull;
}

/// The boxes in which the cord and the points of its outline stay.
void Island::find_reach(const Member& member) {
  outline_boxes_.clear();
  for (const int point : member.cord->outline_) {
    const std::size_t p = member.first + at(point);
    outline_boxes_.push_back(box_around(positions_[p], ends_[p], 0.0));
  }
  reach_ = outline_boxes_[0];
  for (const Box& box : outline_boxes_) reach_ = joined(reach_, box);
  reach_ = widened(reach_, member.room);
}

/// The box in which a spot of a body stays.
Box Island::spot_box(const RigidBody& body, Vec2 arm) const {
  const Vec2 here = body.position + arm;
  const Vec2 there = here + step_dt_ * (body.velocity + body.angular_velocity * perp(arm));
  const double turned = step_dt_ * body.angular_velocity;
  return box_around(here, there, 0.5 * turned * turned * length(arm) + (body.inverse_mass > 0.0 ? body_room_ : 0.0));
}

/// Gives what left its room in the step more of it, as far as it went. False if nothing did, or has all there is.
bool Island::widen() {
  if (!meets_ || poses_) return false;
  double bodies_went = 0.0;  // in rooms of theirs
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const RigidBody& body = rigid_[at(bodies_[k].index)];
    const Vec2 end = body.position + step_dt_ * body.velocity;
    const double went = find_separation(positions_[center(k)], body.position, end).distance / body_room_;
    bodies_went = went <= bodies_went ? bodies_went : went;  // or no number
  }
  bool any = false;
  const auto widen_by = [&any](double& widening, double went) {
    if (went <= 1.0 || widening > most_widening) return;
    widening *= went < most_widening_once ? std::max(least_widening_once, spare_room * went) : most_widening_once;
    any = true;
  };
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Member& member = members_[m];
    widen_by(widenings_[m], std::max(bodies_went, rooms_went(member)));
    if (member.cord->def_.self_contact) widen_by(near_widenings_[m], near_rooms_went(member));
  }
  return any;
}

/// How far from its straight way a point of the cord has gone, in rooms.
double Island::rooms_went(const Member& member) const {
  double most = 0.0;
  const double surely2 = surely_kept * surely_kept * member.room * member.room;
  for (std::size_t p = member.first; p < member.first + member.count; ++p) {
    const Vec2 off = positions_[p] - ends_[p];
    if (dot(off, off) <= surely2) continue;
    const double went = find_separation(positions_[p], step_start_[p], ends_[p]).distance / member.room;
    most = went <= most ? most : went;
  }
  return most;
}

/// How much further than one near it along the outline, which it may have met, a point has gone, in rooms of what is
/// near.
double Island::near_rooms_went(const Member& member) const {
  const std::vector<int>& outline = member.cord->outline_;
  const auto off = [&](std::size_t k) {
    const std::size_t p = member.first + at(outline[k % outline.size()]);
    return positions_[p] - ends_[p];
  };
  double most2 = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) most2 = std::max(most2, dot(off(k), off(k)));
  const double room2 = member.near_room * member.near_room;
  if (4.0 * most2 <= room2) return 0.0;
  const bool closed = member.cord->def_.rows > 1;
  double apart2 = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    for (std::size_t other = k + 1; other <= k + at(close_links) && (closed || other < outline.size()); ++other) {
      const Vec2 apart = off(other) - off(k);
      if (dot(apart, apart) <= std::max(room2, apart2)) continue;
      const int a = static_cast<int>(k);
      const int b = static_cast<int>(other % outline.size());
      if (may_have_met(member, a, b) || may_have_met(member, a, b - 1) || may_have_met(member, b, a) ||
          may_have_met(member, b, a - 1)) {
        apart2 = dot(apart, apart);
      }
    }
  }
  return std::sqrt(apart2) / member.near_room;
}

/// Whether a point of an outline may have come within reach of a link of it in the step.
bool Island::may_have_met(const Member& member, int k, int link) const {
  const Cord& cord = *member.cord;
  const std::vector<int>& outline = cord.outline_;
  const int n = static_cast<int>(outline.size());
  if (cord.def_.rows == 1 && (link < 0 || link + 1 >= n)) return false;
  if (are_neighbours(cord.def_, k, link)) return false;
  const auto slot = [&](int i) { return member.first + at(outline[at((i + n) % n)]); };
  const std::size_t disc = slot(k);
  const std::size_t a = slot(link);
  const std::size_t b = slot(link + 1);
  const auto way = [&](std::size_t p) { return positions_[p] - step_start_[p]; };
  const Vec2 past_a = way(disc) - way(a);
  const Vec2 past_b = way(disc) - way(b);
  const double most = 2.0 * cord.def_.radius + std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  return !(find_separation(step_start_[disc], step_start_[a], step_start_[b]).distance > most);
}

/// What holds a cord goes with it.
void Island::find_groups() {
  groups_.assign(positions_.size(), -1);
  const auto root = [&](std::size_t slot) {
    while (groups_[slot] >= 0 && at(groups_[slot]) != slot) slot = at(groups_[slot]);
    return slot;
  };
  for (const Member& member : members_) {
    for (std::size_t p = member.first; p < member.first + member.count; ++p)
      groups_[p] = static_cast<int>(member.first);
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) groups_[center(k)] = static_cast<int>(center(k));
  for (const HeldBody& held : held_) {
    const std::size_t a = root(held.point);
    const std::size_t b = root(center(held.body));
    groups_[std::max(a, b)] = static_cast<int>(std::min(a, b));
  }
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (groups_[p] >= 0) groups_[p] = static_cast<int>(root(p));
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) groups_[angle(k)] = groups_[center(k)];
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0) groups_[p] = -1;  // it goes its own way
  }
}

/// Takes from the way of cords, and of what holds them, what would lead them through each other, or out of the room in
/// which contacts were looked for. False if it had to.
bool Island::keep_apart(std::span<const Vec2> from) {
  find_groups();
  group_shares_.assign(positions_.size(), 1.0);
  const bool roomy = keep_to_room(from);
  const bool apart = contacts_.keep_apart(from, positions_, groups_, group_shares_);
  if (apart && roomy) return true;
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0 || groups_[p] < 0) continue;
    positions_[p] = from[p] + group_shares_[at(groups_[p])] * (positions_[p] - from[p]);
  }
  return false;
}

bool Island::keep_to_room(std::span<const Vec2> from) {
  bool all = true;
  const auto keep = [&](std::size_t slot, Vec2 start, Vec2 end, double room) {
    if (constrained_[slot] != 0) return;
    const auto is_out = [&](double share) {
      return !(find_separation(from[slot] + share * (positions_[slot] - from[slot]), start, end).distance <= room);
    };
    if (!is_out(1.0)) return;
    all = false;
    double inside = 0.0;
    double outside = 1.0;
    for (int k = 0; k < room_halvings; ++k) {
      const double middle = 0.5 * (inside + outside);
      (is_out(middle) ? outside : inside) = middle;
    }
    double& share = group_shares_[at(groups_[slot])];
    share = std::min(share, inside);
  };
  for (const Member& member : members_) {
    for (std::size_t p = member.first; p < member.first + member.count; ++p) {
      keep(p, step_start_[p], ends_[p], member.room);
    }
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const RigidBody& body = rigid_[at(bodies_[k].index)];
    keep(center(k), body.position, body.position + step_dt_ * body.velocity, body_room_);
  }
  return all;
}

}  // namespace ribbon
