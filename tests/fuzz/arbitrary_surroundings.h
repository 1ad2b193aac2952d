#pragma once

#include <vector>

#include "ribbon/rigid_circle.h"
#include "tests/fuzz/bytes.h"

namespace fuzz {

/// The surroundings of a cord from a fuzzer's bytes: up to three bodies, and up to three of each kind of their parts.
struct ArbitrarySurroundings {
  /// `points` is the number of points of the cord.
  ArbitrarySurroundings(Bytes& bytes, int points);

  ribbon::Surroundings view() {
    ribbon::Surroundings surroundings{bodies, circles, grips, segments};
    surroundings.supports = supports;
    return surroundings;
  }

  std::vector<ribbon::RigidBody> bodies;
  std::vector<ribbon::RigidCircle> circles;
  std::vector<ribbon::RigidSegment> segments;
  std::vector<ribbon::Grip> grips;
  std::vector<ribbon::Support> supports;
};

}  // namespace fuzz
