#pragma once

#include <vector>

#include "tests/extremes/subject.h"

namespace extremes {

/// Circles in contact with a cord of any method. The class moves them by the results of the cord's step, without
/// gravity, so that they move alike with all methods.
class Balls {
 public:
  /// kg, 0 of one that goes its way at its velocity. Its index.
  int add(ribbon::Vec2 position, double radius, double mass, double friction = 0.3);
  ribbon::RigidBody& at(int index) { return bodies_[static_cast<std::size_t>(index)]; }

  /// One tick of the cord and the balls.
  void step(Subject& cord, double dt, ribbon::Vec2 gravity);
  bool is_finite() const;

 private:
  std::vector<ribbon::RigidBody> bodies_;
  std::vector<ribbon::RigidCircle> circles_;
};

}  // namespace extremes
