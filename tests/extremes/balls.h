#pragma once

#include <vector>

#include "tests/extremes/tested_cord.h"

namespace extremes {

/// Circles in contact with a cord of any method. The class moves them by the results of the cord's step, without
/// gravity, in the same way for all methods.
class Balls {
 public:
  /// Adds a circle and returns its index. The mass is in kg; 0 makes it kinematic.
  int add(ribbon::Vec2 position, double radius, double mass, double friction = 0.3);
  ribbon::RigidBody& at(int index) { return bodies_[static_cast<std::size_t>(index)]; }

  /// Advances the cord and the circles by one tick.
  void step(TestedCord& cord, double dt, ribbon::Vec2 gravity);
  bool is_finite() const;

 private:
  std::vector<ribbon::RigidBody> bodies_;
  std::vector<ribbon::RigidCircle> circles_;
};

}  // namespace extremes
