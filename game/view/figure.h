#pragma once

#include "game/view/pen.h"
#include "game/view/pose.h"

namespace game {

/// Draws the player.
void draw_figure(Pen& pen, const Pose& pose);

/// Draws the ghost: translucent, of one colour.
void draw_ghost(Pen& pen, const Pose& pose);

}  // namespace game
