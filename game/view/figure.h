#pragma once

#include "game/view/pen.h"
#include "game/view/pose.h"

namespace game {

/// Draws the player.
void draw_figure(Pen& pen, const Pose& pose);

/// The colours of a ghost, translucent: a dark outline, and a pale figure on top of it. One of them differs from any
/// backdrop.
struct GhostColors {
  engine::Color outline, body;
};
GhostColors ghost_colors(const Palette& colors);

/// Draws the ghost.
void draw_ghost(Pen& pen, const Pose& pose);

}  // namespace game
