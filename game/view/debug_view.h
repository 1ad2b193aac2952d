#pragma once

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// Draws the debug view of a cord: its swept box, inverted cells in red, points coloured as in Goto 2017, Fig. 4.1,
/// bars (those of a rope of the direct solver coloured by tension), and contacts with their normals.
void draw_debug(Pen& pen, const DrawnCord& cord);

/// Returns the colour of a tension in N by its logarithm: darkest up to 1 N, brightest from 10 kN.
engine::Color tension_color(double tension);

}  // namespace game
