#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "ribbon/vec2.h"

namespace game {

/// Returns the index of the point that is nearest to a place. Precondition: there are points.
inline std::size_t nearest_point(std::span<const ribbon::Vec2> points, ribbon::Vec2 place) {
  const auto nearest = std::min_element(points.begin(), points.end(), [place](ribbon::Vec2 a, ribbon::Vec2 b) {
    return dot(a - place, a - place) < dot(b - place, b - place);
  });
  return static_cast<std::size_t>(nearest - points.begin());
}

}  // namespace game
