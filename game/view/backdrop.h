#pragma once

#include "game/view/pen.h"

namespace game {

/// Fills the canvas with the backdrop of the place: a sky or the depth of a cave, and layers with parallax.
void draw_backdrop(Pen& pen);

/// Draws what is in front of the level: the light of a lamp, rain.
void draw_foreground(Pen& pen, ribbon::Vec2 player);

}  // namespace game
