#include <algorithm>
#include <cmath>

#include "ribbon/island.h"

// How far from its straight way anything may go in a step, in which its contacts are looked for.

namespace ribbon {
namespace {

constexpr double widening = 8.0;  // of the room of what left it
constexpr double most_widening = 500.0;

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

/// The box in which the cord stays.
void Island::find_reach(const Member& member) {
  const std::size_t first = member.first + at(member.cord->outline_[0]);
  reach_ = {positions_[first], positions_[first]};
  for (const int point : member.cord->outline_) {
    const std::size_t p = member.first + at(point);
    reach_ = joined(reach_, box_around(positions_[p], ends_[p], 0.0));
  }
  reach_ = widened(reach_, member.room);
}

/// The box in which a link of the outline stays, but for the room.
Box Island::link_box(const ContactPair& pair) const {
  return joined(box_around(positions_[at(pair.a)], ends_[at(pair.a)], 0.0),
                box_around(positions_[at(pair.b)], ends_[at(pair.b)], 0.0));
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
  if (!meets_) return false;
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
    for (std::size_t p = member.first; p < member.first + member.count && !left; ++p) {
      left = !(gap_between(positions_[p], step_start_[p], ends_[p]).distance <= member.room);
    }
    if (!left || widenings_[m] > most_widening) continue;
    widenings_[m] *= widening;
    any = true;
  }
  return any;
}

}  // namespace ribbon
