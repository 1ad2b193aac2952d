#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "game/view/backdrop_places.h"
#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr Range coast{0.94, 0.37, 0.10, 0.70, 0.020, 601};
constexpr Range town{0.88, 0.325, 0.05, 0.40, 0.000, 602};
constexpr Range quay{0.80, 0.30, 0.0, 1.0, 0.0, 603};
constexpr Range roads{0.72, 0.24, 0.0, 1.0, 0.0, 604};  // where ships lie
constexpr double water_line = 0.30;                     // heights of the canvas above its bottom
constexpr double sun_x = 0.70;                          // fraction of the width

/// Draws the roofs of the town as boxes of different heights.
void draw_houses(Pen& pen, Color color, Color roof) {
  const double high = pen.canvas.height();
  constexpr double spacing = 0.055;
  const double shift = shift_of(pen, town);
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / spacing)) + 1;
  const double base = outline_at(pen, quay, 0.0) + 1.0;
  engine::TexturedMesh windows;
  pen.mesh.clear();
  for (int k = first; k <= last; ++k) {
    if (tiled_noise(0.13 * k, 0.5, 4096, 605) < 0.36) continue;
    const double left = high * (spacing * k - shift);
    const double wide = high * spacing * (0.75 + 0.5 * scatter(k, 1, 606));
    const double top = base - high * (0.035 + 0.075 * scatter(k, 2, 606));
    const double ridge = top - 0.32 * wide * (0.6 + 0.6 * scatter(k, 3, 606));
    const Color wall = mix(color, pen.colors.mist, 0.25 * scatter(k, 4, 606));
    add_quad(pen.mesh,
             {{{{left, top}, wall}, {{left + wide, top}, wall}, {{left + wide, base}, wall}, {{left, base}, wall}}});
    add_quad(pen.mesh, {{{{left - 0.06 * wide, top + 1.0}, roof},
                         {{left + 0.5 * wide, ridge}, roof},
                         {{left + 0.5 * wide, ridge}, roof},
                         {{left + 1.06 * wide, top + 1.0}, roof}}});
    for (int w = 0; w < 3; ++w) {
      if (scatter(k, 10 + w, 606) < 0.5) continue;
      const Vec2 at{left + wide * (0.18 + 0.26 * w), top + 0.012 * high};
      const double side = 0.008 * high;
      const Color lit = with_alpha(pen.colors.sun, 170);
      add_quad(windows, {{{at, lit},
                          {at + Vec2{side, 0.0}, lit},
                          {at + Vec2{side, 1.3 * side}, lit},
                          {at + Vec2{0.0, 1.3 * side}, lit}}});
    }
  }
  pen.canvas.textured(pen.mesh, {});
  pen.canvas.textured(windows, {});
}

void draw_cranes(Pen& pen) {
  const double high = pen.canvas.height();
  constexpr double spacing = 0.62;
  const auto tall_of = [&](double kind) { return std::round(high * (0.30 + 0.06 * kind)); };
  for (int kind = 0; pen.prepares && kind < 3; ++kind)
    pen.prepare(pen.images.props[0], {tall_of(kind), tall_of(kind)}, {255, 255, 255});
  const double shift = shift_of(pen, quay);
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (scatter(k, 1, 611) < 0.25) continue;
    const double tall = tall_of(std::floor(3.0 * scatter(k, 2, 611)));
    const double x = high * (spacing * (k + 0.5 * scatter(k, 3, 611)) - shift);
    pen.stamp(pen.images.props[0], {x, outline_at(pen, quay, x) - 0.5 * tall + 1.0}, {tall, tall}, {255, 255, 255});
  }
}

void draw_ships(Pen& pen) {
  const double high = pen.canvas.height();
  constexpr double spacing = 1.15;
  const auto tall_of = [&](double kind) { return std::round(high * (0.34 + 0.07 * kind)); };
  for (int kind = 0; pen.prepares && kind < 2; ++kind)
    pen.prepare(pen.images.props[1], {1.1 * tall_of(kind), tall_of(kind)}, {255, 255, 255});
  const double shift = shift_of(pen, roads);
  const int first = static_cast<int>(std::floor(shift / spacing)) - 1;
  const int last = static_cast<int>(std::ceil((shift + pen.canvas.width() / high) / spacing)) + 1;
  for (int k = first; k <= last; ++k) {
    if (scatter(k, 1, 621) < 0.2) continue;
    const double tall = tall_of(std::floor(2.0 * scatter(k, 2, 621)));
    const double bob = pen.reduced_motion ? 0.0 : 0.004 * high * std::sin(0.9 * pen.time + 2.0 * k);
    const double x = high * (spacing * (k + 0.5 * scatter(k, 3, 621)) - shift);
    const double y = outline_at(pen, roads, x) + bob;
    const Color shade = with_alpha(mix(pen.colors.hills[3], pen.colors.ink, 0.35), 120);
    const Color none = with_alpha(shade, 0);
    const double left = x - 0.42 * tall;
    const double right = x + 0.42 * tall;
    const double deep = y + 0.16 * tall;
    pen.mesh.clear();
    add_quad(pen.mesh, {{{{left, y - 1.0}, shade},
                         {{right, y - 1.0}, shade},
                         {{right - 0.1 * tall, deep}, none},
                         {{left + 0.1 * tall, deep}, none}}});
    pen.canvas.textured(pen.mesh, {});
    pen.stamp(pen.images.props[1], {x, y - 0.5 * tall}, {1.1 * tall, tall}, {255, 255, 255});
  }
}

/// Draws glints on the water: many below the sun, few elsewhere.
void draw_glints(Pen& pen, double top) {
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  pen.mesh.clear();
  for (int k = 0; k < 220; ++k) {
    const double depth = scatter(k, 1, 631);
    const double y = top + (high - top) * depth * depth + 2.0;
    const bool below_sun = k < 120;
    const double spread =
        below_sun ? (0.03 + 0.10 * depth) * (scatter(k, 2, 631) + scatter(k, 3, 631) - 1.0) : scatter(k, 2, 631) - 0.5;
    const double x = below_sun ? width * (sun_x + spread) : width * (0.5 + spread);
    const double beat =
        pen.reduced_motion
            ? 0.7
            : 0.5 + 0.5 * std::sin((1.2 + 1.5 * scatter(k, 4, 631)) * pen.time + 40.0 * scatter(k, 5, 631));
    const double long_half = high * (0.006 + 0.026 * depth) * (0.5 + 0.5 * beat);
    const double flat_half = high * (0.0014 + 0.0026 * depth);
    const Color bright = with_alpha(pen.colors.accent, static_cast<int>((below_sun ? 210 : 110) * beat));
    const Color gone = with_alpha(bright, 0);
    const Vec2 at{x, y};
    add_quad(pen.mesh, {{{at - Vec2{long_half, 0.0}, gone},
                         {at - Vec2{0.0, flat_half}, bright},
                         {at + Vec2{long_half, 0.0}, gone},
                         {at + Vec2{0.0, flat_half}, bright}}});
  }
  pen.canvas.textured(pen.mesh, {});
}

/// Draws the water from the quay to the bottom of the canvas. Returns its upper edge, px.
void draw_bay(Pen& pen, double top) {
  const Palette& colors = pen.colors;
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  const double middle = std::round(top + 0.35 * (high - top));
  const Color shine = mix(colors.hills[2], colors.horizon, 0.45);
  pen.fade({0.0, top}, {width, middle - top}, shine, colors.hills[2]);
  pen.fade({0.0, middle}, {width, high - middle}, colors.hills[2], colors.hills[3]);
  pen.fade({0.0, top}, {width, std::max(0.003 * high, 1.0)}, mix(shine, colors.ink, 0.25), shine);
}

}  // namespace

void draw_harbour(Pen& pen) {
  const Palette& colors = pen.colors;
  const double high = pen.canvas.height();
  const double top = std::round(outline_at(pen, quay, 0.0));
  const Outline far = outline_of(pen, coast);
  draw_fixed(pen, std::min(std::max(far.lowest, 0.0), top), [&] {
    draw_gradient(pen, 1.0 - 0.7 * water_line, colors.sky_top, colors.sky_middle, colors.horizon);
    pen.fade({0.0, high * (1.0 - 0.7 * water_line)}, {1.0 * pen.canvas.width(), 0.7 * water_line * high},
             colors.horizon, colors.horizon);
    draw_sun(pen, {sun_x, 0.46}, 1.3, 0.046);
  });
  draw_clouds(pen,
              {.spacing = 0.5, .top = 0.06, .depth = 0.22, .size = 0.24, .growth = 0.24, .opacity = 120, .seed = 78});
  draw_range(pen, far, colors.hills[0], mix(colors.hills[0], colors.mist, 0.7), top + 1.0);
  if (top < high || pen.prepares) {
    draw_houses(pen, mix(colors.hills[1], colors.mist, 0.25), mix(colors.hills[1], colors.ribbons[0], 0.22));
    draw_cranes(pen);
    draw_bay(pen, top);
    draw_glints(pen, top);
  }
  draw_ships(pen);
}

}  // namespace game
