#include <algorithm>
#include <cmath>
#include <numeric>

#include "ribbon/island/island.h"

// Whom the cords may touch in a step: circles and edges, and the pairs that are made of all that is found.

namespace ribbon {
namespace {

constexpr double large_circle = 10.0;  // links, that the reach of a circle is which is met by points
// Of the reach, or of ten links if that is less: deeper than this a contact is not by pressing,
constexpr double deep_share = 0.01;
constexpr double emerging_share = 0.1;     // and comes out of so much of its depth in a step,
constexpr double fastest_emergence = 1.0;  // m/s, but no faster than this
constexpr std::size_t usual_touches = 16;  // of a cord that meets somebody, for which it has room

}  // namespace

/// Everything is expected to go straight on in the step, and to fall, and to leave that way by no more than its room.
/// Where something does, the step is taken again with more.
void Island::find_contacts(double dt) {
  contacts_.clear(count_);
  has_pattern_ = false;
  touch_changed_ = false;
  const bool any =
      std::any_of(members_.begin(), members_.end(), [](const Member& member) { return may_touch(member); });
  meets_ = any;
  if (!any) return;
  ends_.resize(count_);
  for (std::size_t p = 0; p < count_; ++p) {
    ends_[p] = positions_[p] + dt * velocities_[p];
    if (constrained_[p] == 0) ends_[p] += (dt * dt) * gravity_;
  }
  body_room_ = 0.0;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    Member& member = members_[m];
    member.room = widenings_[m] * room_of({member.cord, member.met, member.id}, rigid_, dt, gravity_);
    member.near_room = near_widenings_[m] * near_share * member.cord->rest_length(0);
    body_room_ = std::max(body_room_, member.room);
  }
  for (Member& member : members_) {
    find_reach(member);
    if (!member.met.circles.empty()) member.longest_link = longest_link(member);
    for (const RigidCircle& circle : member.met.circles) {
      if (!holds(member, circle.body)) meet_circle(member, circle);
    }
    for (const RigidSegment& segment : member.met.segments) {
      if (!holds(member, segment.body)) meet_segment(member, segment);
    }
    touch_changed_ = touch_changed_ || member.cord->contacts_changed_;
  }
  meet_each_other();
}

bool Island::may_touch(const Member& member) {
  const CordDef& def = member.cord->def_;
  return !member.met.circles.empty() || !member.met.segments.empty() || def.self_contact || def.cord_contact;
}

/// What holds a cord is not in its way: as bodies that a joint connects are not in each other's.
bool Island::holds(const Member& member, int body) {
  const auto& grips = member.met.grips;
  return std::any_of(grips.begin(), grips.end(), [body](const Grip& grip) { return grip.body == body; });
}

void Island::meet_circle(const Member& member, const RigidCircle& circle) {
  const RigidBody& body = rigid_[at(circle.body)];
  const double reach = circle.radius + member.cord->def_.radius;
  const Box box = widened(spot_box(body, circle.offset), reach);
  if (!overlap(box, reach_)) return;
  const Box near = widened(box, member.room);
  // Between the points of so large a circle a cord is nowhere deeper than an eightieth of a link, L²/8R. On it,
  // straight by that little, it has one minimum of the distance, and bent by it one a link: as one became the other,
  // the energy of what presses would jump.
  const bool by_points = reach >= large_circle * member.longest_link;
  const int points = static_cast<int>(member.cord->outline_.size());
  const int count = by_points ? points : links(*member.cord);
  int disc = -1;
  for (int k = 0; k < count; ++k) {
    const Box& here = outline_boxes_[at(k)];
    const Box& there = outline_boxes_[at(by_points ? k : k + 1 < points ? k + 1 : 0)];
    if (!overlap(joined(here, there), near)) continue;
    ContactPair pair = by_points ? pair_with_point(member, k) : pair_with_link(member, k);
    if (body.inverse_mass == 0.0 && is_fixed_in(pair, body.position + circle.offset, reach)) continue;
    if (disc < 0) disc = add_spot(circle.body, circle.offset);
    pair.disc = disc;
    pair.reach = reach;
    pair.disc_radius = circle.radius;
    pair.touch.other = circle.id;
    pair.touch.feature = by_points ? 2 * k + 1 : 2 * k;
    add_pair(member, pair, member.mass, circle.friction, circle.restitution);
  }
}

/// Whether a link is constrained where it is within reach of a disc already. If that does not move either, nothing that
/// the cord could do would part them: a bridge hangs from the corner of a rock.
bool Island::is_fixed_in(const ContactPair& link, Vec2 center, double reach) const {
  const auto is_in = [&](int end) {
    return constrained_[at(end)] != 0 && length(positions_[at(end)] - center) < reach;
  };
  return is_in(link.a) || is_in(link.b);
}

/// The cord's points against the inside of an edge; its ends are circles.
void Island::meet_segment(const Member& member, const RigidSegment& segment) {
  const Cord& cord = *member.cord;
  const RigidBody& body = rigid_[at(segment.body)];
  const double reach = segment.radius + cord.def_.radius;
  const Box box = widened(joined(spot_box(body, segment.a), spot_box(body, segment.b)), reach);
  if (!overlap(box, reach_)) return;
  const Box near = widened(box, member.room);
  int a = -1;
  int b = -1;
  for (int k = 0; k < static_cast<int>(cord.outline_.size()); ++k) {
    if (!overlap(outline_boxes_[at(k)], near)) continue;
    const std::size_t point = member.first + at(cord.outline_[at(k)]);
    if (body.inverse_mass == 0.0 && constrained_[point] != 0) continue;
    if (a < 0) {
      a = add_spot(segment.body, segment.a);
      b = add_spot(segment.body, segment.b);
    }
    ContactPair pair;
    pair.disc = static_cast<int>(point);
    pair.a = a;
    pair.b = b;
    pair.ends = false;
    pair.reach = reach;
    pair.disc_radius = cord.def_.radius;
    pair.touch.other = segment.id;
    pair.touch.feature = 2 * k + 1;
    add_pair(member, pair, member.mass, segment.friction, segment.restitution);
  }
}

int Island::add_spot(int body, Vec2 arm) {
  const RigidBody& rigid = rigid_[at(body)];
  Spot spot;
  spot.arm = arm;
  spot.here = rigid.position + arm;
  if (rigid.inverse_mass > 0.0) {
    spot.center = static_cast<int>(center(body_slot(body)));
  } else {
    spot.from = rigid.position;
    spot.velocity = rigid.velocity;
    spot.turning = rigid.angular_velocity;
    driven_ = driven_ || !(rigid.velocity == Vec2{}) || rigid.angular_velocity != 0.0;
  }
  return contacts_.add(spot);
}

/// kg, of a cord, of what hangs on it, and of the heaviest body near it, which may press it against something else. A
/// body that nothing pushes does neither.
double Island::pressing_mass(const Member& member) const {
  const auto mass_of = [this](int body) {
    const double inverse_mass = rigid_[at(body)].inverse_mass;
    return inverse_mass > 0.0 ? 1.0 / inverse_mass : 0.0;
  };
  const std::vector<double>& points = member.cord->masses_;
  double mass = std::accumulate(points.begin(), points.end(), 0.0);
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k) mass += mass_of(held_[k].rigid);
  double heaviest = 0.0;
  for (const RigidCircle& circle : member.met.circles) heaviest = std::max(heaviest, mass_of(circle.body));
  for (const RigidSegment& segment : member.met.segments) heaviest = std::max(heaviest, mass_of(segment.body));
  return mass + heaviest;
}

/// Adds a pair that the member remembers, of masses that press and surfaces as they are. Who is pressed in already, by
/// what knows nothing of cords, comes out by and by, and not by the energy that so deep a contact would have: in a step
/// if he is in a little, in several if he is in deep.
void Island::add_pair(const Member& member, ContactPair& pair, double mass, double friction, double restitution) {
  pair.cord = static_cast<std::size_t>(&member - members_.data());
  pair.stiffness =
      (accuracy_.soft_contacts ? Contacts::soft_firmness : Contacts::firmness) * mass / (step_dt_ * step_dt_);
  pair.friction = std::sqrt(member.cord->def_.friction * friction);
  pair.restitution = std::max(member.cord->def_.restitution, restitution);
  const auto& touches = member.cord->touches_;
  const auto before = std::lower_bound(touches.begin(), touches.end(), pair.touch,
                                       [](const Touch& a, const Touch& b) { return a.place_before(b); });
  if (before != touches.end() && !pair.touch.place_before(*before)) pair.touch = *before;
  pair.touch.impulse = 0.0;
  const double distance = find_separation(place_of(pair.disc), place_of(pair.a), place_of(pair.b)).distance;
  const double depth = pair.reach - distance;
  const double size = std::min(pair.reach, large_circle * member.cord->rest_length(0));
  if (depth > deep_share * size) pair.reach = distance + emerging_share * depth;
  pair.in = std::max(0.0, pair.reach - distance - pair.touch.force / pair.stiffness);
  const double most_in = step_dt_ * fastest_emergence;
  if (pair.in > most_in) {
    pair.reach -= pair.in - most_in;
    pair.in = most_in;
  }
  contacts_.add(pair);
}

/// Where an anchor is when the step begins.
Vec2 Island::place_of(int anchor) const {
  if (at(anchor) < count_) return positions_[at(anchor)];
  return contacts_.spots()[at(anchor) - count_].here;
}

/// What touches at the end of the step, or did in it.
void Island::remember_contacts() {
  for (const Member& member : members_) {
    member.cord->touches_.clear();
    if (!contacts_.empty()) member.cord->touches_.reserve(usual_touches);
    member.cord->contacts_changed_ = touch_changed_;
  }
  for (const ContactPair& pair : contacts_.pairs()) {
    if (!(pair.touch.force > 0.0 || pair.touch.impulse > 0.0)) continue;
    members_[pair.cord].cord->touches_.push_back(pair.touch);
  }
  for (const Member& member : members_) {
    auto& touches = member.cord->touches_;
    std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) { return a.place_before(b); });
  }
}

}  // namespace ribbon
