#include <algorithm>
#include <cmath>

#include "ribbon/complex.h"
#include "ribbon/island.h"

// Whom the cords may touch in a step, and the solve of a stage near them.

namespace ribbon {
namespace {

// Of a contact [1], times the mass that may press, over the square of the step: so deep does what presses sink as its
// own way in a step is divided by that.
constexpr double firmness = 2e3;
constexpr int touching_iterations = 40;       // Newton steps of a stage near contacts
constexpr std::size_t remembered_values = 3;  // of the merit, none of which a step has to go below but the greatest
constexpr int patient_iterations = 10;
constexpr double negligible_share = 1e-3;
constexpr double penalty_factor = 2.0;  // by which the exact penalty of a search is above the tensions
constexpr double shortest_step = 1e-6;  // of a Newton step, below which a search gives up
constexpr double most_motion = 1e12;    // m, of a Newton step, beyond which it is none

Box box_around(Vec2 a, Vec2 b, double margin) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin}};
}

bool contains(const Box& box, Vec2 p) {
  return box.low.x <= p.x && p.x <= box.high.x && box.low.y <= p.y && p.y <= box.high.y;
}

}  // namespace

/// In a step nothing that is pushed goes further than room_: twice what the fastest goes and falls, and a quarter of a
/// link. Where it does, the step is taken again with more.
void Island::find_contacts(double dt, double room) {
  contacts_.clear(count_);
  has_pattern_ = false;
  touch_changed_ = false;
  const bool any = std::any_of(members_.begin(), members_.end(), [](const Member& member) {
    return !member.met.circles.empty() || !member.met.segments.empty() || member.cord->def_.self_contact;
  });
  if (!any) return;
  double speed2 = 0.0;
  double link = 0.0;
  for (std::size_t p = 0; p < count_; ++p) speed2 = std::max(speed2, dot(velocities_[p], velocities_[p]));
  for (const RigidBody& body : rigid_) speed2 = std::max(speed2, dot(body.velocity, body.velocity));
  for (const Member& member : members_) link = std::max(link, member.cord->rest_[0]);
  room_ = room * (2.0 * dt * (std::sqrt(speed2) + dt * length(gravity_)) + 0.25 * link);
  for (const Member& member : members_) {
    find_outline(member);
    for (const RigidCircle& circle : member.met.circles) {
      if (!holds(member, circle.body)) meet_circle(member, circle);
    }
    for (const RigidSegment& segment : member.met.segments) {
      if (!holds(member, segment.body)) meet_segment(member, segment);
    }
    if (member.cord->def_.self_contact) meet_itself(member);
    touch_changed_ = touch_changed_ || member.cord->touch_changed_;
  }
}

/// What holds a cord is not in its way: as bodies that a joint connects are not in each other's.
bool Island::holds(const Member& member, int body) {
  const auto& grips = member.met.grips;
  return std::any_of(grips.begin(), grips.end(), [body](const Grip& grip) { return grip.body == body; });
}

void Island::find_outline(const Member& member) {
  const Cord& cord = *member.cord;
  reach_ = {positions_[member.first], positions_[member.first]};
  for (const int point : cord.outline_) {
    const Vec2 x = positions_[member.first + at(point)];
    reach_.low = {std::min(reach_.low.x, x.x), std::min(reach_.low.y, x.y)};
    reach_.high = {std::max(reach_.high.x, x.x), std::max(reach_.high.y, x.y)};
  }
}

/// How far a body's spot may go in the step.
double Island::room_of(const RigidBody& body, Vec2 arm) const {
  return body.inverse_mass > 0.0 ? room_
                                 : step_dt_ * (length(body.velocity) + std::abs(body.angular_velocity) * length(arm));
}

int Island::add_spot(int body, Vec2 arm) {
  const RigidBody& rigid = rigid_[at(body)];
  Spot spot;
  spot.arm = arm;
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

/// A spring that what presses on it goes a firmness-th of its way into.
double Island::contact_stiffness(const Member& member, double other_mass) const {
  double mass = other_mass;
  for (const double point : member.cord->masses_) mass += point;
  for (std::size_t k = member.first_hold; k < member.last_hold; ++k)
    mass += 1.0 / rigid_[at(held_[k].rigid)].inverse_mass;
  return firmness * mass / (step_dt_ * step_dt_);
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
  pair.cord = static_cast<std::size_t>(&member - members_.data());
  return pair;
}

void Island::add_pair(const Member& member, ContactPair& pair, const RigidBody* body, double friction,
                      double restitution, std::uint64_t id, int feature) {
  const CordDef& def = member.cord->def_;
  pair.stiffness =
      contact_stiffness(member, body != nullptr && body->inverse_mass > 0.0 ? 1.0 / body->inverse_mass : 0.0);
  pair.friction = std::sqrt(def.friction * friction);
  pair.restitution = std::max(def.restitution, restitution);
  pair.touch.other = id;
  pair.touch.feature = feature;
  for (const Touch& touch : member.cord->touches_) {
    if (!touch.same_place(pair.touch)) continue;
    pair.touch = touch;
    break;
  }
  pair.touch.impulse = 0.0;
  contacts_.add(pair);
}

void Island::meet_circle(const Member& member, const RigidCircle& circle) {
  const RigidBody& body = rigid_[at(circle.body)];
  const Vec2 middle = body.position + circle.offset;
  const double reach = circle.radius + member.cord->def_.radius;
  const double margin = reach + room_ + room_of(body, circle.offset);
  if (!contains({reach_.low - Vec2{margin, margin}, reach_.high + Vec2{margin, margin}}, middle)) return;
  int disc = -1;
  for (int k = 0; k < links(*member.cord); ++k) {
    ContactPair pair = pair_with_link(member, k);
    if (!contains(box_around(positions_[at(pair.a)], positions_[at(pair.b)], margin), middle)) continue;
    if (disc < 0) disc = add_spot(circle.body, circle.offset);
    pair.disc = disc;
    pair.reach = reach;
    pair.disc_radius = circle.radius;
    add_pair(member, pair, &body, circle.friction, circle.restitution, circle.id, 2 * k);
  }
}

/// The cord's points against the inside of an edge; its ends are circles.
void Island::meet_segment(const Member& member, const RigidSegment& segment) {
  const Cord& cord = *member.cord;
  const RigidBody& body = rigid_[at(segment.body)];
  const double reach = segment.radius + cord.def_.radius;
  const double margin = reach + room_ + std::max(room_of(body, segment.a), room_of(body, segment.b));
  const Box box = box_around(body.position + segment.a, body.position + segment.b, margin);
  if (!overlap(box, reach_)) return;
  int a = -1;
  int b = -1;
  for (int k = 0; k < static_cast<int>(cord.outline_.size()); ++k) {
    const int point = static_cast<int>(member.first) + cord.outline_[at(k)];
    if (!contains(box, positions_[at(point)])) continue;
    if (a < 0) {
      a = add_spot(segment.body, segment.a);
      b = add_spot(segment.body, segment.b);
    }
    ContactPair pair;
    pair.disc = point;
    pair.a = a;
    pair.b = b;
    pair.ends = false;
    pair.reach = reach;
    pair.disc_radius = cord.def_.radius;
    pair.cord = static_cast<std::size_t>(&member - members_.data());
    add_pair(member, pair, &body, segment.friction, segment.restitution, segment.id, 2 * k + 1);
  }
}

void Island::meet_itself(const Member& /*member*/) {}

bool Island::left_room() const {
  if (contacts_.empty()) return false;
  for (std::size_t p = 0; p < count_; ++p) {
    const Vec2 way = positions_[p] - step_start_[p];
    if (!(dot(way, way) <= room_ * room_)) return true;
  }
  return false;
}

/// What touches at the end of the step, or did in it.
void Island::remember_contacts(const Member& member) {
  Cord& cord = *member.cord;
  cord.touches_.clear();
  cord.touch_changed_ = touch_changed_;
  const auto index = static_cast<std::size_t>(&member - members_.data());
  for (const ContactPair& pair : contacts_.pairs()) {
    if (pair.cord == index && (pair.touch.force > 0.0 || pair.touch.impulse > 0.0)) cord.touches_.push_back(pair.touch);
  }
}

/// Newton steps that go nowhere through anything, and down the stage's energy. They begin where the stage before ended
/// and go as far towards the guess as they can; what drives the cord goes its way along with them.
bool Island::touching_steps(Stage& stage, double time, std::span<const Vec2> from, CordReport& report) {
  contacts_.aim(time);
  std::fill(most_tensions_.begin(), most_tensions_.end(), 0.0);
  values_.clear();
  for (std::size_t p = 0; p < positions_.size(); ++p) direction_[p] = positions_[p] - from[p];
  std::copy(from.begin(), from.end(), positions_.begin());
  double left = 1.0;  // of the way of what drives
  go_led(left);
  for (int iteration = 0; iteration < touching_iterations; ++iteration) {
    ++report.iterations;
    if (left > 0.0) {
      for (std::size_t p = 0; p < positions_.size(); ++p) {
        direction_[p] = constrained_[p] != 0 ? predicted_[p] - positions_[p] : Vec2{};
      }
      go_led(left);
    }
    contacts_.evaluate(positions_);
    if (!newton_step(stage)) return false;
    const double moved = furthest();
    if (!(moved <= most_motion)) return false;
    for (std::size_t e = 0; e < next_.size(); ++e) {
      most_tensions_[e] = std::max(most_tensions_[e], penalty_factor * std::abs(next_[e]));
    }
    move(trial_, 1.0);
    const double free = contacts_.free_way(positions_, trial_, false, 1.0);
    const bool small = moved <= tolerance_ && free == 1.0;
    if (!(moved <= negligible_share * tolerance_) && !search(stage, free, iteration)) {
      return small && left == 0.0 && contacts_.is_straight(from, positions_);  // nearer than the merit can tell
    }
    positions_.swap(trial_);
    tensions_.swap(next_);
    if (small && left == 0.0 && contacts_.is_settled(positions_)) return contacts_.is_straight(from, positions_);
  }
  return false;
}

/// As far along the direction as nobody is in the way, together with what of the led way is left.
void Island::go_led(double& left) {
  move(trial_, 1.0);
  const double share = contacts_.free_way(positions_, trial_, true, 1.0);
  move(positions_, share);
  contacts_.lead(share);
  left *= 1.0 - share;
  if (left > 1e-9) return;
  left = 0.0;
  contacts_.lead(1.0);
  for (std::size_t p = 0; p < positions_.size(); ++p) {
    if (constrained_[p] != 0) positions_[p] = predicted_[p];
  }
}

/// The first of share, share/2, … of the direction that takes the merit below one of the last few, for one that only
/// falls cuts steps along curved ways short (Grippo, Lampariello & Lucidi 1986); in the end only one that falls.
bool Island::search(const Stage& stage, double share, int iteration) {
  values_.push_back(merit(stage, positions_));
  {
    while (values_.size() > (iteration > patient_iterations ? 1U : remembered_values)) values_.erase(values_.begin());
  }
  const double most = *std::max_element(values_.begin(), values_.end());
  for (; share >= shortest_step; share *= 0.5) {
    move(trial_, share);
    close_arms(trial_);
    if (merit(stage, trial_) < most) return true;
  }
  return false;
}

}  // namespace ribbon
