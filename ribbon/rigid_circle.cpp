#include "ribbon/rigid_circle.h"

#include <cmath>
#include <string>

#include "ribbon/definition.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double max_component = 1e10;     // m, m/s, rad/s
constexpr double max_time = 1e12;          // s
constexpr double max_acceleration = 1e20;  // m/s²
constexpr double max_normal_error = 1e-3;  // of the length of a unit vector

/// An entry of a list that is checked. Its name is built only for an error message.
class Entry {
 public:
  Entry(const char* list, std::size_t index) : list_(list), index_(index) {}

  void check(const char* field, double value, double low, double high) const {
    if (!(value >= low && value <= high)) check_range(name(field).c_str(), value, low, high);
  }
  void check(const char* field, Vec2 value, double max = max_component) const {
    check(field, value.x, -max, max);
    check(field, value.y, -max, max);
  }
  void check_index(const char* field, int value, std::size_t count) const {
    if (value >= 0 && at(value) < count) return;
    throw DefinitionError(name(field) + " is " + std::to_string(value) + "; accepted is an index below " +
                          std::to_string(count));
  }
  [[noreturn]] void refuse(const char* field, const char* value, const char* accepted) const {
    throw DefinitionError(name(field) + " is " + value + "; accepted is " + accepted);
  }

 private:
  std::string name(const char* field) const { return std::string(list_) + "[" + std::to_string(index_) + "]." + field; }

  const char* list_;
  std::size_t index_;
};

void check_body(const Entry& entry, const RigidBody& body) {
  entry.check("position", body.position);
  entry.check("velocity", body.velocity);
  entry.check("angular_velocity", body.angular_velocity, -max_component, max_component);
  entry.check("inverse_mass", body.inverse_mass, 0.0, largest);
  entry.check("inverse_inertia", body.inverse_inertia, 0.0, largest);
  entry.check("acceleration", body.acceleration, max_acceleration);
  entry.check("pushed", body.pushed);
  entry.check("pushed_turn", body.pushed_turn, -max_component, max_component);
}

void check_surface(const Entry& entry, double friction, double restitution, double tangent_speed) {
  entry.check("tangent_speed", tangent_speed, -max_component, max_component);
  entry.check("friction", friction, 0.0, 10.0);
  entry.check("restitution", restitution, 0.0, 1.0);
}

void check_grip(const Entry& entry, const Grip& grip) {
  entry.check("offset", grip.offset);
  entry.check("travel", grip.travel);
  entry.check("beside", grip.beside);
  entry.check("along", grip.along, 0.0, 1.0);
  entry.check("across", grip.across, 1.0);
  entry.check("climb", grip.climb, -max_component, max_component);
  entry.check("strength", grip.strength, 0.0, std::numeric_limits<double>::infinity());
}

void check_other(const Entry& entry, const Support& support, std::size_t bodies) {
  if (support.other == -1) return;
  entry.check_index("other", support.other, bodies);
  if (support.other == support.body) entry.refuse("other", "the supported body", "another one, or -1");
}

void check_support(const Entry& entry, const Support& support) {
  entry.check("arm", support.arm);
  entry.check("other_arm", support.other_arm);
  entry.check("normal", support.normal, 1.0);
  if (const double size = length(support.normal); std::abs(size - 1.0) > max_normal_error) {
    entry.check("the length of normal", size, 1.0 - max_normal_error, 1.0 + max_normal_error);
  }
  entry.check("gap", support.gap, 0.0, max_component);
  entry.check("speed", support.speed, -max_component, max_component);
}

}  // namespace

Vec2 RigidBody::start_of(Vec2 arm) const {
  return was_pushed() ? start() + times(rotation(-pushed_turn), arm) : position + arm;
}

void check_bodies(std::span<const RigidBody> bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) check_body({"bodies", k}, bodies[k]);
}

void check_surroundings(const Surroundings& surroundings, std::size_t bodies, int points, int rows) {
  check_range("time", surroundings.time, -max_time, max_time);
  for (std::size_t k = 0; k < surroundings.circles.size(); ++k) {
    const RigidCircle& circle = surroundings.circles[k];
    const Entry entry("circles", k);
    entry.check_index("body", circle.body, bodies);
    entry.check("offset", circle.offset);
    entry.check("radius", circle.radius, 0.0, max_component);
    check_surface(entry, circle.friction, circle.restitution, circle.tangent_speed);
  }
  for (std::size_t k = 0; k < surroundings.segments.size(); ++k) {
    const RigidSegment& segment = surroundings.segments[k];
    const Entry entry("segments", k);
    entry.check_index("body", segment.body, bodies);
    entry.check("a", segment.a);
    entry.check("b", segment.b);
    entry.check("radius", segment.radius, 0.0, max_component);
    check_surface(entry, segment.friction, segment.restitution, segment.tangent_speed);
  }
  for (std::size_t k = 0; k < surroundings.grips.size(); ++k) {
    const Grip& grip = surroundings.grips[k];
    const Entry entry("grips", k);
    entry.check_index("body", grip.body, bodies);
    entry.check_index("point", grip.point, at(points));
    check_grip(entry, grip);
    if (rows > 0 && grip.point >= points - rows) entry.check("along", grip.along, 0.0, 0.0);
  }
  for (std::size_t k = 0; k < surroundings.axles.size(); ++k) {
    const Entry entry("axles", k);
    entry.check_index("body", surroundings.axles[k].body, bodies);
    entry.check("offset", surroundings.axles[k].offset);
  }
  for (std::size_t k = 0; k < surroundings.supports.size(); ++k) {
    const Entry entry("supports", k);
    const Support& support = surroundings.supports[k];
    entry.check_index("body", support.body, bodies);
    check_other(entry, support, bodies);
    check_support(entry, support);
  }
}

void check_step(double dt, Vec2 gravity) {
  check_range("dt", dt, 1e-9, 1.0);
  check_coordinates("gravity", gravity);
}

}  // namespace ribbon
