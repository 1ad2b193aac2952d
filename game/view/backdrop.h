#pragma once

#include "game/view/pen.h"

namespace game {

/// Fills the canvas with the sky, the sun, clouds, and hills with parallax.
void draw_backdrop(Pen& pen);

}  // namespace game
