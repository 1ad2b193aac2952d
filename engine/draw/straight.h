#pragma once

#include <algorithm>

#include "ribbon/vec2.h"

namespace engine {

inline constexpr double straight_within = 0.03;  // px; less is not visible

/// A straight piece of a line: the directions from its start in which it may go on so that it passes all points so far
/// within straight_within.
class Straight {
 public:
  explicit Straight(ribbon::Vec2 start) : start_(start) {}

  /// Returns whether a piece that goes on to `end` passes all points so far, at least one.
  bool reaches(ribbon::Vec2 end) const {
    const ribbon::Vec2 to = end - start_;
    return dot(to - last_, last_) >= 0.0 && cross(low_, to) >= 0.0 && cross(to, high_) >= 0.0;
  }
  void pass(ribbon::Vec2 point) {
    const ribbon::Vec2 to = point - start_;
    const ribbon::Vec2 aside = (straight_within / std::max(length(to), straight_within)) * perp(to);
    const bool is_first = last_ == ribbon::Vec2{};
    if (is_first || cross(low_, to - aside) > 0.0) low_ = to - aside;
    if (is_first || cross(high_, to + aside) < 0.0) high_ = to + aside;
    last_ = to;
  }

 private:
  ribbon::Vec2 start_;
  ribbon::Vec2 last_;        // from the start
  ribbon::Vec2 low_, high_;  // the clockwise and counter-clockwise limits
};

}  // namespace engine
