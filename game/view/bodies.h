#pragma once

#include <box2d/box2d.h>

#include <optional>
#include <span>

#include "game/simulation/simulation.h"
#include "game/view/pen.h"

namespace game {

/// A body of the level between two ticks.
struct DrawnBody {
  const b2Body& body;
  Snapshot::Body pose;
  int number;              ///< selects one of several colours
  bool is_load = false;    ///< drawn with its mass
  bool is_sticky = false;  ///< a line can be thrown at it
  /// m, the position of the cord that it holds, where an eye is drawn.
  std::optional<ribbon::Vec2> eye{};
};

/// Draws ground with grass on top, wooden beams where it is thin, pegs, balls and weights.
void draw_bodies(Pen& pen, std::span<const DrawnBody> bodies);

/// Transforms a point from the frame of a body to the world.
ribbon::Vec2 placed(const Snapshot::Body& pose, ribbon::Vec2 local);

}  // namespace game
