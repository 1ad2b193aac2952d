#pragma once

#include <vector>

#include "tests/extremes/any_scene/geometry.h"
#include "tests/support/dice.h"

namespace any_scene {

using test_support::Dice;

/// A whole number, low … high.
int whole(Dice& dice, int low, int high);
bool chance(Dice& dice, double share);
/// Spread over the decades between low and high, with + − · / and √ only.
double log_uniform(Dice& dice, double low, double high);
/// Of length 1.
ribbon::Vec2 direction(Dice& dice);

/// A scene's things while it is laid out; what is added keeps clear of what is there.
class Room {
 public:
  explicit Room(Scene& scene) : scene_(scene) {}

  bool is_clear(const Solid& solid, int except = -1) const;
  bool is_clear(const ribbon::CordDef& def, const std::vector<ribbon::Vec2>& positions) const;
  /// Adds what is clear; false if no place was found.
  bool add_solid(Dice& dice, Solid solid, ribbon::Vec2 low, ribbon::Vec2 high);
  bool add_cord(Dice& dice, ribbon::CordDef def, ribbon::Vec2 low, ribbon::Vec2 high);
  /// Moves a solid to a cord so that it touches it at the arc, on either side, and gives the hold; false if it would
  /// overlap something else.
  bool bring(Dice& dice, int solid, int cord, double arc, Hold& hold);

 private:
  Scene& scene_;
};

}  // namespace any_scene
