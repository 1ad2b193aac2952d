#include "game/view/hazards.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "game/view/noise.h"
#include "game/view/palette.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr Color steel{214, 222, 230};
constexpr Color ember{255, 120, 30};
constexpr Color flame{255, 176, 48};
constexpr Color core{255, 240, 170};
constexpr Color dread{88, 20, 32};
constexpr double flame_step = 0.28;     // m, between two tongues of a fire
constexpr double spike_step = 0.35;     // m, between two spikes
constexpr double tooth_step = 0.22;     // m, along a blade
constexpr double coin_radius = 0.24;    // m
constexpr double min_flame_heat = 0.1;  // of a cord's place from which it flames
constexpr int chaser_thorns = 12;

/// A flickering value 0 … 1; constant with reduced motion.
double flicker(const Pen& pen, int number) {
  if (pen.reduced_motion) return 0.6;
  const double phase = 6.3 * scatter(number, 3, 17);
  return 0.55 + 0.3 * std::sin(9.0 * pen.time + phase) + 0.15 * std::sin(23.0 * pen.time + 2.0 * phase);
}

void fill(Pen& pen, std::span<const Vec2> corners, Color color) {
  std::vector<Vec2> pixels;
  for (const Vec2 p : corners) pixels.push_back(pen.canvas.to_pixels(p));
  pen.shape.clear();
  engine::add_convex(pen.shape, pixels);
  pen.canvas.mesh(pen.shape, color);
}

void draw_tongue(Pen& pen, Vec2 foot, double width, double height, int number) {
  const double high = height * (0.55 + 0.45 * flicker(pen, number));
  const double lean = 0.35 * width * (flicker(pen, number + 71) - 0.55);
  const auto tongue = [&](double share, Color color) {
    const double half = 0.5 * share * width;
    const std::array corners = {foot + Vec2{half, 0.0}, foot + Vec2{0.8 * half + 0.3 * lean, 0.4 * share * high},
                                foot + Vec2{lean, share * high},
                                foot + Vec2{-0.8 * half + 0.3 * lean, 0.4 * share * high}, foot - Vec2{half, 0.0}};
    fill(pen, corners, color);
  };
  tongue(1.0, with_alpha(ember, 215));
  tongue(0.7, with_alpha(flame, 230));
  tongue(0.4, core);
}

void draw_fire(Pen& pen, const Area& area, int number) {
  if (!pen.sees(area.center, length(area.size) + 1.0)) return;
  const Vec2 foot = area.center - Vec2{0.0, 0.5 * area.size.y};
  pen.sprite(pen.images.glow, pen.canvas.to_pixels(area.center), 2.2 * pen.scale() * (area.size + Vec2{0.4, 0.4}),
             with_alpha(ember, 120));
  const int tongues = std::max(1, static_cast<int>(area.size.x / flame_step));
  const double step = area.size.x / tongues;
  for (int k = 0; k < tongues; ++k) {
    const Vec2 at = foot + Vec2{-0.5 * area.size.x + (k + 0.5) * step, 0.0};
    draw_tongue(pen, at, 1.9 * step, 1.15 * area.size.y, 31 * number + k);
  }
}

void draw_spikes(Pen& pen, const Area& area) {
  if (!pen.sees(area.center, length(area.size))) return;
  const Vec2 corner = area.center - 0.5 * area.size;
  const int count = std::max(1, static_cast<int>(area.size.x / spike_step));
  const double step = area.size.x / count;
  for (int k = 0; k < count; ++k) {
    const Vec2 foot = corner + Vec2{(k + 0.5) * step, 0.0};
    const Vec2 top = foot + Vec2{0.0, area.size.y};
    const Vec2 half{0.5 * step, 0.0};
    fill(pen, std::array{foot - half - Vec2{0.03, 0.0}, foot + half + Vec2{0.03, 0.0}, top + Vec2{0.0, 0.06}},
         pen.colors.ink);
    fill(pen, std::array{foot - 0.85 * half, foot + 0.85 * half, top}, mix(pen.colors.iron, white, 0.2));
    fill(pen, std::array{foot, foot + 0.85 * half, top}, mix(pen.colors.iron, pen.colors.ink, 0.25));
  }
}

void draw_blade(Pen& pen, std::span<const Vec2> edge) {
  pen.canvas.polyline(edge, 0.15, pen.colors.ink);
  pen.canvas.polyline(edge, 0.09, mix(pen.colors.iron, white, 0.35));
  for (std::size_t k = 0; k + 1 < edge.size(); ++k) {
    const Vec2 piece = edge[k + 1] - edge[k];
    const double far = length(piece);
    if (far <= 0.0) continue;
    const Vec2 along = (1.0 / far) * piece;
    const int teeth = std::max(1, static_cast<int>(far / tooth_step));
    const double step = far / teeth;
    for (int t = 0; t < teeth; ++t) {
      const Vec2 from = edge[k] + (t * step) * along;
      const std::array tooth = {from, from + step * along, from + 0.5 * step * along + 0.13 * perp(along)};
      fill(pen, tooth, pen.colors.ink);
      const std::array bright = {from + 0.2 * step * along, from + 0.8 * step * along,
                                 from + 0.5 * step * along + 0.09 * perp(along)};
      fill(pen, bright, steel);
    }
  }
  pen.canvas.polyline(edge, 0.03, steel);
}

void draw_eyes(Pen& pen, Vec2 at, double size) {
  for (const double side : {-1.0, 1.0}) {
    const Vec2 eye = at + Vec2{0.36 * side * size, 0.18 * size};
    pen.canvas.circle(eye, 0.2 * size, core);
    pen.canvas.circle(eye + Vec2{0.05 * size, -0.03 * size}, 0.1 * size, pen.colors.ink);
  }
}

void draw_chaser(Pen& pen, const Chaser& chaser, Vec2 at, bool runs) {
  const double radius = 0.5 * std::max(chaser.area.size.x, chaser.area.size.y);
  if (!pen.sees(at, 1.5 * radius)) return;
  const double turn = pen.reduced_motion || !runs ? 0.0 : -2.0 * pen.time;
  if (chaser.round) {
    for (int k = 0; k < chaser_thorns; ++k) {
      const double angle = turn + 6.283185307 * k / chaser_thorns;
      const Vec2 out{std::cos(angle), std::sin(angle)};
      const std::array thorn = {at + 0.86 * radius * out + 0.24 * radius * perp(out),
                                at + 0.86 * radius * out - 0.24 * radius * perp(out), at + 1.02 * radius * out};
      fill(pen, thorn, pen.colors.ink);
    }
    pen.canvas.circle(at, 0.9 * radius, pen.colors.ink);
    pen.disc(pen.images.iron, at, 0.84 * radius, mix(dread, white, 0.1), turn);
    pen.disc(pen.images.shade, at, 0.84 * radius, white);
  } else {
    const Vec2 half = 0.5 * chaser.area.size;
    const std::array box = {at - half, at + Vec2{half.x, -half.y}, at + half, at + Vec2{-half.x, half.y}};
    fill(pen, box, pen.colors.ink);
    const Vec2 less = half - Vec2{0.06, 0.06};
    fill(pen, std::array{at - less, at + Vec2{less.x, -less.y}, at + less, at + Vec2{-less.x, less.y}}, dread);
  }
  draw_eyes(pen, at, 0.5 * std::min(chaser.area.size.x, chaser.area.size.y));
}

void draw_coin(Pen& pen, Vec2 at, int number) {
  if (!pen.sees(at, 1.0)) return;
  const double turn = pen.reduced_motion ? 1.0 : std::abs(std::cos(2.5 * pen.time + number));
  const double half = coin_radius * std::max(0.25, turn);
  pen.sprite(pen.images.glow, pen.canvas.to_pixels(at), pen.scale() * Vec2{1.2, 1.2}, with_alpha(pen.colors.sun, 120));
  const auto ellipse = [&](double share, Color color) {
    std::vector<Vec2> corners;
    for (int k = 0; k < 20; ++k) {
      const double angle = 6.283185307 * k / 20;
      corners.push_back(
          at + Vec2{(half - (1.0 - share) * coin_radius) * std::cos(angle), share * coin_radius * std::sin(angle)});
    }
    fill(pen, corners, color);
  };
  ellipse(1.0, pen.colors.ink);
  ellipse(0.84, pen.colors.goal);
  if (half > 0.5 * coin_radius) ellipse(0.55, mix(pen.colors.goal, white, 0.35));
}

}  // namespace

void draw_hazards(Pen& pen, const Simulation& simulation, double alpha) {
  const LevelRules& level = simulation.level().rules;
  const Rules& rules = simulation.rules();
  for (const Area& area : level.spikes) draw_spikes(pen, area);
  for (std::size_t k = 0; k < level.coins.size(); ++k) {
    if (!rules.has_coin(k)) draw_coin(pen, level.coins[k], static_cast<int>(k));
  }
  for (std::size_t k = 0; k < level.blades.size(); ++k) {
    std::vector<Vec2> edge;
    for (std::size_t p = 0; p < rules.blades().edge(k).size(); ++p) {
      const Vec2 before = rules.blades().edge_before(k)[p];
      edge.push_back(before + alpha * (rules.blades().edge(k)[p] - before));
    }
    draw_blade(pen, edge);
  }
  for (std::size_t k = 0; k < level.chasers.size(); ++k)
    draw_chaser(pen, level.chasers[k], rules.chase().position(k, alpha), rules.chase().is_running(k));
  for (std::size_t k = 0; k < level.fires.size(); ++k) draw_fire(pen, level.fires[k].area, static_cast<int>(k));
}

void draw_rails(Pen& pen, const Level& level) {
  for (const engine::Track& track : level.rules.rails) {
    pen.canvas.polyline(track.points(), 0.12, with_alpha(pen.colors.ink, 150));
    pen.canvas.polyline(track.points(), 0.05, with_alpha(mix(pen.colors.iron, white, 0.3), 200));
  }
}

void add_char(const Pen& pen, const DrawnCord& cord, const Burning& burning, std::vector<Color>& colors) {
  bool is_burnt = false;
  for (int i = 0; i < cord.shape.columns; ++i) {
    const double black = burning.char_of(cord.index, i);
    is_burnt = is_burnt || black > 0.0;
    const Color charred = mix(own_color(pen, cord), {22, 18, 18}, 0.9 * black);
    colors.push_back(mix(charred, ember, 0.6 * burning.heat(cord.index, i)));
  }
  if (!is_burnt) colors.clear();
}

void draw_flames_on(Pen& pen, const DrawnCord& cord, const Burning& burning) {
  for (int i = 0; i < cord.shape.columns; ++i) {
    const double heat = burning.heat(cord.index, i);
    if (heat < min_flame_heat) continue;
    const Vec2 at = cord.at(cord.point(i, cord.shape.rows / 2));
    if (!pen.sees(at, 1.0)) continue;
    pen.sprite(pen.images.glow, pen.canvas.to_pixels(at), pen.scale() * Vec2{0.8, 0.8}, with_alpha(ember, 90));
    draw_tongue(pen, at, 0.14 + 0.1 * heat, 0.2 + 0.35 * heat, 131 * cord.index + i);
  }
}

}  // namespace game
