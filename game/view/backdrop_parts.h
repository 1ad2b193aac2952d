#pragma once

#include <array>
#include <vector>

#include "game/view/pen.h"

namespace game {

/// A layer of the backdrop: hills, or rock that hangs from the top. Lengths are in heights of the canvas, so that it
/// looks the same at any resolution and zoom.
struct Range {
  double follow;  ///< fraction of the camera's motion that it follows: 1 is fixed on the screen
  double height;  ///< of its mean outline above the bottom of the canvas, with the camera at the bottom of the level
  double swell;   ///< amplitude of the hills
  double length;  ///< of one hill
  double jag;     ///< amplitude of the fine detail
  int seed;
  double spikes = 0.0;  ///< the greatest length of stalagmites, or stalactites
  bool hangs = false;   ///< from the top of the canvas; `height` is measured from there
  double climb = 1.0;   ///< factor of the vertical motion
};

/// Returns the position of the camera in heights of the canvas.
ribbon::Vec2 camera_offset(const Pen& pen);

/// Returns the shift of a layer to the left, in heights of the canvas.
double shift_of(const Pen& pen, const Range& range);

/// Returns the y in px of the outline at pixel column x.
double outline_at(const Pen& pen, const Range& range, double x);

/// The outline of a layer on the canvas, in px. It is sampled at fixed places of the layer, so that it keeps its form
/// when it moves.
struct Outline {
  std::vector<ribbon::Vec2> points;  ///< from left to right, over the whole canvas
  double highest = 0.0;              ///< the smallest y
  double lowest = 0.0;               ///< the largest y
};
Outline outline_of(const Pen& pen, const Range& range);

/// Draws a layer of hills down to `cut` px, where nearer layers hide it, with mist, which makes it lighter towards the
/// bottom.
void draw_range(Pen& pen, const Outline& outline, engine::Color color, engine::Color mist, double cut);
/// Draws a layer that hangs.
void draw_ceiling(Pen& pen, const Outline& outline, engine::Color color, engine::Color mist);

/// Where props stand along a layer.
struct Stand {
  double spacing;  ///< heights of the canvas
  double size;     ///< the mean height of a prop, heights of the canvas
  double aspect;   ///< width / height
  double dense;    ///< 0 … 1, the part of the layer that has none
};
/// Draws props that stand on the outline of a layer.
void draw_props(Pen& pen, const Range& range, const engine::Image& image, const Stand& stand);

struct Corner {
  ribbon::Vec2 at;  ///< px
  engine::Color color;
};
/// Adds a quad, corners in turn around it.
void add_quad(engine::TexturedMesh& mesh, const std::array<Corner, 4>& corners);

/// The clouds of a place. Lengths in heights of the canvas.
struct Clouds {
  double spacing = 0.42;  ///< heights of the canvas
  double top = 0.08;      ///< of the highest
  double depth = 0.30;    ///< from the highest to the lowest
  double size = 0.20;     ///< width of the smallest
  double growth = 0.26;   ///< of the largest beyond this
  int opacity = 150;      ///< 0 … 255, of the faintest
  double drift = 0.004;   ///< 1/s
  int seed = 77;
};
/// Draws clouds that drift.
void draw_clouds(Pen& pen, const Clouds& clouds);

/// Draws a sun, with its glow, in a place fixed on the canvas (fractions of its size).
void draw_sun(Pen& pen, ribbon::Vec2 at, double glow, double disc);

}  // namespace game
