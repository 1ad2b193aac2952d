#pragma once

#include "engine/draw/canvas.h"

namespace game {

/// Draws the scale of strain colours at the right edge of the canvas. `text_scale` as in ViewOptions.
void draw_strain_legend(engine::Canvas& canvas, double text_scale);

}  // namespace game
