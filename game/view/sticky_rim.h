#pragma once

#include <span>

#include "game/view/bodies.h"
#include "game/view/pen.h"

namespace game {

/// Draws a rope around the bodies at which a line can be thrown.
void draw_sticky_rims(Pen& pen, std::span<const DrawnBody> bodies);

}  // namespace game
