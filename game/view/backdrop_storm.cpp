#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "game/view/backdrop_places.h"
#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr std::array<Range, 4> storm_ranges = {{{0.93, 0.36, 0.24, 0.50, 0.060, 701},
                                                {0.86, 0.27, 0.18, 0.42, 0.040, 702},
                                                {0.76, 0.18, 0.12, 0.40, 0.014, 703},
                                                {0.62, 0.08, 0.08, 0.34, 0.008, 704}}};
constexpr double strike_every = 6.5;  // s
constexpr double strike_long = 0.55;  // s
constexpr int drops = 170;
constexpr double rain_slant = 0.22;  // to the right, per height

/// A stroke of lightning at a time: how bright it is, 0 … 1, and which one.
struct Strike {
  double light = 0.0;
  int number = 0;
};

Strike strike_at(double time) {
  const int number = static_cast<int>(std::floor(time / strike_every));
  const double begun = strike_every * (number + 0.25 + 0.6 * scatter(number, 1, 711));
  const double age = time - begun;
  if (age < 0.0 || age > strike_long) return {0.0, number};
  const double second = age > 0.16 ? 0.7 * std::exp(-9.0 * (age - 0.16)) : 0.0;
  return {std::max(std::exp(-16.0 * age), second), number};
}

void draw_bolt(Pen& pen, const Strike& strike) {
  const double high = pen.canvas.height();
  const double width = pen.canvas.width();
  double x = width * (0.15 + 0.7 * scatter(strike.number, 2, 711));
  std::vector<Vec2> line;
  for (int k = 0; k <= 14; ++k) {
    line.push_back({x, high * 0.055 * k - 4.0});
    x += high * 0.075 * (scatter(k, strike.number, 712) - 0.47);
  }
  pen.sprite(pen.images.glow, line[3], {1.6 * high, 1.2 * high},
             with_alpha(pen.colors.accent, static_cast<int>(110 * strike.light)));
  const std::vector<Vec2> fork = {line[7], line[7] + high * Vec2{0.05, 0.06}, line[7] + high * Vec2{0.07, 0.13},
                                  line[7] + high * Vec2{0.13, 0.19}};
  for (const auto& [thick, opacity] : {std::pair{0.012, 70}, std::pair{0.0045, 255}}) {
    pen.shape.clear();
    engine::add_polyline(pen.shape, line, thick * high);
    engine::add_polyline(pen.shape, fork, 0.6 * thick * high);
    pen.canvas.mesh(pen.shape, with_alpha(pen.colors.accent, static_cast<int>(opacity * strike.light)));
  }
}

/// Draws the sky with a bank of clouds at its top and a pale gap above the hills.
void draw_sky(Pen& pen) {
  const Palette& colors = pen.colors;
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  draw_gradient(pen, 0.86, colors.sky_top, colors.sky_middle, colors.horizon);
  pen.fade({0.0, 0.86 * high}, {width, 0.14 * high}, colors.horizon, colors.horizon);
  pen.sprite(pen.images.glow, {0.68 * width, 0.62 * high}, {1.9 * high, 0.7 * high}, with_alpha(colors.sun, 120));
  for (int k = 0; k < 26; ++k) {
    const double size = high * (0.42 + 0.34 * scatter(k, 1, 721));
    const double depth = 0.5 * (scatter(k, 3, 721) + k / 26.0);
    const Vec2 at{width * scatter(k, 2, 721), high * (0.40 - 0.44 * depth)};
    const Color color = mix(mix(colors.sky_top, colors.cloud, 0.35 + 0.65 * (1.0 - depth)), colors.sky_middle, 0.25);
    pen.sprite(pen.images.clouds.at(static_cast<std::size_t>(k % 3)), at, {1.6 * size, 0.62 * size},
               with_alpha(color, 120));
  }
  const Color dark = with_alpha(mix(colors.sky_top, {0, 0, 0}, 0.35), 190);
  pen.fade({0.0, 0.0}, {width, 0.3 * high}, dark, with_alpha(dark, 0));
}

}  // namespace

void draw_storm(Pen& pen) {
  const Palette& colors = pen.colors;
  std::array<Outline, storm_ranges.size()> outlines;
  for (std::size_t k = 0; k < storm_ranges.size(); ++k) outlines[k] = outline_of(pen, storm_ranges[k]);
  draw_fixed(pen, outlines[0].lowest, [&] { draw_sky(pen); });
  const Strike strike = pen.reduced_motion ? Strike{} : strike_at(pen.time);
  if (strike.light > 0.02) draw_bolt(pen, strike);
  draw_clouds(pen, {.spacing = 0.40,
                    .top = 0.02,
                    .depth = 0.20,
                    .size = 0.40,
                    .growth = 0.30,
                    .opacity = 150,
                    .drift = 0.02,
                    .seed = 79});
  for (std::size_t k = 0; k < storm_ranges.size(); ++k) {
    const Color color = mix(colors.hills[k], colors.accent, 0.25 * strike.light * (1.0 - 0.2 * static_cast<double>(k)));
    if (k == 2) draw_props(pen, storm_ranges[k], pen.images.props[0], {0.026, 0.06, 0.5, 0.52});
    if (k == 3) draw_props(pen, storm_ranges[k], pen.images.props[1], {0.044, 0.12, 0.5, 0.55});
    const double cut = k + 1 < storm_ranges.size() ? outlines[k + 1].lowest + 1.0 : pen.canvas.height();
    draw_range(pen, outlines[k], color, mix(color, colors.mist, 0.6), cut);
  }
}

void draw_rain(Pen& pen) {
  if (pen.reduced_motion) return;
  const double width = pen.canvas.width();
  const double high = pen.canvas.height();
  const Vec2 offset = camera_offset(pen);
  const Color wet = with_alpha(mix(pen.colors.accent, pen.colors.horizon, 0.4), 92);
  const Color gone = with_alpha(wet, 0);
  const double wide = width / high + rain_slant;
  pen.mesh.clear();
  for (int k = 0; k < drops; ++k) {
    const double near = 0.45 + 0.55 * scatter(k, 3, 731);  // near drops are longer, faster and move with the level
    const double fall = scatter(k, 1, 731) + near * 2.1 * pen.time + near * offset.y;
    const double down = 1.2 * (fall - std::floor(fall)) - 0.1;
    const double along = scatter(k, 2, 731) * wide + rain_slant * (down - 0.5) - near * offset.x;
    const double x = along - wide * std::floor(along / wide) - 0.5 * rain_slant;
    const Vec2 at = high * Vec2{x, down};
    const Vec2 streak = (0.05 * near * high) * Vec2{rain_slant, 1.0};
    const Vec2 side{std::max(0.0011 * near * high, 0.6), 0.0};
    add_quad(pen.mesh, {{{at - streak - side, gone}, {at - streak + side, gone}, {at + side, wet}, {at - side, wet}}});
  }
  pen.canvas.textured(pen.mesh, {});
}

}  // namespace game
