#include <algorithm>
#include <cmath>

#include "ribbon/island.h"

// How far from its straight way anything may go in a step, in which its contacts are looked for.

namespace ribbon {
namespace {

constexpr double widening = 8.0;  // of the room of what left it
constexpr double most_widening = 500.0;
constexpr double surely_kept = 0.9;  // of his room, that who is so near the end of his way has kept to, whatever rounds
constexpr int room_halvings = 10;    // of a share, to find where something leaves its room

}  // namespace

double Island::room_of(const IslandCord& island_cord, std::span<const RigidBody> bodies, double dt, Vec2 gravity) {
  const Cord& cord = *island_cord.cord;
  double own2 = 0.0;
  double other2 = 0.0;
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
  return 0.25 * cord.rest_length(0) + 2.0 * dt * dt * length(gravity) + turned;
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

/// Gives who left his room in the step more of it. False if that was nobody, or he has all there is.
bool Island::widen() {
  if (!meets_ || poses_) return false;
  bool body_left = false;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const RigidBody& body = rigid_[at(bodies_[k].index)];
    const Vec2 end = body.position + step_dt_ * body.velocity;
    body_left = body_left || !(gap_between(positions_[center(k)], body.position, end).distance <= body_room_);
  }
  bool any = false;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const Member& member = members_[m];
    bool left = body_left;
    const double surely2 = surely_kept * surely_kept * member.room * member.room;
    for (std::size_t p = member.first; p < member.first + member.count && !left; ++p) {
      const Vec2 off = positions_[p] - ends_[p];
      if (dot(off, off) <= surely2) continue;
      left = !(gap_between(positions_[p], step_start_[p], ends_[p]).distance <= member.room);
    }
    left = left || (member.cord->def_.self_contact && parts_from_neighbours(member));
    if (!left || widenings_[m] > most_widening) continue;
    widenings_[m] *= widening;
    any = true;
  }
  return any;
}

/// Whether a point of the outline has gone another way than one close to it, by more than their room.
bool Island::parts_from_neighbours(const Member& member) const {
  const std::vector<int>& outline = member.cord->outline_;
  const auto off = [&](std::size_t k) {
    const std::size_t p = member.first + at(outline[k % outline.size()]);
    return positions_[p] - ends_[p];
  };
  double most2 = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) most2 = std::max(most2, dot(off(k), off(k)));
  const double room2 = member.near_room * member.near_room;
  if (4.0 * most2 <= room2) return false;
  const bool closed = member.cord->def_.rows > 1;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    for (std::size_t other = k + 1; other <= k + at(close_links) && (closed || other < outline.size()); ++other) {
      const Vec2 apart = off(other) - off(k);
      if (!(dot(apart, apart) <= room2)) return true;
    }
  }
  return false;
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
      return !(gap_between(from[slot] + share * (positions_[slot] - from[slot]), start, end).distance <= room);
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
