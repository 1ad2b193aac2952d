#pragma once

#include <array>
#include <cstddef>

#include "game/view/pen.h"

namespace game {

/// Shows the speed of the player: a trail of light along its way, and lines of wind.
class Trail {
 public:
  static constexpr double first_speed = 7.5;    ///< m/s, from which on it is seen
  static constexpr double full_speed = 14.0;    ///< m/s
  static constexpr std::size_t max_count = 22;  ///< ticks

  void clear() { count_ = 0; }
  /// Adds the position of a tick, m.
  void add(ribbon::Vec2 at);
  std::size_t count() const { return count_; }
  /// Returns how clearly it is seen at a speed (m/s), 0 … 1.
  static double strength(double speed);
  /// Draws it for a player at `at` (m) with a velocity (m/s). Draws nothing with reduced motion.
  void draw(Pen& pen, ribbon::Vec2 at, ribbon::Vec2 velocity) const;

 private:
  std::array<ribbon::Vec2, max_count> way_{};  // the newest first
  std::size_t count_ = 0;
};

}  // namespace game
