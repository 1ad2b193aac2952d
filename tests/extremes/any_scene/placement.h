#pragma once

#include <vector>

#include "tests/extremes/any_scene/geometry.h"
#include "tests/support/dice.h"

namespace any_scene {

using test_support::Dice;

/// Returns a random integer in low … high.
int random_integer(Dice& dice, int low, int high);
bool chance(Dice& dice, double share);
/// Returns a log-uniform random number between low and high. Uses + − · / and √ only, so that it is portable.
double log_uniform(Dice& dice, double low, double high);
/// Returns a random unit vector.
ribbon::Vec2 direction(Dice& dice);

/// Places a scene's objects. Each added object is clear of those already present.
class Placer {
 public:
  explicit Placer(Scene& scene) : scene_(scene) {}

  bool is_clear(const Solid& solid, int except = -1) const;
  bool is_clear(const ribbon::CordDef& def, const std::vector<ribbon::Vec2>& positions) const;
  /// Adds an object at a clear place. Returns false if none is found.
  bool add_solid(Dice& dice, Solid solid, ribbon::Vec2 low, ribbon::Vec2 high);
  bool add_cord(Dice& dice, ribbon::CordDef def, ribbon::Vec2 low, ribbon::Vec2 high);
  /// Moves a solid to a cord so that it touches the cord at the arc on either side, and sets the hold. Returns false if
  /// the solid would overlap another object.
  bool place_holder(Dice& dice, int solid, int cord, double arc, Hold& hold);
  /// Adds a solid that hangs at the first or the last point of a rope, in its direction, and the hold. Returns false if
  /// the solid would overlap another object.
  bool add_load(Solid solid, int cord, bool last);

 private:
  bool hold_at(int solid, const Solid& moved, ribbon::Vec2 hand, Hold& hold);

  Scene& scene_;
};

}  // namespace any_scene
