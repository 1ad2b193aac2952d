#pragma once

#include "game/view/pen.h"

namespace game {

/// Draws water up to `level` [m] in front of what is in it.
void draw_water(Pen& pen, double level);

}  // namespace game
