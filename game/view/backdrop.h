#pragma once

#include "game/view/pen.h"

namespace game {

/// Draws the sky, its sun and clouds, and hills that move the less the further away they are, over the whole canvas.
void draw_backdrop(Pen& pen);

}  // namespace game
