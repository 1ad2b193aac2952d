#include "ribbon/system/wheel_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "ribbon/geometry/rotation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double accepted_misfit = 0.1;
constexpr double least_arc = -0.1;  // rad, from which on a cord that barely touches a wheel counts as beside it

double sum_of_rest(const CordParts& cord, const PulleyDef& def) {
  double sum = 0.0;
  for (int link = def.before; link < def.after; ++link) sum += cord.state.rest[at(link)];
  return sum;
}

}  // namespace

PathPlace place_on_path(const WheelPath& path, double distance) {
  const TangentLine& in = path.before;
  const TangentLine& out = path.after;
  if (distance < path.lead) {
    const double left = (path.lead - distance) / path.lead * in.length;
    return {path.center + path.radius * in.normal - left * in.along, in.along};
  }
  const double on_wheel = distance - path.lead;
  const double arc = path.radius * path.arc;
  if (on_wheel < arc) {
    const Vec2 normal = times(rotation(path.sense * on_wheel / path.radius), in.normal);
    return {path.center + path.radius * normal, path.sense * perp(normal)};
  }
  const double behind = path.trail > 0.0 ? (on_wheel - arc) / path.trail * out.length : 0.0;
  return {path.center + path.radius * out.normal + behind * out.along, out.along};
}

double trail_of(const CordParts& cord, const Pulley& pulley) {
  return sum_of_rest(cord, pulley.def) - pulley.lead - pulley.def.radius * pulley.arc;
}

double mass_on_wheel(const CordParts& cord, const PulleyDef& def) {
  double sum = 0.0;
  for (int p = def.before + 1; p < def.after; ++p) sum += cord.state.masses[at(p)];
  return sum;
}

double wheel_mass(const PulleyDef& def) { return def.inertia / (def.radius * def.radius); }

namespace {

void check_free_part(const CordParts& cord, const PulleyDef& def) {
  check(def, cord.def.points);
  if (cord.def.rows > 1 || cord.def.bending_stiffness > 0.0) {
    throw CallError("a ribbon or a stiff cord has no pulley; accepted is a rope without bending stiffness");
  }
  for (int p = def.before + 1; p < def.after; ++p) {
    if (cord.state.kinds[at(p)] == PointKind::free) continue;
    throw CallError("point " + std::to_string(p) + " is fixed; accepted are free points on a wheel");
  }
  for (const Pulley& other : cord.state.pulleys) {
    if (def.after <= other.def.before || def.before >= other.def.after) continue;
    throw CallError("points " + std::to_string(def.before) + " to " + std::to_string(def.after) +
                    " are on another wheel; accepted are ones before or behind it");
  }
}

/// The part of the cord between its points fits the path around the wheel, but for a few percent: the definition's
/// lengths and what is laid by hand need not agree to the last digit.
void check_fit(const PulleyDef& def, double part, double trail, double straight) {
  const double off = std::abs(trail - straight);
  if (off < accepted_misfit * part && trail > 0.0) return;
  throw DefinitionError("a cord of " + std::to_string(part) + " m between points " + std::to_string(def.before) +
                        " and " + std::to_string(def.after) + " does not fit a path of " +
                        std::to_string(part - trail + straight) +
                        " m around the wheel; accepted is a tenth more or less");
}

}  // namespace

Pulley make_pulley(CordParts& cord, const PulleyDef& def) {
  check_free_part(cord, def);
  const double sense = def.counterclockwise ? 1.0 : -1.0;
  const TangentLine in = arriving_line(cord.state.positions[at(def.before)] - def.center, def.radius, sense);
  const TangentLine out = leaving_line(cord.state.positions[at(def.after)] - def.center, def.radius, sense);
  const double angle = sense * angle_between(in.normal, out.normal);
  Pulley pulley;
  pulley.def = def;
  pulley.lead = in.length;
  pulley.arc = (angle < least_arc ? angle + turn : angle) + def.turns * turn;
  pulley.arrival = in.normal;
  pulley.departure = out.normal;
  const double trail = trail_of(cord, pulley);
  check_fit(def, sum_of_rest(cord, def), trail, out.length);
  const WheelPath path{def.center, def.radius, sense, in, out, pulley.lead, pulley.arc, trail};
  double distance = 0.0;
  for (int p = def.before + 1; p < def.after; ++p) {
    distance += cord.state.rest[at(p - 1)];
    cord.state.positions[at(p)] = place_on_path(path, distance).position;
    cord.state.velocities[at(p)] = {};
  }
  return pulley;
}

namespace {

// Of a link, beside the way of one and a half steps: how near to a wheel a point is taken up, and how far from it a
// point is let go.
constexpr double taken_up = 0.5;
constexpr double let_go = 0.7;
constexpr double steps_ahead = 1.5;
constexpr double stop = 0.5;           // radii that the end of a cord, and what holds it, keeps from a wheel
constexpr double most_turned = 0.3;    // rad
constexpr double left_of_link = 0.25;  // that a line which turns does not wind up

/// A pulley of a cord, at the start of a step.
class PointMover {
 public:
  PointMover(CordParts& cord, std::size_t index, const Surroundings& surroundings, std::span<const RigidBody> bodies,
             const std::function<bool(int)>& is_tied, double dt)
      : cord_(cord),
        pulley_(cord.state.pulleys[index]),
        reach_(cord.reaches[index]),
        surroundings_(surroundings),
        is_tied_(is_tied),
        dt_(dt) {
    const Axle& axle = surroundings.axles[index];
    const RigidBody& body = bodies[at(axle.body)];
    center_ = body.position + axle.offset;
    velocity_ = body.velocity + body.angular_velocity * perp(axle.offset);
    sense_ = pulley_.def.counterclockwise ? 1.0 : -1.0;
    if (index > 0) first_ = cord.state.pulleys[index - 1].def.after;
    last_ = index + 1 < cord.state.pulleys.size() ? cord.state.pulleys[index + 1].def.before : cord.def.points - 1;
  }

  void move() {
    follow_lines();
    meet_keeper();
    if (pulley_.blocked * (pulley_.tension_after - pulley_.tension_before) < 0.0) pulley_.blocked = 0.0;
    while (pulley_.blocked <= 0.0 && let_go_before()) {
    }
    while (pulley_.blocked >= 0.0 && let_go_after()) {
    }
    while (take_up_before()) {
    }
    while (take_up_after()) {
    }
    const bool stays = pulley_.blocked > 0.0 ? !can_take_up_before() : !can_take_up_after();
    if (!stays) pulley_.blocked = 0.0;
  }

 private:
  Vec2& x(int point) { return cord_.state.positions[at(point)]; }
  Vec2& v(int point) { return cord_.state.velocities[at(point)]; }
  double rest(int link) const { return cord_.state.rest[at(link)]; }
  double radius() const { return pulley_.def.radius; }
  double trail() const { return trail_of(cord_, pulley_); }
  TangentLine in() { return line_to_groove(x(pulley_.def.before) - center_, radius(), pulley_.arrival); }
  TangentLine out() { return line_from_groove(x(pulley_.def.after) - center_, radius(), pulley_.departure); }
  /// m, from the centre to where a point will be at the end of the step, as it moves now.
  Vec2 coming(int point) { return x(point) - center_ + dt_ * (v(point) - velocity_); }

  /// Moves the places where the cord arrives and leaves to where the lines will be tangent. The cord in the groove
  /// stays. In a step they turn by no more than an angle at which the lengths hardly change, and wind up no more than
  /// is there.
  void follow_lines() {
    if (pulley_.kept) return;
    // winding: the sense in which the line has to turn to wind up some of the part, of this length beside what stays
    const auto turn_to = [this](Vec2& normal, const TangentLine& line, double winding, double part) {
      const double angle = angle_between(normal, line.normal);
      const double most_wound = std::clamp(part / radius(), 0.0, most_turned);
      const double turned = winding * std::clamp(winding * angle, -most_turned, most_wound);
      normal = turned == angle ? line.normal : times(rotation(turned), normal);
      return sense_ * turned;
    };
    const Vec2 before = coming(pulley_.def.before);
    const Vec2 after = coming(pulley_.def.after);
    const double lead = pulley_.lead - left_of_link * rest(pulley_.def.before);
    const double behind = trail() - left_of_link * rest(pulley_.def.after - 1);
    const double arriving = turn_to(pulley_.arrival, arriving_line(before, radius(), sense_), -sense_, lead);
    const double leaving = turn_to(pulley_.departure, leaving_line(after, radius(), sense_), sense_, behind);
    pulley_.lead += radius() * arriving;
    pulley_.arc += leaving - arriving;
  }

  /// The cord is kept from where its angle of contact has become negative until it bends towards the wheel again. Both
  /// lines meet the groove at one place then: in the middle, unless less of a part is there than that takes.
  void meet_keeper() {
    if (!pulley_.kept && pulley_.arc < 0.0) {
      const double taken = -radius() * pulley_.arc;
      const double most = pulley_.lead - left_of_link * rest(pulley_.def.before);
      const double least = taken - (trail() - left_of_link * rest(pulley_.def.after - 1));
      const double share = std::clamp(std::max(least, std::min(most, 0.5 * taken)) / taken, 0.0, 1.0);
      const Vec2 between = (1.0 - share) * pulley_.arrival + share * pulley_.departure;
      pulley_.lead -= share * taken;
      pulley_.arrival = pulley_.departure = (1.0 / length(between)) * between;
      pulley_.arc = 0.0;
      pulley_.kept = true;
    } else if (pulley_.kept && sense_ * cross(in().along, out().along) > 0.0) {
      pulley_.kept = false;
    }
  }

  /// m, within which a point that nears the wheel at this speed is taken up, or beyond which one is let go. `reach` is
  /// how far the cord runs as the last attempt at the step showed.
  double margin(double share, double link, double nearing, double reach) const {
    return share * link + std::max(steps_ahead * dt_ * std::max(0.0, nearing), reach);
  }
  double margin_before(double share, double link, const TangentLine& line) {
    return margin(share, link, dot(line.along, v(pulley_.def.before) - velocity_), reach_.before);
  }
  double margin_after(double share, double link, const TangentLine& line) {
    return margin(share, link, -dot(line.along, v(pulley_.def.after) - velocity_), reach_.after);
  }

  bool is_free(int point) const {
    if (cord_.state.kinds[at(point)] != PointKind::free || is_tied_(point)) return false;
    return std::none_of(surroundings_.grips.begin(), surroundings_.grips.end(), [point](const Grip& grip) {
      return grip.point == point || ((grip.along > 0.0 || std::isfinite(grip.strength)) && grip.point + 1 == point);
    });
  }

  bool can_take_up_before() const { return pulley_.def.before - 1 >= first_ && is_free(pulley_.def.before); }
  bool can_take_up_after() const { return pulley_.def.after + 1 <= last_ && is_free(pulley_.def.after); }

  bool take_up_before() {
    const int point = pulley_.def.before;
    const TangentLine line = in();
    const double link = rest(point);
    const bool ends = !can_take_up_before();
    if (!(pulley_.lead < margin_before(taken_up, link, line) + (ends ? stop * radius() : 0.0))) return false;
    if (ends) return block(1.0, reach_.before);
    share_momentum(point, line.along);
    pulley_.lead += rest(point - 1);
    pulley_.def.before = point - 1;
    cord_.state.restart = true;
    return true;
  }

  bool take_up_after() {
    const int point = pulley_.def.after;
    const TangentLine line = out();
    const double link = rest(point - 1);
    const bool ends = !can_take_up_after();
    if (!(trail() < margin_after(taken_up, link, line) + (ends ? stop * radius() : 0.0))) return false;
    if (ends) return block(-1.0, reach_.after);
    share_momentum(point, line.along);
    pulley_.def.after = point + 1;
    cord_.state.restart = true;
    return true;
  }

  /// Returns whether a ring would have no point without this one.
  bool is_last(int point) const {
    return cord_.has_rings && pulley_.def.before + 1 == point && point + 1 == pulley_.def.after;
  }

  bool let_go_before() {
    const int point = pulley_.def.before + 1;
    const TangentLine line = in();
    const double link = rest(point - 1);
    const double ahead = pulley_.lead - link;
    if (point >= pulley_.def.after || is_last(point) || !(ahead > margin_before(let_go, link, line))) return false;
    place(point, pulley_.def.before, line, -ahead / pulley_.lead);
    pulley_.lead = ahead;
    pulley_.def.before = point;
    cord_.state.restart = true;
    return true;
  }

  bool let_go_after() {
    const int point = pulley_.def.after - 1;
    const TangentLine line = out();
    const double link = rest(point);
    const double behind = trail() - link;
    if (point <= pulley_.def.before || is_last(point) || !(behind > margin_after(let_go, link, line))) return false;
    place(point, pulley_.def.after, line, behind / trail());
    pulley_.def.after = point;
    cord_.state.restart = true;
    return true;
  }

  /// Places a point on a line, at a signed share of its length from the wheel, with a velocity between those of the
  /// groove and of the point at its end.
  void place(int point, int end, const TangentLine& line, double share) {
    x(point) = center_ + pulley_.def.radius * line.normal + share * line.length * line.along;
    const Vec2 across = perp(line.along);
    v(point) = velocity_ + pulley_.speed * line.along + std::abs(share) * dot(across, v(end) - velocity_) * across;
  }

  /// The groove takes over the momentum of a point along the cord.
  void share_momentum(int point, Vec2 along) {
    const double mass = cord_.state.masses[at(point)];
    const double own = mass_on_wheel(cord_, pulley_.def) + (pulley_.slip_sign == 0.0 ? wheel_mass(pulley_.def) : 0.0);
    const double speed = dot(along, v(point) - velocity_);
    pulley_.speed = (own * pulley_.speed + mass * speed) / (own + mass);
  }

  /// The cord cannot run further, because of what is at the point or because it ends there.
  bool block(double direction, double reach) {
    pulley_.blocked = direction;
    reach_.blocks = reach > 0.0;
    return false;
  }

  CordParts& cord_;
  Pulley& pulley_;
  WheelReach& reach_;
  const Surroundings& surroundings_;
  const std::function<bool(int)>& is_tied_;
  double dt_;
  Vec2 center_;
  Vec2 velocity_;
  double sense_ = 1.0;
  int first_ = 0;  // the first and the last point that may be the one before or behind the wheel
  int last_ = 0;
};

}  // namespace

void move_points_over_wheels(std::span<const IslandCord> cords, std::span<const TiedPoint> tied,
                             std::span<const RigidBody> bodies, double dt, bool first) {
  for (std::size_t m = 0; m < cords.size(); ++m) {
    const IslandCord& cord = cords[m];
    CordParts& parts = cord.cord->parts();
    const auto is_tied = [&tied, m](int point) {
      return std::any_of(tied.begin(), tied.end(),
                         [&](const TiedPoint& other) { return at(other.cord) == m && other.point == point; });
    };
    if (first) parts.reaches.assign(parts.state.pulleys.size(), {});
    for (std::size_t k = 0; k < parts.state.pulleys.size(); ++k) {
      PointMover(parts, k, cord.surroundings, bodies, is_tied, dt).move();
    }
    if (!parts.state.pulleys.empty()) parts.leave_out_links_on_wheels();
  }
}

}  // namespace ribbon
