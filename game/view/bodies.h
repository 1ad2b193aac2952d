#pragma once

#include <box2d/box2d.h>

#include "game/simulation.h"
#include "game/view/pen.h"

namespace game {

/// Draws a body of the level: ground with grass on what faces up, beams and posts of wood where it is thin, pegs, and
/// what rolls. `number` tells alike bodies apart.
void draw_body(Pen& pen, const b2Body& body, const Snapshot::Body& pose, int number);

/// Where a body's own place is in the world.
ribbon::Vec2 placed(const Snapshot::Body& pose, ribbon::Vec2 local);

}  // namespace game
