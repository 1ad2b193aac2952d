#pragma once

#include "game/view/cords.h"
#include "game/view/pen.h"

namespace game {

/// A cord's points and connections, coloured as in Goto 2017, Fig. 4.1.
void draw_cord_points(Pen& pen, const DrawnCord& cord);

}  // namespace game
