#pragma once

#include <vector>

#include "ribbon/cord.h"

namespace test_support {

/// A cord of the direct solver among bodies that are moved as their owner would: where the cord says if it met them,
/// freely otherwise.
struct ContactWorld {
  explicit ContactWorld(const ribbon::CordDef& def) : cord(def) {}

  /// A body of `mass` [kg], 0 for one that nothing pushes; `inertia` [kg·m²], 0 for one that does not turn. Its index.
  int add_body(ribbon::Vec2 position, double mass, double inertia);
  /// A body of one circle; its index.
  int add_ball(ribbon::Vec2 position, double radius, double mass, double friction);
  int add_peg(ribbon::Vec2 position, double radius, double friction) {
    return add_ball(position, radius, 0.0, friction);
  }
  void add_circle(int body, ribbon::Vec2 offset, double radius, double friction);
  /// A segment from a to b, from the body's centre of mass, with its ends.
  void add_edge(int body, ribbon::Vec2 a, ribbon::Vec2 b, double radius, double friction);
  /// Its four sides and corners.
  void add_box(int body, ribbon::Vec2 half, double radius, double friction);

  void step();

  ribbon::RigidBody& body(int index) { return bodies[static_cast<std::size_t>(index)]; }
  const ribbon::RigidBody& body(int index) const { return bodies[static_cast<std::size_t>(index)]; }
  /// m, how deep a circle or edge is in the cord's links and points, at the deepest; negative if nothing touches.
  double depth() const;
  /// How much longer than at rest the cord is, as a share.
  double stretch() const;
  /// J, of the cord and of what moves.
  double energy() const;
  /// kg·m/s, of the cord and of what moves; and about the origin, kg·m²/s.
  ribbon::Vec2 momentum() const;
  double angular_momentum() const;
  /// m/s, of the cord's fastest point.
  double fastest() const;

  ribbon::Cord cord;
  std::vector<ribbon::RigidBody> bodies{};
  std::vector<ribbon::RigidCircle> circles{};
  std::vector<ribbon::RigidSegment> segments{};
  std::vector<ribbon::Grip> grips{};
  ribbon::Vec2 gravity{0.0, -9.81};
  double dt = 1.0 / 60.0;
  ribbon::CordReport report{};  ///< of the last step
  ribbon::CordReport total{};
  std::uint64_t next_id = 1;
};

/// Points of a cord of links of length l from a to b that hangs, or stands if `up`, in an arc between them: each link
/// turned by the same angle from the one before. The distance is less than links·l.
std::vector<ribbon::Vec2> arc(ribbon::Vec2 a, ribbon::Vec2 b, int links, double l, bool up = false);

constexpr double bridge_mass = 0.42;  // kg
/// A cord of 4.2 m and bridge_mass, 4 cm thick, with friction 0.5, that hangs between pins 4 m apart.
ribbon::CordDef bridge_def();

}  // namespace test_support
