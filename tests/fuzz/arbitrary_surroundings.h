#pragma once

#include <vector>

#include "ribbon/rigid_circle.h"
#include "tests/fuzz/bytes.h"

namespace fuzz {

/// The surroundings of a cord from a fuzzer's bytes: up to three bodies, and up to three of each kind of their parts.
struct ArbitrarySurroundings {
  /// `points` is the number of points of the cord.
  ArbitrarySurroundings(Bytes& bytes, int points);

  ribbon::Surroundings view() { return {bodies, circles, grips, segments}; }

  std::vector<ribbon::RigidBody> bodies;
  std::vector<ribbon::RigidCircle> circles;
  std::vector<ribbon::RigidSegment> segments;
  std::vector<ribbon::Grip> grips;
};

}  // namespace fuzz
