#pragma once

#include <cstdint>

#include "ribbon/vec2.h"

namespace ribbon {

/// What a cord remembers of a contact from one step to the next, and tells about it.
struct Touch {
  std::uint64_t other = 0;  ///< the id of the circle or segment, or of the other cord
  int feature = 0;          ///< which of the cord's points or links, twice that, and 1 more for a point
  int other_feature = 0;    ///< which of the other cord's
  double force = 0.0;       ///< N, along the normal
  double stuck = 0.0;       ///< m, how far friction's anchor is stretched
  double impulse = 0.0;     ///< N·s, given in the last step along the normal
  Vec2 point;               ///< m, where it is
  Vec2 normal;              ///< from the cord's link to what touches it, or from the other's to the cord's point

  bool operator==(const Touch&) const = default;
  /// Orders touches by place: what is touched, and where.
  bool place_before(const Touch& b) const {
    if (other != b.other) return other < b.other;
    return feature != b.feature ? feature < b.feature : other_feature < b.other_feature;
  }
};

}  // namespace ribbon
