#include "ribbon/island/ring_candidate.h"

#include <algorithm>
#include <cmath>

#include "ribbon/box.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "ribbon/system/overstretch.h"

namespace ribbon {
namespace {

constexpr double ring_radius = 1e-6;  // m: a rope turns around a ring at once
// The point that a wheel takes up is lumped with the ring. Of more of its body's mass than this, that would count as a
// change of energy wherever the next point takes its place.
constexpr double most_link_mass = 0.01;
constexpr double steps_ahead = 1.5;  // how far something may move in a step, in steps as it moves now
constexpr double sharp_bend = 0.99;  // cosine of the angle between two links, below which a hand is in a bend
// Shares of a link:
constexpr double sliding_share = 1e-3;  // from so far in a step on, the brake acts against the motion
constexpr double least_part = 0.6;      // between a ring and a point that it cannot take up: half of one stops a wheel
constexpr double most_misfit = 5e-3;    // between the rope and its way through an anchor that is beside it
constexpr double clearance = 0.25;      // around the part near a ring, in which nothing may be

/// Returns the tension of a part of this length [m] without damping, N: at a wheel there is none.
double undamped_tension(const CordParts& cord, int link, double length, double rest) {
  const double stiffness = cord.def.stretch_stiffness;
  return std::isfinite(stiffness) ? stiffness * (length / rest - 1.0) : cord.state.tensions[at(link)];
}

}  // namespace

double link_mass(const CordDef& def) { return def.mass_per_length * def.length / (def.points - 1); }

bool may_have_rings(const CordParts& cord) {
  return cord.def.rows == 1 && cord.def.bending_stiffness == 0.0 && cord.def.points >= 3 && !cord.def.self_contact &&
         cord.state.pulleys.empty() && !cord.is_reeling();
}

bool may_become_ring(const CordParts& cord, const Grip& grip, const RigidBody& body) {
  return std::isfinite(grip.strength) && grip.climb == 0.0 && grip.travel == Vec2{} &&
         link_mass(cord.def) * body.inverse_mass <= most_link_mass;
}

RingCandidate::RingCandidate(const IslandCord& of_cord, std::size_t of_grip, const RigidBody& body, double dt)
    : cord(of_cord), parts(of_cord.cord->parts()), index(of_grip) {
  const Grip& held = grip();
  const std::vector<double>& rest = parts.state.rest;
  taken_up = std::clamp(held.along < 0.5 ? held.point : held.point + 1, 1, parts.def.points - 2);
  const std::size_t first = at(taken_up - 1);
  for (std::size_t link = first; link < at(held.point); ++link) lead += rest[link];
  if (held.along > 0.0) lead += held.along * rest[at(held.point)];
  trail = rest[first] + rest[first + 1] - lead;
  const Vec2 arm = held.offset + held.beside;
  anchor = body.position + arm;
  velocity = body.velocity + body.angular_velocity * perp(arm);

  const auto nearing = [&](int point, Vec2 way) {
    const double size = length(way);
    return size > 0.0 ? dot(parts.state.velocities[at(point)] - velocity, way) / size : 0.0;
  };
  speed = 0.5 * (nearing(taken_up - 1, anchor - before()) + nearing(taken_up + 1, after() - anchor));
  slides = dt * std::abs(speed) / link();

  const bool is_at_point = held.along == 0.0 || held.along == 1.0;
  const auto& holders = parts.state.holders;
  const bool slid = std::any_of(holders.begin(), holders.end(), [of_grip](const Cord::Holder& holder) {
    return at(holder.grip) == of_grip && holder.slips;
  });
  runs = slides >= sliding_share ? speed : pulled();
  is_sliding = slid || (is_at_point && std::abs(pulled()) > held.strength);
  for (int p = std::max(1, taken_up - reach()); p <= std::min(parts.def.points - 2, taken_up + reach()); ++p) {
    const Vec2 in = parts.state.positions[at(p)] - parts.state.positions[at(p - 1)];
    const Vec2 out = parts.state.positions[at(p + 1)] - parts.state.positions[at(p)];
    const bool bends = dot(in, out) < sharp_bend * length(in) * length(out);
    is_near_bend = is_near_bend || bends;
    if (p == taken_up) is_in_bend = is_at_point && bends;
  }
}

int RingCandidate::reach() const { return 1 + static_cast<int>(std::min(std::ceil(steps_ahead * slides), 1e6)); }

void RingCandidate::begin(double sign) {
  is_sliding = true;
  runs = sign;
}

double RingCandidate::pulled() const {
  return parts.state.tensions[at(taken_up)] - parts.state.tensions[at(taken_up - 1)];
}

bool RingCandidate::has_place(std::span<const TiedPoint> tied, std::size_t member) const {
  // The point is at the anchor, or between them the rope is straight.
  const Vec2 point = parts.state.positions[at(taken_up)];
  const double way = length(anchor - before()) + length(after() - anchor);
  const double rope = length(point - before()) + length(after() - point);
  if (!(std::abs(way - rope) <= most_misfit * link()) || regained_length(parts) > 0.0) return false;

  const auto is_free = [&](int p) {
    return parts.state.kinds[at(p)] == PointKind::free &&
           std::none_of(tied.begin(), tied.end(),
                        [&](const TiedPoint& other) { return at(other.cord) == member && other.point == p; });
  };
  const int end = parts.def.points - 1;
  const double ahead = steps_ahead * slides;
  if ((taken_up - 1 < 1.0 + ahead && is_free(0)) || (taken_up + 1 > end - 1.0 - ahead && is_free(end))) return false;

  const auto may_be_taken_up = [&](int p) {
    const auto grips = cord.surroundings.grips;
    return p > 0 && p < end && is_free(p) && std::none_of(grips.begin(), grips.end(), [&](const Grip& other) {
             if (&other == &grip()) return false;
             const int last = other.along > 0.0 || std::isfinite(other.strength) ? other.point + 1 : other.point;
             return other.point <= p && last >= p;
           });
  };
  const double stop = (least_part + ahead) * link();
  return may_be_taken_up(taken_up) && (lead > stop || may_be_taken_up(taken_up - 1)) &&
         (trail > stop || may_be_taken_up(taken_up + 1));
}

bool RingCandidate::is_alone(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt) const {
  const Cord::State& state = parts.state;
  const int first = std::max(0, taken_up - reach());
  const int last = std::min(parts.def.points - 1, taken_up + reach());
  Box near = box_around(anchor, anchor, 0.0);
  double fastest = length(velocity);
  for (int p = first; p <= last; ++p) {
    near = joined(near, box_around(state.positions[at(p)], state.positions[at(p)], 0.0));
    fastest = std::max(fastest, length(state.velocities[at(p)]));
  }
  near = widened(near, parts.def.radius + clearance * link() + steps_ahead * dt * fastest);

  const auto meets = [&](int body, Vec2 a, Vec2 b, double radius) {
    if (body == grip().body) return false;
    const RigidBody& other = bodies[at(body)];
    const double margin = radius + steps_ahead * dt * length(other.velocity) + length(other.pushed);
    return overlap(box_around(other.position + a, other.position + b, margin), near);
  };
  const auto& circles = cord.surroundings.circles;
  const auto& segments = cord.surroundings.segments;
  if (std::any_of(circles.begin(), circles.end(),
                  [&](const RigidCircle& c) { return meets(c.body, c.offset, c.offset, c.radius); }) ||
      std::any_of(segments.begin(), segments.end(),
                  [&](const RigidSegment& s) { return meets(s.body, s.a, s.b, s.radius); })) {
    return false;
  }
  return std::none_of(cords.begin(), cords.end(), [&](const IslandCord& island_cord) {
    const CordParts& other = island_cord.cord->parts();
    if (&other == &parts || !other.meets(parts)) return false;
    for (std::size_t p = 0; p + at(other.def.rows) < other.size(); ++p) {
      const double margin = other.def.radius + steps_ahead * dt * length(other.state.velocities[p]);
      const Vec2 next = other.state.positions[p + at(other.def.rows)];
      if (overlap(box_around(other.state.positions[p], next, margin), near)) return true;
    }
    return false;
  });
}

Pulley RingCandidate::wheel() const {
  Pulley pulley;
  pulley.def.center = anchor;
  pulley.def.radius = ring_radius;
  pulley.def.counterclockwise = cross(anchor - before(), after() - anchor) >= 0.0;
  pulley.def.before = taken_up - 1;
  pulley.def.after = taken_up + 1;
  pulley.def.motor_torque = grip().strength * ring_radius;
  const double sense = pulley.def.counterclockwise ? 1.0 : -1.0;
  pulley.arrival = arriving_line(before() - anchor, ring_radius, sense).normal;
  pulley.departure = leaving_line(after() - anchor, ring_radius, sense).normal;
  pulley.arc = std::max(0.0, sense * angle_between(pulley.arrival, pulley.departure));
  pulley.lead = lead;
  pulley.speed = speed;
  pulley.tension_before = undamped_tension(parts, taken_up - 1, length(anchor - before()), lead);
  pulley.tension_after = undamped_tension(parts, taken_up, length(after() - anchor), trail);
  if (grip().strength > 0.0) pulley.motor_sign = std::copysign(1.0, -sense * runs);
  return pulley;
}

}  // namespace ribbon
