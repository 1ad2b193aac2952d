#pragma once

#include <cstdint>

#include "ribbon/vec2.h"

namespace ribbon {

/// A contact of a cord, as it is stored from step to step and reported.
struct Touch {
  std::uint64_t other = 0;  ///< id of the circle, edge or other cord
  int feature = 0;          ///< 2·k for link k of the cord, 2·k + 1 for point k
  int other_feature = 0;    ///< the same for the other cord
  double force = 0.0;       ///< N, normal force
  double stuck = 0.0;       ///< m, elastic displacement of sticking friction
  double impulse = 0.0;     ///< N·s, normal impulse in the last step
  Vec2 point;               ///< m, contact point
  Vec2 normal;  ///< unit vector, from the cord's link to the other feature, or from the other link to the cord's point
  /// N·s, whole impulse of the cord on the other one in the last step, with friction and restitution. It is zero unless
  /// IslandCord::records_pushes is set for a cord that was solved together with it. A contact that only restitution has
  /// stopped has this impulse alone: its `impulse` and `force` are 0.
  Vec2 push{};

  bool operator==(const Touch&) const = default;
  /// Orders contacts by `other`, then by the cord's feature, then by the other feature.
  bool place_before(const Touch& b) const {
    if (other != b.other) return other < b.other;
    return feature != b.feature ? feature < b.feature : other_feature < b.other_feature;
  }
};

}  // namespace ribbon
