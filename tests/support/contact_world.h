#pragma once

#include <vector>

#include "ribbon/cord.h"

namespace test_support {

/// A cord of the direct solver among bodies. The world moves bodies as the results of the cord's step say if they
/// touched it, and freely otherwise.
struct ContactWorld {
  explicit ContactWorld(const ribbon::CordDef& def) : cord(def) {}

  /// Adds a body of `mass` [kg], 0 for a kinematic one, and `inertia` [kg·m²], 0 for one that does not turn. Returns
  /// its index.
  int add_body(ribbon::Vec2 position, double mass, double inertia);
  /// Adds a body with one circle; returns its index.
  int add_ball(ribbon::Vec2 position, double radius, double mass, double friction);
  int add_peg(ribbon::Vec2 position, double radius, double friction) {
    return add_ball(position, radius, 0.0, friction);
  }
  void add_circle(int body, ribbon::Vec2 offset, double radius, double friction);
  /// Adds a segment from a to b, relative to the body's centre of mass, and its ends.
  void add_edge(int body, ribbon::Vec2 a, ribbon::Vec2 b, double radius, double friction);
  /// Adds four sides and corners.
  void add_box(int body, ribbon::Vec2 half, double radius, double friction);

  void step();

  ribbon::RigidBody& body(int index) { return bodies[static_cast<std::size_t>(index)]; }
  const ribbon::RigidBody& body(int index) const { return bodies[static_cast<std::size_t>(index)]; }
  /// Returns the largest penetration of a circle or edge into the cord's links and points, m; negative without contact.
  double depth() const;
  /// Returns the strain of the whole cord.
  double stretch() const;
  /// Returns the energy of the cord and the dynamic bodies, J.
  double energy() const;
  /// Return the momentum of the cord and the dynamic bodies, kg·m/s, and that about the origin, kg·m²/s.
  ribbon::Vec2 momentum() const;
  double angular_momentum() const;
  /// Returns the speed of the cord's fastest point, m/s.
  double fastest() const;

  ribbon::Cord cord;
  std::vector<ribbon::RigidBody> bodies{};
  std::vector<ribbon::RigidCircle> circles{};
  std::vector<ribbon::RigidSegment> segments{};
  std::vector<ribbon::Grip> grips{};
  std::vector<ribbon::Support> supports{};
  ribbon::Vec2 gravity{0.0, -9.81};
  double dt = 1.0 / 60.0;
  ribbon::IslandReport report{};  ///< of the last step
  ribbon::IslandReport total{};
  std::uint64_t next_id = 1;
};

/// Returns the points of an arc with `links` links of length l from a to b, below them, or above if `up`. The angle
/// between links is constant. The distance from a to b must be less than links·l.
std::vector<ribbon::Vec2> arc(ribbon::Vec2 a, ribbon::Vec2 b, int links, double l, bool up = false);

constexpr double bridge_mass = 0.42;  // kg
/// A cord of 4.2 m and bridge_mass, 4 cm thick, with friction 0.5, that hangs between pins 4 m apart.
ribbon::CordDef bridge_def();

/// Returns a cord in free flight among three balls.
ContactWorld free_flight(const ribbon::Accuracy& accuracy, double friction);

}  // namespace test_support
