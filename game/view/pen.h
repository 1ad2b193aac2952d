#pragma once

#include <array>

#include "engine/draw/canvas.h"
#include "game/view/palette.h"
#include "game/view/textures.h"

namespace game {

/// What everything is drawn with.
struct Pen {
  engine::Canvas& canvas;
  const Palette& colors;
  const Textures& images;
  double time = 0.0;            ///< s since the beginning
  bool calm = false;            ///< reduced motion
  engine::TexturedMesh mesh{};  // kept between shapes for its memory
  engine::Mesh shape{};

  double scale() const { return canvas.view().pixels_per_metre; }
  /// How much of the world is seen, m.
  ribbon::Vec2 left_bottom() const { return canvas.to_world({0.0, 1.0 * canvas.height()}); }
  ribbon::Vec2 right_top() const { return canvas.to_world({1.0 * canvas.width(), 0.0}); }
  /// Whether a disc (m) may be seen.
  bool sees(ribbon::Vec2 center, double radius) const;

  /// An image on a rectangle, in pixels, turned by `angle` (rad, clockwise on the screen).
  void sprite(const engine::Image& image, ribbon::Vec2 center, ribbon::Vec2 size, engine::Color color,
              double angle = 0.0);
  /// An image on a disc, in metres, turned counter-clockwise.
  void disc(const engine::Image& image, ribbon::Vec2 center, double radius, engine::Color color, double angle = 0.0);
  /// A plain image-less quad in pixels whose upper edge has one colour and lower edge another.
  void fade(ribbon::Vec2 top_left, ribbon::Vec2 size, engine::Color top, engine::Color bottom);
};

}  // namespace game
