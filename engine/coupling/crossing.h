#pragma once

#include <optional>

#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// Returns the place, 0 … 1 from `p` to `q`, where the line between them crosses the segment from `a` to `b`. Nothing
/// if it does not.
inline std::optional<double> crossing(Vec2 p, Vec2 q, Vec2 a, Vec2 b) {
  const double side_p = cross(b - a, p - a);
  const double side_q = cross(b - a, q - a);
  if ((side_p < 0.0) == (side_q < 0.0)) return std::nullopt;
  const double share = side_p / (side_p - side_q);
  const double along = dot(p + share * (q - p) - a, b - a);
  if (along < 0.0 || along > dot(b - a, b - a)) return std::nullopt;
  return share;
}

}  // namespace ribbon::box2d
