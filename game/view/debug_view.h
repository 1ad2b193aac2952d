#pragma once

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// What a cord of the debug view shows: the box in which it looked for what it may meet, its cells that are inside out
/// in red, its points and connections coloured as in Goto 2017, Fig. 4.1, those of a rope of the direct solver by their
/// tension, and its contacts with their normals.
void draw_debug(Pen& pen, const DrawnCord& cord);

/// How a tension [N] is coloured: by its logarithm, darkest up to 1 N, brightest from 10 kN on.
engine::Color tension_color(double tension);

}  // namespace game
