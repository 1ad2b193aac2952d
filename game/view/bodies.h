#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>

#include "game/simulation/simulation.h"
#include "game/view/pen.h"

namespace game {

/// A body of the level at a moment between two ticks.
struct DrawnBody {
  const b2Body& body;
  Snapshot::Body pose;
  int number;            ///< tells alike ones apart
  bool is_load = false;  ///< a weight, with its mass written on it
  /// m, where a cord that it holds is: it has an eye there.
  std::optional<ribbon::Vec2> eye{};
};

/// Draws ground, with grass on what faces up, beams and posts of wood where it is thin, pegs, what rolls, and
/// weights.
void draw_bodies(Pen& pen, std::span<const DrawnBody> bodies);

/// Where a body's own place is in the world.
ribbon::Vec2 placed(const Snapshot::Body& pose, ribbon::Vec2 local);

}  // namespace game
