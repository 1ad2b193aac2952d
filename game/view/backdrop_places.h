#pragma once

#include <algorithm>

#include "game/view/backdrop_parts.h"

namespace game {

/// The backdrops of the places.
void draw_hills(Pen& pen);
void draw_cave(Pen& pen);
void draw_harbour(Pen& pen);
void draw_storm(Pen& pen);

/// The light of a lamp around the player, m.
void draw_lamp(Pen& pen, ribbon::Vec2 player);
void draw_rain(Pen& pen);

/// Draws the part of a backdrop that is fixed on the canvas, down to `rows` px: a stored picture of it, if there is
/// one.
template <typename DrawSky>
void draw_fixed(Pen& pen, double rows, DrawSky draw_sky) {
  const int key = 2 * static_cast<int>(pen.place) + (&pen.colors == &palette(true, pen.place) ? 1 : 0);
  if (rows <= 0.0 || pen.canvas.recall(key, static_cast<int>(std::min(rows + 2.0, 1.0 * pen.canvas.height())))) return;
  draw_sky();
  pen.canvas.remember(key);
}

/// Draws a sky with three colours down to the horizon at `end`, a fraction of the height.
void draw_gradient(Pen& pen, double end, engine::Color top, engine::Color middle, engine::Color bottom);

}  // namespace game
