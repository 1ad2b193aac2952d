#pragma once

#include "engine/draw/canvas.h"

namespace game {

/// Returns the size in px of the scale of strain colours. `text_scale` as in ViewOptions.
ribbon::Vec2 strain_legend_size(const engine::Canvas& canvas, double text_scale);

/// Draws the scale of strain colours with its top left corner at `corner`, px.
void draw_strain_legend(engine::Canvas& canvas, ribbon::Vec2 corner, double text_scale);

}  // namespace game
