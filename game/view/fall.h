#pragma once

#include "game/view/pen.h"

namespace game {

/// What is drawn after a fall: the figure falls on for a moment while it gets dark, then it gets light around the
/// player, which is back at the last checkpoint. It can be played from the first tick on; only the picture lags.
class Fall {
 public:
  static constexpr int closing = 10;  ///< ticks, until it is dark
  static constexpr int opening = 18;  ///< ticks, until all is seen again

  /// Begins at the place of the fall (m) with the velocity (m/s) there.
  void begin(ribbon::Vec2 at, ribbon::Vec2 velocity) {
    at_ = at;
    velocity_ = velocity;
    ticks_ = 0;
  }
  void end() { ticks_ = closing + opening; }
  void tick() { ticks_ = ticks_ < closing + opening ? ticks_ + 1 : ticks_; }

  /// Whether the place of the fall is shown.
  bool is_closing() const { return ticks_ < closing; }
  bool is_shown() const { return ticks_ < closing + opening; }
  /// How much is seen, 0 … 1, `alpha` between the last two ticks.
  double openness(double alpha) const;
  /// The place of the falling figure, m.
  ribbon::Vec2 at(double alpha) const;
  ribbon::Vec2 velocity() const { return velocity_; }

  /// Draws the darkness: an iris around `player` (m), or a plain fade with reduced motion.
  void draw(Pen& pen, ribbon::Vec2 player, double alpha) const;

 private:
  ribbon::Vec2 at_{};
  ribbon::Vec2 velocity_{};
  int ticks_ = closing + opening;
};

}  // namespace game
