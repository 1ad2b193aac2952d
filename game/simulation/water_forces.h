#pragma once

#include <box2d/box2d.h>

#include <array>
#include <cstddef>

#include "game/simulation/player.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/weather.h"

namespace game {

/// A level body in the water of a weather: it floats by the area that is below the surface, as if it were
/// WaterForces::depth thick, and is slowed.
class WaterForces {
 public:
  static constexpr double depth = 0.07;  ///< m, perpendicular to the picture: a player of 60 kg swims with its head out

  /// Changes the velocities of the dynamic bodies of the world for a tick of `dt` s. Call it before the tick.
  void act(const ribbon::WeatherDef& weather, b2World& world, double dt) const;
  /// Lets a player in the water swim in a tick: a press of jump is a stroke upwards, and at the surface a leap out of
  /// it. `number`: of the player, 0 or 1.
  void swim(const ribbon::WeatherDef& weather, std::size_t number, unsigned pressed, Player& player,
            const ribbon::box2d::Coupling& coupling);

  void add_to(ribbon::box2d::Hasher& hasher) const;

 private:
  std::array<int, 2> ticks_since_stroke_{};  // by player
};

/// The part of a body that is below a level.
struct Submerged {
  double area = 0.0;    ///< m²
  double whole = 0.0;   ///< m², of the whole body
  ribbon::Vec2 center;  ///< m, of the part
};
/// Returns the part of a body below y = `level` [m]. A circle counts as a polygon of 24 corners with its area. Shapes
/// that overlap count twice.
Submerged submerged(const b2Body& body, double level);

}  // namespace game
