#pragma once

#include "engine/draw/canvas.h"
#include "game/view/free_space.h"

namespace game::lab {

/// The parts of the lab's screen, in px: the list of scenes at the left, sliders and buttons at the right, and between
/// them texts, the world and the plots, from top to bottom.
struct Layout {
  double unit;  ///< px per unit of text
  Rectangle list, panel, head, world, plots;
};

/// Returns the parts for a canvas with `text_scale` pixels per unit of text.
Layout layout_of(const engine::Canvas& canvas, double text_scale);

/// The strip at the top of each column that a notice may cover, in units of text.
inline constexpr double top_strip = 44.0;

}  // namespace game::lab
