#include <array>
#include <cmath>
#include <cstddef>

#include "game/view/backdrop_places.h"
#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr std::array<Range, 3> floors = {{{0.92, 0.26, 0.16, 0.55, 0.020, 501, 0.24, false, 0.45},
                                          {0.82, 0.17, 0.14, 0.45, 0.016, 502, 0.22, false, 0.55},
                                          {0.66, 0.07, 0.10, 0.40, 0.012, 503, 0.18, false, 0.70}}};
constexpr std::array<Range, 3> ceilings = {{{0.92, 0.17, 0.14, 0.50, 0.020, 511, 0.26, true, 0.20},
                                            {0.82, 0.10, 0.12, 0.44, 0.016, 512, 0.22, true, 0.20},
                                            {0.66, 0.03, 0.08, 0.38, 0.012, 513, 0.17, true, 0.15}}};

/// Draws a shaft of light from above, `width` wide at the bottom; lengths are fractions of the canvas's height.
void add_shaft(engine::TexturedMesh& mesh, double high, double x, double lean, double width, Color light) {
  const Color gone = with_alpha(light, 0);
  const double top = 0.35 * width;
  const auto at = [&](double along, double down) { return high * Vec2{x + lean * down + along, down}; };
  // Brightest in the middle, and fading downwards.
  const Color middle = with_alpha(light, light.a);
  add_quad(mesh, {{{at(-top, 0.0), gone}, {at(0.0, 0.0), middle}, {at(0.0, 0.95), gone}, {at(-width, 0.95), gone}}});
  add_quad(mesh, {{{at(0.0, 0.0), middle}, {at(top, 0.0), gone}, {at(width, 0.95), gone}, {at(0.0, 0.95), gone}}});
}

/// Draws the far end of the cave: haze in the middle, shafts of light, and dark corners.
void draw_depth(Pen& pen) {
  const Palette& colors = pen.colors;
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  draw_gradient(pen, 1.0, colors.sky_top, colors.sky_middle, colors.horizon);
  pen.sprite(pen.images.glow, {0.56 * width, 0.52 * high}, {2.2 * high, 1.5 * high}, with_alpha(colors.horizon, 190));
  pen.sprite(pen.images.glow, {0.60 * width, 0.10 * high}, {1.5 * high, 0.9 * high}, with_alpha(colors.sun, 60));
  pen.mesh.clear();
  const double aspect = width / high;
  add_shaft(pen.mesh, high, 0.58 * aspect, -0.16, 0.20, with_alpha(colors.sun, 74));
  add_shaft(pen.mesh, high, 0.66 * aspect, -0.10, 0.13, with_alpha(colors.sun, 60));
  add_shaft(pen.mesh, high, 0.48 * aspect, -0.24, 0.10, with_alpha(colors.sun, 48));
  pen.canvas.textured(pen.mesh, {});
  const Color dark = with_alpha(mix(colors.sky_top, {0, 0, 0}, 0.4), 150);
  const Color none = with_alpha(dark, 0);
  const double side = 0.34 * width;
  pen.mesh.clear();
  add_quad(pen.mesh, {{{{0.0, 0.0}, dark}, {{side, 0.0}, none}, {{side, high}, none}, {{0.0, high}, dark}}});
  add_quad(pen.mesh,
           {{{{width, 0.0}, dark}, {{width - side, 0.0}, none}, {{width - side, high}, none}, {{width, high}, dark}}});
  pen.canvas.textured(pen.mesh, {});
}

/// Draws crystals on a floor, each with a glow.
void draw_crystals(Pen& pen, const Range& range, double size, int opacity) {
  const double high = pen.canvas.height();
  constexpr double spacing = 0.22;
  const auto tall_of = [&](double kind) { return std::round(high * size * (0.7 + 0.3 * kind)); };
  for (int kind = 0; pen.prepares && kind < 3; ++kind) {
    const Vec2 square{tall_of(kind), tall_of(kind)};
    pen.prepare(pen.images.glow, 2.2 * square, with_alpha(pen.colors.accent, opacity));
    for (const engine::Image& crystal : pen.images.props) pen.prepare(crystal, square, {255, 255, 255});
  }
  const double shift = shift_of(pen, range);
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (scatter(k, 1, range.seed) < 0.5) continue;
    const double x = high * (spacing * (k + 0.8 * scatter(k, 2, range.seed)) - shift);
    const double tall = tall_of(std::floor(3.0 * scatter(k, 3, range.seed)));
    const double y = outline_at(pen, range, x) + 0.10 * tall;
    if (y - tall > high) continue;
    pen.stamp(pen.images.glow, {x, y - 0.35 * tall}, {2.2 * tall, 2.2 * tall}, with_alpha(pen.colors.accent, opacity));
    pen.stamp(pen.images.props[static_cast<std::size_t>(k & 1)], {x, y - 0.5 * tall}, {tall, tall}, {255, 255, 255});
  }
}

}  // namespace

void draw_cave(Pen& pen) {
  const Palette& colors = pen.colors;
  std::array<Outline, floors.size()> outlines;
  for (std::size_t k = 0; k < floors.size(); ++k) outlines[k] = outline_of(pen, floors[k]);
  draw_fixed(pen, outlines[0].lowest, [&] { draw_depth(pen); });
  for (std::size_t k = 0; k < floors.size(); ++k) {
    const Color color = colors.hills[k];
    draw_ceiling(pen, outline_of(pen, ceilings[k]), color, mix(color, colors.sky_top, 0.8));
    if (k > 0) draw_crystals(pen, floors[k], k == 1 ? 0.075 : 0.11, k == 1 ? 84 : 104);
    const double cut = k + 1 < floors.size() ? outlines[k + 1].lowest + 1.0 : pen.canvas.height();
    draw_range(pen, outlines[k], color, mix(color, colors.mist, k == 2 ? 0.35 : 0.7), cut);
  }
}

void draw_lamp(Pen& pen, Vec2 player) {
  const double size = 0.52 * pen.canvas.height();
  pen.stamp(pen.images.glow, pen.canvas.to_pixels(player), {size, size}, pen.colors.lamp);
}

}  // namespace game
