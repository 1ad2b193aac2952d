#pragma once

#include <algorithm>

#include "ribbon/vec2.h"

namespace ribbon {

/// An axis-aligned box.
struct Box {
  Vec2 low;   ///< m, lower left corner
  Vec2 high;  ///< m, upper right corner; neither coordinate is below that of `low`

  bool operator==(const Box&) const = default;
};

/// Returns whether the boxes have a common point; their edges count.
inline bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Returns the box around the segment from a to b, extended by `margin` [m] on each side.
inline Box box_around(Vec2 a, Vec2 b, double margin) {
  return {{std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
          {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin}};
}

/// Returns the smallest box that contains both.
inline Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// Returns the box extended by `margin` [m] on each side.
inline Box widened(const Box& box, double margin) {
  return {box.low - Vec2{margin, margin}, box.high + Vec2{margin, margin}};
}

}  // namespace ribbon
