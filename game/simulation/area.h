#pragma once

#include <cmath>

#include "ribbon/vec2.h"

namespace game {

/// A rectangle of the level.
struct Area {
  ribbon::Vec2 center;  ///< m
  ribbon::Vec2 size;    ///< m
  bool contains(ribbon::Vec2 point) const {
    return std::abs(point.x - center.x) <= 0.5 * size.x && std::abs(point.y - center.y) <= 0.5 * size.y;
  }
};

/// The flag of a goal, in m.
struct Flag {
  ribbon::Vec2 foot;  ///< of its pole
  ribbon::Vec2 top;   ///< of its pole
  Area pole;
  Area cloth;
};

/// Returns the flag whose foot is the middle of the lower edge of the goal.
Flag flag_of(const Area& goal);

}  // namespace game
