#include "game/view/backdrop.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

/// A range of hills. Lengths are in heights of the canvas, so that it looks the same at any resolution and zoom.
struct Range {
  double follow;  ///< fraction of the camera's motion that it follows: 1 is fixed on the screen
  double height;  ///< of its mean outline above the bottom of the canvas, with the camera at the bottom of the level
  double swell;   ///< amplitude of the hills
  double length;  ///< of one hill
  double jag;     ///< amplitude of the fine detail
  int seed;
};
constexpr std::array<Range, 4> ranges = {{{0.93, 0.44, 0.20, 0.60, 0.030, 401},
                                          {0.86, 0.34, 0.14, 0.50, 0.008, 402},
                                          {0.76, 0.24, 0.11, 0.42, 0.006, 403},
                                          {0.62, 0.12, 0.08, 0.34, 0.004, 404}}};
constexpr int period = 4096;     // hills, after which the outline repeats
constexpr double column = 20.0;  // px, between two points of an outline

double outline(const Range& range, double x) {
  return range.swell * (tiled_noise(x / range.length, 0.0, period, range.seed) - 0.5) +
         range.jag * (tiled_noise(8.0 * x / range.length, 0.0, period, range.seed + 50) - 0.5);
}

/// Returns the position of the camera in heights of the canvas.
Vec2 camera_offset(const Pen& pen) {
  const double high = pen.canvas.height() / pen.scale();
  const Vec2 at = pen.canvas.view().center;
  return (1.0 / high) * Vec2{at.x, at.y - 0.5 * high};
}

/// Returns the y of the outline at pixel column x.
double top_of(const Pen& pen, const Range& range, double x) {
  const Vec2 offset = camera_offset(pen);
  const double high = pen.canvas.height();
  const double height =
      range.height + outline(range, x / high + (1.0 - range.follow) * offset.x) - (1.0 - range.follow) * offset.y;
  return high * (1.0 - height);
}

void add_hill(engine::TexturedMesh& mesh, double x, double y, double bottom, Color top_color, Color color) {
  mesh.vertices.push_back({{x, y - 0.5}, {}, top_color, 0.0});
  mesh.vertices.push_back({{x, y + 0.5}, {}, top_color, 1.0});
  mesh.vertices.push_back({{x, bottom}, {}, color, 1.0});
  const int v = static_cast<int>(mesh.vertices.size()) - 3;
  if (v < 3) return;
  for (const int k : {0, 1})
    mesh.indices.insert(mesh.indices.end(), {v - 3 + k, v + k, v + k + 1, v - 3 + k, v + k + 1, v - 2 + k});
}

/// Draws a range of hills with mist, which makes it lighter towards the bottom.
void draw_range(Pen& pen, const Range& range, Color color, Color mist) {
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  double highest = high;
  double lowest = 0.0;
  for (double x = 0.0; x < width + column; x += column) {
    const double y = top_of(pen, range, x);
    highest = std::min(highest, y);
    lowest = std::max(lowest, y + 1.0);
  }
  if (highest > high) return;
  const double bottom = std::max(highest + 0.30 * high, lowest + 1.0);
  const auto misty = [&](double y) { return mix(color, mist, 0.75 * (y - highest) / (bottom - highest)); };
  pen.mesh.clear();
  for (double x = 0.0; x < width + column; x += column) {
    const double y = top_of(pen, range, x);
    add_hill(pen.mesh, x, y, lowest, misty(y), misty(lowest));
  }
  pen.canvas.textured(pen.mesh, {});
  pen.fade({0.0, lowest}, {width, bottom - lowest}, misty(lowest), misty(bottom));
  if (bottom < high) pen.fade({0.0, bottom}, {width, high - bottom}, misty(bottom), misty(bottom));
}

void draw_trees(Pen& pen, const Range& range, const engine::Image& image, double spacing, double size) {
  const double high = pen.canvas.height();
  const double shift = (1.0 - range.follow) * camera_offset(pen).x;
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (tiled_noise(0.21 * k, 0.5, period, range.seed + 7) < 0.48) continue;  // groups trees into woods
    const double x = high * (spacing * (k + 0.7 * scatter(k, 1, range.seed)) - shift);
    const double tall = high * size * (0.6 + 0.8 * scatter(k, 2, range.seed));
    const double y = top_of(pen, range, x) + 0.06 * tall;
    if (y - tall > high) continue;
    pen.sprite(image, {x, y - 0.5 * tall}, {0.5 * tall, tall}, {255, 255, 255});
  }
}

void draw_sun(Pen& pen) {
  const double high = pen.canvas.height();
  const Vec2 at{0.74 * pen.canvas.width(), 0.26 * high};
  pen.sprite(pen.images.glow, at, {1.1 * high, 1.1 * high}, with_alpha(pen.colors.sun, 130));
  pen.shape.clear();
  engine::add_disc(pen.shape, at, 0.052 * high);
  pen.canvas.mesh(pen.shape, pen.colors.sun);
}

/// Draws the part of the backdrop that is fixed on the screen.
void draw_sky(Pen& pen) {
  const Palette& colors = pen.colors;
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  const double middle = std::round(0.5 * high);
  pen.fade({0.0, 0.0}, {width, middle}, colors.sky_top, colors.sky_middle);
  pen.fade({0.0, middle}, {width, high - middle}, colors.sky_middle, colors.horizon);
  draw_sun(pen);
}

void draw_clouds(Pen& pen) {
  const double high = pen.canvas.height();
  const double wide = pen.canvas.width() / high;
  constexpr double spacing = 0.42;  // heights of the canvas
  const double drift = pen.reduced_motion ? 0.0 : 0.004 * pen.time;
  const double shift = 0.05 * camera_offset(pen).x - drift;
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + wide) / spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (scatter(k, 5, 77) < 0.25) continue;
    const double size = 0.20 + 0.26 * scatter(k, 1, 77);
    const double x = spacing * (k + 0.6 * scatter(k, 2, 77)) - shift;
    const double y = 0.08 + 0.30 * scatter(k, 3, 77) + 0.05 * camera_offset(pen).y;
    const auto& image = pen.images.clouds.at(static_cast<std::size_t>(3.0 * scatter(k, 4, 77)));
    const int opacity = static_cast<int>(150 + 105 * scatter(k, 6, 77));
    pen.sprite(image, high * Vec2{x, y}, high * Vec2{size, 0.5 * size}, with_alpha(pen.colors.cloud, opacity));
  }
}

}  // namespace

void draw_backdrop(Pen& pen) {
  const Palette& colors = pen.colors;
  if (const int key = &colors == &palette(true) ? 1 : 0; !pen.canvas.recall(key)) {
    draw_sky(pen);
    pen.canvas.remember(key);
  }
  draw_clouds(pen);
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (k == 2) draw_trees(pen, ranges[k], pen.images.trees[0], 0.021, 0.055);
    if (k == 3) draw_trees(pen, ranges[k], pen.images.trees[1], 0.034, 0.11);
    draw_range(pen, ranges[k], colors.hills[k], mix(colors.hills[k], colors.mist, 0.7));
  }
}

}  // namespace game
