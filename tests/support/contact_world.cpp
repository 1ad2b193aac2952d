#include "tests/support/contact_world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ribbon/cord_forces.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/separation.h"
#include "ribbon/system/held_body.h"
#include "tests/support/move_body.h"

namespace test_support {

using ribbon::RigidBody;
using ribbon::Vec2;

int ContactWorld::add_body(Vec2 position, double mass, double inertia) {
  RigidBody body;
  body.position = position;
  if (mass > 0.0) {
    body.inverse_mass = 1.0 / mass;
    body.acceleration = gravity;
  }
  if (inertia > 0.0) body.inverse_inertia = 1.0 / inertia;
  bodies.push_back(body);
  return static_cast<int>(bodies.size()) - 1;
}

int ContactWorld::add_ball(Vec2 position, double radius, double mass, double friction) {
  const int index = add_body(position, mass, 0.5 * mass * radius * radius);
  add_circle(index, {}, radius, friction);
  return index;
}

void ContactWorld::add_circle(int body, Vec2 offset, double radius, double friction) {
  circles.push_back({body, offset, radius, friction, 0.0, next_id++});
}

void ContactWorld::add_edge(int body, Vec2 a, Vec2 b, double radius, double friction) {
  segments.push_back({body, a, b, radius, friction, 0.0, next_id++});
  add_circle(body, a, radius, friction);
  add_circle(body, b, radius, friction);
}

void ContactWorld::add_box(int body, Vec2 half, double radius, double friction) {
  const std::array<Vec2, 4> corners = {Vec2{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
  for (std::size_t k = 0; k < 4; ++k) {
    segments.push_back({body, corners[k], corners[(k + 1) % 4], radius, friction, 0.0, next_id++});
    add_circle(body, corners[k], radius, friction);
  }
}

void ContactWorld::step() {
  for (RigidBody& body : bodies) {
    body.impulse = {};
    body.angular_impulse = 0.0;
    body.solved = false;
  }
  ribbon::Surroundings surroundings{bodies, circles, grips, segments};
  surroundings.supports = supports;
  report = cord.step(dt, gravity, surroundings);
  total += report;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    RigidBody& body = bodies[k];
    const Vec2 turn = ribbon::rotation(move_body(body, dt));
    const auto is_on = [k](int index) { return static_cast<std::size_t>(index) == k; };
    for (ribbon::RigidCircle& circle : circles) {
      if (is_on(circle.body)) circle.offset = times(turn, circle.offset);
    }
    for (ribbon::RigidSegment& segment : segments) {
      if (!is_on(segment.body)) continue;
      segment.a = times(turn, segment.a);
      segment.b = times(turn, segment.b);
    }
    for (ribbon::Grip& grip : grips) {
      if (is_on(grip.body)) grip.offset = times(turn, grip.offset + grip.travel);
    }
  }
}

double ContactWorld::depth() const {
  double deepest = -std::numeric_limits<double>::infinity();
  const auto x = cord.positions();
  const ribbon::CordDef& def = cord.def();
  const auto at = [&](int i, int j) { return x[static_cast<std::size_t>(cord.index(i, j))]; };
  for (const ribbon::RigidCircle& circle : circles) {
    const Vec2 middle = body(circle.body).position + circle.offset;
    const auto meet = [&](Vec2 a, Vec2 b) {
      deepest = std::max(deepest, circle.radius + def.radius - ribbon::find_separation(middle, a, b).distance);
    };
    for (const int j : {0, def.rows - 1}) {
      for (int i = 0; i + 1 < def.points; ++i) meet(at(i, j), at(i + 1, j));
    }
    for (const int i : {0, def.points - 1}) {
      for (int j = 0; j + 1 < def.rows; ++j) meet(at(i, j), at(i, j + 1));
    }
  }
  for (const ribbon::RigidSegment& segment : segments) {
    const Vec2 center = body(segment.body).position;
    for (const Vec2 point : x) {
      const double distance = ribbon::find_separation(point, center + segment.a, center + segment.b).distance;
      deepest = std::max(deepest, segment.radius + def.radius - distance);
    }
  }
  return deepest;
}

double ContactWorld::stretch() const {
  double sum = 0.0;
  for (std::size_t p = 1; p < cord.positions().size(); ++p) {
    sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  }
  return sum / cord.def().length - 1.0;
}

double ContactWorld::energy() const {
  double sum = energy_of(cord, gravity).total();
  for (const RigidBody& body : bodies) {
    if (body.inverse_mass == 0.0) continue;
    sum += (0.5 * dot(body.velocity, body.velocity) - dot(body.acceleration, body.position)) / body.inverse_mass;
    if (body.inverse_inertia > 0.0) sum += 0.5 * body.angular_velocity * body.angular_velocity / body.inverse_inertia;
  }
  return sum;
}

Vec2 ContactWorld::momentum() const {
  Vec2 sum;
  for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
  for (const RigidBody& body : bodies) {
    if (body.inverse_mass > 0.0) sum += (1.0 / body.inverse_mass) * body.velocity;
  }
  return sum;
}

double ContactWorld::angular_momentum() const {
  double sum = 0.0;
  for (int p = 0; p < cord.size(); ++p) {
    const auto i = static_cast<std::size_t>(p);
    sum += cord.mass(p) * cross(cord.positions()[i], cord.velocities()[i]);
  }
  for (const RigidBody& body : bodies) {
    if (body.inverse_mass > 0.0) sum += cross(body.position, body.velocity) / body.inverse_mass;
    if (body.inverse_inertia > 0.0) sum += body.angular_velocity / body.inverse_inertia;
  }
  return sum;
}

double ContactWorld::fastest() const {
  double speed = 0.0;
  for (const Vec2 v : cord.velocities()) speed = std::max(speed, length(v));
  return speed;
}

std::vector<Vec2> arc(Vec2 a, Vec2 b, int links, double l, bool up) {
  // With links turned by 2α/links from −α to α the chord is l·Σcos.
  const auto heading = [links](double alpha, int k) { return alpha * (2.0 * (k + 0.5) / links - 1.0); };
  double low = 0.0;
  double high = 3.0;
  for (int n = 0; n < 80; ++n) {
    const double alpha = 0.5 * (low + high);
    double chord = 0.0;
    for (int k = 0; k < links; ++k) chord += l * std::cos(heading(alpha, k));
    (chord > length(b - a) ? low : high) = alpha;
  }
  const Vec2 along = (1.0 / length(b - a)) * (b - a);
  std::vector<Vec2> points = {a};
  for (int k = 0; k < links; ++k) {
    const double turned = (up ? -1.0 : 1.0) * heading(low, k);
    points.push_back(points.back() + l * times(along, Vec2{std::cos(turned), std::sin(turned)}));
  }
  return points;
}

ribbon::CordDef bridge_def() {
  ribbon::CordDef def;
  def.points = 41;
  def.length = 4.2;
  def.radius = 0.02;
  def.mass_per_length = 0.1;
  def.friction = 0.5;
  def.positions = arc({0.0, 0.0}, {4.0, 0.0}, 40, 0.105);
  def.pins = {0, 40};
  return def;
}

ContactWorld free_flight(const ribbon::Accuracy& accuracy, double friction) {
  ribbon::CordDef def;
  def.points = 31;
  def.length = 3.0;
  def.radius = 0.02;
  def.mass_per_length = 0.5;
  def.friction = friction;
  def.accuracy = accuracy;
  ContactWorld world(def);
  world.gravity = {};
  world.add_ball({0.8, 0.7}, 0.2, 0.3, 0.5);
  world.add_ball({1.6, -0.6}, 0.15, 3.0, 0.5);
  world.add_ball({2.5, 0.9}, 0.25, 1.0, 0.5);
  world.body(0).velocity = {0.3, -2.0};
  world.body(1).velocity = {-0.2, 1.5};
  world.body(2).velocity = {-0.5, -1.0};
  world.body(2).angular_velocity = 5.0;
  return world;
}

}  // namespace test_support
