#pragma once

#include "game/view/pen.h"
#include "game/view/pose.h"

namespace game {

/// The colours of the clothes of a player; those of the parts on the far side of the body are darker.
struct Clothes {
  engine::Color jacket, jacket_far, scarf, scarf_shade, trousers, trousers_far;
};
/// Returns the clothes of the first (0) or the second player (1). Their jackets differ in brightness too.
const Clothes& clothes_of(int player);

/// Draws a player.
void draw_figure(Pen& pen, const Pose& pose, const Clothes& clothes = clothes_of(0));

/// The colours of a ghost, translucent: a dark outline, and a pale figure on top of it. One of them differs from any
/// backdrop.
struct GhostColors {
  engine::Color outline, body;
};
GhostColors ghost_colors(const Palette& colors);

/// Draws the ghost.
void draw_ghost(Pen& pen, const Pose& pose);

}  // namespace game
