#pragma once

#include <cstdlib>

#include "ribbon/box2d/coupling.h"

namespace game {

/// Returns the constrained point of a cord that is nearest to one of its points by their numbers, of two the first; −1
/// if there is none.
inline int nearest_pin(const ribbon::box2d::CordView& cord, int point) {
  int pin = -1;
  for (int p = 0; p < static_cast<int>(cord.positions().size()); ++p) {
    if (cord.kind(p) != ribbon::PointKind::constrained) continue;
    if (pin < 0 || std::abs(p - point) < std::abs(pin - point)) pin = p;
  }
  return pin;
}

/// Returns whether the part of a cord before one of its points carries that point: there is the nearest constrained
/// point, or, without one, that end is the higher one.
inline bool hangs_from_first(const ribbon::box2d::CordView& cord, int point) {
  const int pin = nearest_pin(cord, point);
  return pin >= 0 ? pin <= point : cord.positions().front().y >= cord.positions().back().y;
}

}  // namespace game
