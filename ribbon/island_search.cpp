#include <algorithm>
#include <cmath>

#include "ribbon/complex.h"
#include "ribbon/island.h"

// Whom the cords may touch in a step.

namespace ribbon {
namespace {

// Times the radius: parts of a cord that lie nearer than that at rest are not in each other's way.
constexpr double own_neighbourhood = 3.0;

constexpr double widening = 8.0;  // of the room of what left it
constexpr double most_widening = 500.0;
constexpr double large_circle = 10.0;  // links, that the reach of a circle is which is met by points
// Of the reach, or of ten links if that is less: deeper than this a contact is not by pressing,
constexpr double deep_share = 0.01;
constexpr double emerging_share = 0.1;     // and comes out of so much of its depth in a step,
constexpr double fastest_emergence = 1.0;  // m/s, but no faster than this

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
    touch_changed_ = touch_changed_ || member.cord->touch_changed_;
  }
  meet_each_other();
}

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

bool Island::may_touch(const Member& member) {
  const CordDef& def = member.cord->def_;
  return !member.met.circles.empty() || !member.met.segments.empty() || def.self_contact || def.cord_contact;
}

/// What holds a cord is not in its way: as bodies that a joint connects are not in each other's.
bool Island::holds(const Member& member, int body) {
  const auto& grips = member.met.grips;
  return std::any_of(grips.begin(), grips.end(), [body](const Grip& grip) { return grip.body == body; });
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

/// kg, of a cord and what hangs on it.
double Island::pressing_mass(const Member& member) const {
  double mass = 0.0;
  for (const double point : member.cord->masses_) mass += point;
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k) {
    mass += 1.0 / rigid_[at(held_[k].rigid)].inverse_mass;
  }
  return mass;
}

int Island::links(const Cord& cord) {
  const int points = static_cast<int>(cord.outline_.size());
  return cord.def_.rows == 1 ? points - 1 : points;
}

/// The link k of the outline, as the segment of a pair.
ContactPair Island::pair_with_link(const Member& member, int k) const {
  const std::vector<int>& outline = member.cord->outline_;
  const int n = static_cast<int>(outline.size());
  const bool closed = member.cord->def_.rows > 1;
  const auto anchor = [&](int i) {
    if (closed) return static_cast<int>(member.first) + outline[at((i + n) % n)];
    return i < 0 || i >= n ? -1 : static_cast<int>(member.first) + outline[at(i)];
  };
  ContactPair pair;
  pair.a = anchor(k);
  pair.b = anchor(k + 1);
  pair.before = anchor(k - 1);
  pair.after = anchor(k + 2);
  return pair;
}

/// The point k of the outline, as a segment without length.
ContactPair Island::pair_with_point(const Member& member, int k) {
  ContactPair pair;
  pair.a = static_cast<int>(member.first) + member.cord->outline_[at(k)];
  pair.b = pair.a;
  return pair;
}

/// Adds a pair that the member remembers, of masses that press and surfaces as they are. Who is pressed in already, by
/// what knows nothing of cords, comes out by and by, and not by the energy that so deep a contact would have: in a step
/// if he is in a little, in several if he is in deep.
void Island::add_pair(const Member& member, ContactPair& pair, double mass, double friction, double restitution) {
  pair.cord = static_cast<std::size_t>(&member - members_.data());
  pair.stiffness = (is_rough() ? Contacts::rough_firmness : Contacts::firmness) * mass / (step_dt_ * step_dt_);
  pair.friction = std::sqrt(member.cord->def_.friction * friction);
  pair.restitution = std::max(member.cord->def_.restitution, restitution);
  const auto& touches = member.cord->touches_;
  const auto before = std::lower_bound(touches.begin(), touches.end(), pair.touch,
                                       [](const Touch& a, const Touch& b) { return a.place_before(b); });
  if (before != touches.end() && !pair.touch.place_before(*before)) pair.touch = *before;
  pair.touch.impulse = 0.0;
  const double distance = gap_between(place_of(pair.disc), place_of(pair.a), place_of(pair.b)).distance;
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

void Island::meet_circle(const Member& member, const RigidCircle& circle) {
  const RigidBody& body = rigid_[at(circle.body)];
  const double reach = circle.radius + member.cord->def_.radius;
  const Box box = widened(spot_box(body, circle.offset), reach);
  if (!overlap(box, reach_)) return;
  const Box near = widened(box, member.room);
  const double mass = member.mass + (body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0);
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
    if (disc < 0) disc = add_spot(circle.body, circle.offset);
    pair.disc = disc;
    pair.reach = reach;
    pair.disc_radius = circle.radius;
    pair.touch.other = circle.id;
    pair.touch.feature = by_points ? 2 * k + 1 : 2 * k;
    add_pair(member, pair, mass, circle.friction, circle.restitution);
  }
}

double Island::longest_link(const Member& member) const {
  double longest2 = 0.0;
  const std::vector<int>& outline = member.cord->outline_;
  for (int k = 0; k < links(*member.cord); ++k) {
    const std::size_t a = member.first + at(outline[at(k)]);
    const std::size_t b = member.first + at(outline[at(k + 1) % outline.size()]);
    const Vec2 along = positions_[b] - positions_[a];
    longest2 = std::max(longest2, dot(along, along));
  }
  return std::sqrt(longest2);
}

/// The cord's points against the inside of an edge; its ends are circles.
void Island::meet_segment(const Member& member, const RigidSegment& segment) {
  const Cord& cord = *member.cord;
  const RigidBody& body = rigid_[at(segment.body)];
  const double reach = segment.radius + cord.def_.radius;
  const Box box = widened(joined(spot_box(body, segment.a), spot_box(body, segment.b)), reach);
  if (!overlap(box, reach_)) return;
  const Box near = widened(box, member.room);
  const double mass = member.mass + (body.inverse_mass > 0.0 ? 1.0 / body.inverse_mass : 0.0);
  int a = -1;
  int b = -1;
  for (int k = 0; k < static_cast<int>(cord.outline_.size()); ++k) {
    if (!overlap(outline_boxes_[at(k)], near)) continue;
    if (a < 0) {
      a = add_spot(segment.body, segment.a);
      b = add_spot(segment.body, segment.b);
    }
    ContactPair pair;
    pair.disc = static_cast<int>(member.first) + cord.outline_[at(k)];
    pair.a = a;
    pair.b = b;
    pair.ends = false;
    pair.reach = reach;
    pair.disc_radius = cord.def_.radius;
    pair.touch.other = segment.id;
    pair.touch.feature = 2 * k + 1;
    add_pair(member, pair, mass, segment.friction, segment.restitution);
  }
}

/// Points of cords against links, of the same and of other cords, as far as these declare it.
void Island::meet_each_other() {
  link_boxes_.clear();
  outline_links_.clear();
  const Vec2 drift = mean_way();
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const CordDef& def = members_[m].cord->def_;
    if (!def.self_contact && (!def.cord_contact || members_.size() == 1)) continue;
    for (int k = 0; k < links(*members_[m].cord); ++k) {
      const ContactPair link = pair_with_link(members_[m], k);
      const std::size_t a = at(link.a);
      const std::size_t b = at(link.b);
      const Box box =
          joined(box_around(positions_[a], ends_[a] - drift, 0.0), box_around(positions_[b], ends_[b] - drift, 0.0));
      link_boxes_.push_back(widened(box, def.radius + members_[m].room));
      outline_links_.push_back({m, k});
    }
  }
  if (link_boxes_.empty()) return;
  if (!tree_ || tree_room_ < link_boxes_.size()) {
    tree_room_ = 2 * link_boxes_.size();
    tree_ = std::make_unique<Quadtree>(static_cast<int>(tree_room_));
  }
  tree_->build(link_boxes_);
  for (const Member& member : members_) {
    const Cord& cord = *member.cord;
    if (!cord.def_.self_contact && !cord.def_.cord_contact) continue;
    for (int k = 0; k < static_cast<int>(cord.outline_.size()); ++k) {
      const std::size_t p = member.first + at(cord.outline_[at(k)]);
      const Box box = box_around(positions_[p], ends_[p] - drift, cord.def_.radius + member.room);
      tree_->query(box, [&](int item) { meet_link(member, k, outline_links_[at(item)]); });
    }
  }
}

/// How far all of it goes in the step, on average: what goes together does not meet.
Vec2 Island::mean_way() const {
  Vec2 sum;
  for (std::size_t p = 0; p < count_; ++p) sum += ends_[p] - positions_[p];
  return (1.0 / static_cast<double>(count_)) * sum;
}

/// The outline's point k of a cord against a link of this or another one.
void Island::meet_link(const Member& member, int k, const OutlineLink& link) {
  const Member& other = members_[link.member];
  const bool itself = &other == &member;
  const CordDef& def = member.cord->def_;
  if (itself ? !def.self_contact : !def.cord_contact || !other.cord->def_.cord_contact) return;
  const std::size_t disc = member.first + at(member.cord->outline_[at(k)]);
  const double reach = def.radius + other.cord->def_.radius;
  if (!may_meet(disc, link, reach + member.room + other.room)) return;
  if (itself && are_neighbours(def, k, link.link)) return;
  ContactPair pair = pair_with_link(other, link.link);
  pair.disc = static_cast<int>(disc);
  pair.mutual = true;
  pair.reach = reach;
  pair.disc_radius = def.radius;
  pair.touch.other = other.id;
  pair.touch.feature = 2 * k + 1;
  pair.touch.other_feature = link.link + 1;
  add_pair(member, pair, itself ? member.mass : member.mass + other.mass, other.cord->def_.friction,
           other.cord->def_.restitution);
}

/// Whether on their straight ways a point and a link may come as near each other as that.
bool Island::may_meet(std::size_t disc, const OutlineLink& link, double distance) const {
  const Member& member = members_[link.member];
  const std::vector<int>& outline = member.cord->outline_;
  const std::size_t a = member.first + at(outline[at(link.link)]);
  const std::size_t b = member.first + at(outline[(at(link.link) + 1) % outline.size()]);
  const Vec2 way = ends_[disc] - positions_[disc];
  const Vec2 past_a = way - (ends_[a] - positions_[a]);
  const Vec2 past_b = way - (ends_[b] - positions_[b]);
  const double most = distance + std::sqrt(std::max(dot(past_a, past_a), dot(past_b, past_b)));
  return may_be_within(most, positions_[disc], positions_[a], positions_[b]) &&
         gap_between(positions_[disc], positions_[a], positions_[b]).distance <= most;
}

/// Whether a point and a link of one outline lie so near each other at rest that they could not be kept apart.
bool Island::are_neighbours(const CordDef& def, int k, int link) {
  const double along = def.length / (def.points - 1);
  const double across = def.rows > 1 ? def.width / (def.rows - 1) : 0.0;
  const int n = def.points;
  const int size = def.rows == 1 ? n : 2 * (n + def.rows - 2);
  const auto at_rest = [&](int i) {
    i %= size;
    if (i < n) return Vec2{along * i, 0.0};
    i -= n - 1;
    if (i < def.rows) return Vec2{along * (n - 1), across * i};
    i -= def.rows - 1;
    if (i < n) return Vec2{along * (n - 1 - i), def.width};
    return Vec2{0.0, def.width - across * (i - n + 1)};
  };
  if (k == link || k == (link + 1) % size) return true;
  const Gap gap = gap_between(at_rest(k), at_rest(link), at_rest(link + 1));
  return gap.distance < own_neighbourhood * def.radius;
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

/// What touches at the end of the step, or did in it.
void Island::remember_contacts(const Member& member) {
  Cord& cord = *member.cord;
  cord.touches_.clear();
  cord.touches_.reserve(contacts_.pairs().size());
  cord.touch_changed_ = touch_changed_;
  const auto index = static_cast<std::size_t>(&member - members_.data());
  for (const ContactPair& pair : contacts_.pairs()) {
    if (pair.cord == index && (pair.touch.force > 0.0 || pair.touch.impulse > 0.0)) cord.touches_.push_back(pair.touch);
  }
  std::sort(cord.touches_.begin(), cord.touches_.end(),
            [](const Touch& a, const Touch& b) { return a.place_before(b); });
}

}  // namespace ribbon
