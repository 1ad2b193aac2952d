#include "game/view/marks.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "game/view/palette.h"
#include "game/words/words.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

// m, the space below the boards of signs, higher where the player stands at the start
constexpr double above_ground = 0.7;
constexpr double mark_height = 1.9;
constexpr double beside_start = 1.2;  // m, from the start to the side of such a board
constexpr double near_start = 3.0;    // m, up or down

void draw_pole(Pen& pen, Vec2 foot, Vec2 top, double width) {
  pen.canvas.polyline(std::array{foot, top}, width + 0.05, pen.colors.ink);
  pen.canvas.strip(std::array{foot, top}, {&pen.images.wood, width, 6.0 * width, 0.0, pen.colors.wood});
  pen.canvas.circle(top, 0.8 * width, pen.colors.ink);
  pen.canvas.circle(top, 0.8 * width - 0.03, pen.colors.goal);
}

/// The cloth of a flag. Lengths in m.
struct Cloth {
  Vec2 top;
  Vec2 size;
  double swing;      // amplitude of the waves at the free end
  double droop;      // of the free end
  double narrowing;  // of the free end, 0 … 1
};

void draw_flag(Pen& pen, const Cloth& flag, Color color) {
  constexpr int columns = 14;
  std::vector<Vec2> upper;
  std::vector<Vec2> lower;
  std::vector<double> light;
  for (int i = 0; i <= columns; ++i) {
    const double s = static_cast<double>(i) / columns;
    const double phase = 5.5 * s - 5.0 * (pen.reduced_motion ? 0.0 : pen.time);
    const Vec2 middle =
        flag.top + Vec2{flag.size.x * s, -0.5 * flag.size.y - flag.droop * s * s + flag.swing * s * std::sin(phase)};
    const double half = 0.5 * flag.size.y * (1.0 - flag.narrowing * s);
    upper.push_back(pen.canvas.to_pixels(middle + Vec2{0.0, half}));
    lower.push_back(pen.canvas.to_pixels(middle - Vec2{0.0, half}));
    light.push_back(0.5 + 0.5 * std::cos(phase) * s);
  }
  std::vector<Vec2> outline = upper;
  outline.insert(outline.end(), lower.rbegin(), lower.rend());
  outline.push_back(outline.front());
  pen.shape.clear();
  engine::add_polyline(pen.shape, outline, 0.07 * pen.scale());
  pen.canvas.mesh(pen.shape, pen.colors.ink);
  pen.mesh.clear();
  for (std::size_t i = 0; i < upper.size(); ++i) {
    const Color shaded = mix(mix(color, pen.colors.ink, 0.18), mix(color, white, 0.3), light[i]);
    const double u = 0.12 * static_cast<double>(i);
    pen.mesh.vertices.push_back({upper[i], {u, 0.0}, shaded});
    pen.mesh.vertices.push_back({lower[i], {u, 1.0}, shaded});
    const int v = static_cast<int>(pen.mesh.vertices.size()) - 4;
    if (v >= 0) pen.mesh.indices.insert(pen.mesh.indices.end(), {v, v + 2, v + 3, v, v + 3, v + 1});
  }
  pen.canvas.textured(pen.mesh, {&pen.images.cloth});
}

}  // namespace

void draw_goal(Pen& pen, const Area& goal, bool reached) {
  if (!pen.sees(goal.center, 4.0)) return;
  const Flag flag = flag_of(goal);
  const Vec2 top = flag.top;
  pen.sprite(pen.images.glow, pen.canvas.to_pixels(top + Vec2{0.5, -0.5}), pen.scale() * Vec2{4.0, 4.0},
             with_alpha(pen.colors.sun, reached ? 190 : 110));
  const Vec2 corner = flag.cloth.center + Vec2{-0.5 * flag.cloth.size.x, 0.5 * flag.cloth.size.y};
  draw_flag(pen, {corner, flag.cloth.size, reached ? 0.16 : 0.09, reached ? 0.0 : 0.12, 0.25}, pen.colors.goal);
  draw_pole(pen, flag.foot, top, flag.pole.size.x);
}

void draw_checkpoint(Pen& pen, Vec2 center, Vec2 size, bool reached) {
  const Vec2 foot = center - Vec2{0.0, 0.5 * size.y};
  if (!pen.sees(center, 3.0)) return;
  const Vec2 top = foot + Vec2{0.0, 1.7};
  const double height = reached ? 0.06 : 0.95;
  draw_flag(pen, {top - Vec2{0.0, height}, {0.75, 0.5}, reached ? 0.07 : 0.02, reached ? 0.03 : 0.16, 0.8},
            reached ? pen.colors.banner_up : pen.colors.banner_down);
  draw_pole(pen, foot, top, 0.09);
}

void draw_aim(Pen& pen, Vec2 at) {
  if (!pen.sees(at, 1.0)) return;
  pen.canvas.ring(at, 0.2, 0.1, pen.colors.ink);
  pen.canvas.ring(at, 0.2, 0.05, pen.colors.hook_in_range);
  pen.canvas.circle(at, 0.06, pen.colors.hook_in_range);
}

void draw_hook(Pen& pen, Vec2 at, bool in_range) {
  if (!pen.sees(at, 1.0)) return;
  const double beat = pen.reduced_motion ? 0.5 : 0.5 + 0.5 * std::sin(5.0 * pen.time);
  if (in_range) {
    pen.sprite(pen.images.glow, pen.canvas.to_pixels(at), pen.scale() * Vec2{1.7 + 0.3 * beat, 1.7 + 0.3 * beat},
               with_alpha(pen.colors.hook_in_range, 200));
    pen.canvas.ring(at, 0.42 + 0.05 * beat, 0.04, with_alpha(pen.colors.hook_in_range, 220));
  }
  const Color color = in_range ? pen.colors.hook_in_range : mix(pen.colors.hook, white, 0.35);
  pen.canvas.ring(at, 0.21, 0.15, pen.colors.ink);
  pen.canvas.ring(at, 0.21, 0.085, color);
  pen.canvas.circle(at + Vec2{0.0, 0.21}, 0.11, pen.colors.ink);
  pen.canvas.circle(at + Vec2{0.0, 0.21}, 0.075, pen.colors.iron);
}

namespace {

constexpr double near_view = 12.0;  // m, the least height of the view (camera.cpp)
constexpr double far_view = 26.0;   // m, the largest, which shows two players

/// Sets lines of text in all sizes in which the camera will show them: a new size takes milliseconds. `height`: of the
/// text, m.
void prepare_text(const Pen& pen, const std::vector<std::string_view>& lines, double height) {
  const auto least = static_cast<int>(std::floor(height * pen.canvas.height() / far_view));
  const auto most = static_cast<int>(std::ceil(height * pen.canvas.height() / near_view));
  for (const std::string_view line : lines) {
    for (int size = least; size <= most; ++size) static_cast<void>(pen.canvas.text_width(line, size));
  }
}

}  // namespace

void draw_sign(Pen& pen, Vec2 foot, std::string_view text, Vec2 start, double height) {
  if (text.empty() || (!pen.prepares && !pen.sees(foot, 8.0))) return;
  std::vector<std::string_view> lines;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, to - from));
    from = to + 1;
  }
  if (pen.prepares) prepare_text(pen, lines, height);
  if (!pen.sees(foot, 8.0)) return;
  const double size = height * pen.scale();
  const double step = pen.canvas.line_height(size);
  double width = 0.0;
  for (const std::string_view line : lines) width = std::max(width, pen.canvas.text_width(line, size));
  const Vec2 board{width + 1.6 * size, step * static_cast<double>(lines.size()) + 0.9 * size};
  const Vec2 apart = start - foot;
  const bool at_start =
      std::abs(apart.x) < 0.5 * board.x / pen.scale() + beside_start && std::abs(apart.y) < near_start;
  const Vec2 bottom = pen.canvas.to_pixels(foot + Vec2{0.0, at_start ? mark_height : above_ground});
  const Vec2 corner = bottom - Vec2{0.5 * board.x, board.y};
  for (const double x : {0.2, 0.8}) {
    const Vec2 top = pen.canvas.to_world({corner.x + x * board.x, corner.y});
    draw_pole(pen, {top.x, foot.y}, top, 0.1);
  }
  pen.canvas.panel(corner - Vec2{2.5, 2.5}, board + Vec2{5.0, 5.0}, 0.25 * size, pen.colors.ink);
  pen.shape.clear();
  pen.mesh.clear();
  engine::add_rounded_rectangle(pen.shape, corner, board, 0.2 * size);
  const double plank = board.y;  // a single plank: a seam would cross the text
  add_shape(pen.mesh, pen.shape, {corner, {0.25 / plank, 0.0}, {0.0, 1.0 / plank}}, pen.colors.wood);
  pen.canvas.textured(pen.mesh, {&pen.images.wood});
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Vec2 at = corner + Vec2{0.5 * board.x, 0.45 * size + step * static_cast<double>(k)};
    pen.canvas.text(at + Vec2{0.0, 1.5}, lines[k], size, mix(pen.colors.wood, white, 0.45), engine::Align::center);
    pen.canvas.text(at, lines[k], size, pen.colors.ink, engine::Align::center);
  }
  pen.labels.push_back({corner, board});
}

void draw_weight(Pen& pen, Vec2 center, double radius, double angle, double mass) {
  if (!pen.prepares && !pen.sees(center, radius)) return;
  pen.canvas.circle(center, radius, pen.colors.ink);
  pen.disc(pen.images.iron, center, radius - 0.03, mix(pen.colors.iron, white, 0.12), angle);
  pen.disc(pen.images.shade, center, radius - 0.03, white);
  draw_mass(pen, center, radius, mass);
}

void draw_mass(Pen& pen, Vec2 center, double radius, double mass) {
  const bool is_heavy = mass >= 1000.0;
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.3g", is_heavy ? mass / 1000.0 : mass);
  const std::string text = words::filled(is_heavy ? words::tonnes : words::kilograms, {{"number", number.data()}});
  const double height = 0.52 * radius;  // m
  if (pen.prepares) prepare_text(pen, {text}, height);
  const double size = height * pen.scale();
  if (size < 6.0) return;
  const Vec2 at = pen.canvas.to_pixels(center) - Vec2{0.0, 0.5 * pen.canvas.line_height(size)};
  pen.canvas.text(at + Vec2{1.0, 1.0}, text, size, pen.colors.ink, engine::Align::center);
  pen.canvas.text(at, text, size, {250, 240, 220}, engine::Align::center);
  const double width = pen.canvas.text_width(text, size);
  pen.labels.push_back({at - Vec2{0.5 * width, 0.0}, {width, pen.canvas.line_height(size)}});
}

void draw_thrown_line(Pen& pen, Vec2 hand, Vec2 tip, double slack) {
  constexpr int pieces = 24;
  const double sag = 0.25 * slack * length(tip - hand);
  std::vector<Vec2> curve;
  for (int k = 0; k <= pieces; ++k) {
    const double s = static_cast<double>(k) / pieces;
    curve.push_back(hand + s * (tip - hand) - Vec2{0.0, 4.0 * sag * s * (1.0 - s)});
  }
  pen.canvas.strip(curve, {nullptr, 0.09, 1.0, 0.0, pen.colors.ink});
  pen.canvas.strip(curve, {&pen.images.cord, 0.055, 0.2, 0.0, pen.colors.line});
  pen.canvas.circle(tip, 0.1, pen.colors.ink);
  pen.canvas.circle(tip, 0.065, pen.colors.hook_in_range);
}

}  // namespace game
