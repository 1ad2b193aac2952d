#pragma once

#include <array>
#include <vector>

#include "engine/draw/canvas.h"
#include "game/view/free_space.h"
#include "game/view/palette.h"
#include "game/view/stamps.h"
#include "game/view/textures.h"

namespace game {

/// The context of all drawing functions.
struct Pen {
  engine::Canvas& canvas;
  const Palette& colors;
  const Textures& images;
  double time = 0.0;            ///< s, since the start of the run
  bool reduced_motion = false;  ///< no waving, drifting or pulsing
  Place place = Place::hills;
  Stamps* stamps = nullptr;         ///< of the view; null: none are kept
  bool prepares = false;            ///< the stamps of all sizes are made now, so that no later frame takes longer
  engine::TexturedMesh mesh{};      // scratch memory
  engine::Mesh shape{};             // scratch memory
  std::vector<Rectangle> labels{};  ///< px, the texts of the level that were drawn: the HUD does not cover them

  double scale() const { return canvas.view().pixels_per_metre; }
  /// The corners of the visible rectangle of the world, m.
  ribbon::Vec2 left_bottom() const { return canvas.to_world({0.0, 1.0 * canvas.height()}); }
  ribbon::Vec2 right_top() const { return canvas.to_world({1.0 * canvas.width(), 0.0}); }
  /// Returns whether a disc (m) may be visible.
  bool sees(ribbon::Vec2 center, double radius) const;

  /// Draws an image on a rectangle in pixels, rotated by `angle` (rad, clockwise on the screen).
  void sprite(const engine::Image& image, ribbon::Vec2 center, ribbon::Vec2 size, engine::Color color,
              double angle = 0.0);
  /// The same at whole pixels and without a rotation, from a stored copy: for what is drawn in few sizes. Images that
  /// are drawn in any size make no good stamps.
  void stamp(const engine::Image& image, ribbon::Vec2 center, ribbon::Vec2 size, engine::Color color);
  /// Makes the stored copy for stamp().
  void prepare(const engine::Image& image, ribbon::Vec2 size, engine::Color color);
  /// Draws an image on a disc in metres, rotated by `angle` (rad, counter-clockwise).
  void disc(const engine::Image& image, ribbon::Vec2 center, double radius, engine::Color color, double angle = 0.0);
  /// Draws a rectangle in pixels with a vertical gradient.
  void fade(ribbon::Vec2 top_left, ribbon::Vec2 size, engine::Color top, engine::Color bottom);
};

}  // namespace game
