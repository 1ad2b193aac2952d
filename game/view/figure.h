#pragma once

#include "game/view/pen.h"
#include "game/view/pose.h"

namespace game {

/// The player.
void draw_figure(Pen& pen, const Pose& pose);

/// Another one who is not really there: translucent, of one colour.
void draw_ghost(Pen& pen, const Pose& pose);

}  // namespace game
