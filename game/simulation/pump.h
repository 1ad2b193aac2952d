#pragma once

#include <box2d/box2d.h>

#include "game/simulation/player_tuning.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/vec2.h"

namespace game {

/// Pushes a player that hangs for a moment after each press of left or right: a swing needs rhythm.
class Pump {
 public:
  /// Takes the direction of a tick: 1 right, −1 left, 0 neither.
  void follow(int direction, const PlayerTuning& tuning);
  /// Pushes the body across the direction from it to `from`, m, the place from which it hangs: the cord would take a
  /// push along it.
  void push(b2Body& body, ribbon::Vec2 from, const PlayerTuning& tuning, double dt) const;

  int direction() const { return direction_; }  ///< of the last tick

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  int direction_ = 0;
  int ticks_left_ = 0;
};

}  // namespace game
