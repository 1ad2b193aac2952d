#pragma once

#include "engine/draw/canvas.h"

namespace game {

/// What the colours of stretched cords mean: a scale at the right of the screen. `text_scale` as in ViewOptions.
void draw_strain_legend(engine::Canvas& canvas, double text_scale);

}  // namespace game
