#include "game/view/cords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "game/view/cloth.h"
#include "ribbon/smooth_line.h"

namespace game {
namespace {

using engine::Color;
using ribbon::PointKind;
using ribbon::Vec2;

constexpr double min_width = 0.07;     // m, so that thin ropes are visible
constexpr double cord_outline = 0.05;  // m, half of it on each side
constexpr double piece = 8.0;          // px, the length of straight pieces of a curve

/// Returns the number of pieces of the spline between two columns.
int steps_between(const Pen& pen, const DrawnCord& cord) {
  double max_length = 0.0;
  for (int i = 1; i < cord.shape.columns; ++i)
    max_length = std::max(max_length, length(cord.at(cord.point(i, 0)) - cord.at(cord.point(i - 1, 0))));
  return static_cast<int>(std::clamp(std::ceil(max_length * pen.scale() / piece), 1.0, 16.0));
}

std::vector<Color> spread_colors(const std::vector<Color>& colors, int steps) {
  std::vector<Color> all;
  all.reserve(colors.size() * static_cast<std::size_t>(steps));
  for (std::size_t i = 0; i + 1 < colors.size(); ++i)
    for (int k = 0; k < steps; ++k) all.push_back(mix(colors[i], colors[i + 1], static_cast<double>(k) / steps));
  if (!colors.empty()) all.push_back(colors.back());
  return all;
}

double drawn_width(const DrawnCord& cord) { return std::max(cord.shape.thickness, min_width); }

/// Returns how clearly the tension is drawn, 0 … 1: from 1.3 weights of the player on, as in a swing.
double tautness(const DrawnCord& cord) { return std::clamp((cord.load - 1.3) / 1.7, 0.0, 1.0); }

/// Draws two thin lines beside a taut rope, which tremble.
void draw_tremble(Pen& pen, const std::vector<Vec2>& curve, double width, double taut) {
  if (taut <= 0.0 || pen.reduced_motion || curve.size() < 3) return;
  const double swing = 0.05 * taut * std::sin(75.0 * pen.time);
  for (const double side : {-1.0, 1.0}) {
    std::vector<Vec2> line;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec2 along = curve[std::min(i + 1, curve.size() - 1)] - curve[i > 0 ? i - 1 : 0];
      const double l = length(along);
      if (l <= 0.0) continue;
      const double s = static_cast<double>(i) / static_cast<double>(curve.size() - 1);
      const double away = side * (0.5 * width + 0.05) + swing * std::sin(std::numbers::pi * s);
      line.push_back(curve[i] + (away / l) * perp(along));
    }
    pen.canvas.strip(line, {nullptr, 0.022, 1.0, 0.0, with_alpha({255, 255, 255}, static_cast<int>(120.0 * taut))});
  }
}

void draw_rope(Pen& pen, const DrawnCord& cord, const std::vector<Color>& colors) {
  const double width = drawn_width(cord);
  const int steps = steps_between(pen, cord);
  const std::vector<Vec2> curve = smooth_row(cord, 0, steps);
  const double taut = tautness(cord);
  const Color color = mix(own_color(pen, cord), {255, 255, 255}, 0.45 * taut);
  draw_tremble(pen, curve, width, taut);
  engine::StripLook look;
  look.width = width + cord_outline;
  look.color = mix(pen.colors.ink, color, 0.25);
  pen.canvas.strip(curve, look);
  look.image = width < 0.12 ? &pen.images.cord : &pen.images.rope;
  look.width = width;
  look.image_length = 4.0 * width;
  look.color = color;
  const std::vector<Color> tints = spread_colors(colors, steps);
  look.colors = tints;
  pen.canvas.strip(curve, look);
}

/// Draws thread wound round a free end.
void draw_whipping(Pen& pen, const DrawnCord& cord, int end, int inner) {
  if (cord.kind(end) == PointKind::constrained || cord.is_line) return;
  const Vec2 inwards = cord.at(inner) - cord.at(end);
  if (length(inwards) <= 0.0) return;
  const double width = drawn_width(cord);
  const Vec2 in = (1.3 * width / length(inwards)) * inwards;
  const Vec2 tip = cord.at(end) - 0.25 * in;
  pen.canvas.polyline(std::array{tip, tip + 0.2 * in}, 1.15 * width, own_color(pen, cord));
  pen.canvas.strip(std::array{cord.at(end) + 0.25 * in, cord.at(end) + in},
                   {nullptr, 1.3 * width, 1.0, 0.0, pen.colors.ink});
  pen.canvas.strip(std::array{cord.at(end) + 0.45 * in, cord.at(end) + 0.8 * in},
                   {nullptr, 1.3 * width, 1.0, 0.0, pen.colors.ribbons[0]});
}

/// Draws an iron ring with a bolt.
void draw_pin(Pen& pen, Vec2 at, double radius) {
  pen.canvas.circle(at, radius + 0.035, pen.colors.ink);
  pen.disc(pen.images.iron, at, radius, pen.colors.iron);
  pen.disc(pen.images.shade, at, radius, {255, 255, 255});
  pen.canvas.circle(at, 0.34 * radius, pen.colors.ink);
  pen.canvas.circle(at + Vec2{-0.02, 0.02}, 0.2 * radius, mix(pen.colors.iron, {255, 255, 255}, 0.5));
}

/// Draws a rod along the pins of a column, or a ring if there is only one.
void draw_fixing(Pen& pen, const DrawnCord& cord, int column) {
  std::vector<Vec2> fixed;
  for (int j = 0; j < cord.shape.rows; ++j)
    if (cord.kind(cord.point(column, j)) == PointKind::constrained) fixed.push_back(cord.at(cord.point(column, j)));
  if (fixed.empty()) return;
  if (fixed.size() == 1) {
    draw_pin(pen, fixed.front(), cord.shape.rows > 1 ? 0.11 : 0.6 * cord.shape.thickness + 0.06);
    return;
  }
  const std::array rod = {fixed.front(), fixed.back()};
  pen.canvas.polyline(rod, 0.2, pen.colors.ink);
  pen.canvas.polyline(rod, 0.13, pen.colors.iron);
  for (const Vec2 end : rod) draw_pin(pen, end, 0.1);
}

bool is_seen(const Pen& pen, const DrawnCord& cord) {
  if (cord.points.empty()) return false;
  Vec2 low = cord.points.front();
  Vec2 high = low;
  for (const Vec2 p : cord.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return pen.sees(0.5 * (low + high), 0.5 * length(high - low) + 0.5);
}

}  // namespace

const Color& own_color(const Pen& pen, const DrawnCord& cord) {
  if (cord.is_line) return pen.colors.line;
  const auto number = static_cast<std::size_t>(cord.index);
  return cord.shape.rows > 1 ? pen.colors.ribbons[number % pen.colors.ribbons.size()]
                             : pen.colors.ropes[number % pen.colors.ropes.size()];
}

double largest_tension(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord) {
  const ribbon::box2d::CordView view = coupling.cord(cord);
  if (view.solver() != ribbon::box2d::Solver::direct || view.shape().rows > 1) return 0.0;
  const auto tensions = view.direct().tensions();
  return tensions.empty() ? 0.0 : *std::max_element(tensions.begin(), tensions.end());
}

double strain(const DrawnCord& cord, int column) {
  const int i = std::clamp(column, 0, cord.shape.columns - 2);
  double sum = 0.0;
  for (int j = 0; j < cord.shape.rows; ++j)
    sum += length(cord.at(cord.point(i + 1, j)) - cord.at(cord.point(i, j))) / cord.shape.rows;
  return sum / cord.coupling.cord(cord.index).grid().rest_lengths[i] - 1.0;
}

std::vector<Vec2> smooth_row(const DrawnCord& cord, int row, int steps) {
  std::vector<ribbon::LineVertex> line(ribbon::smooth_line_size(cord.shape.columns, steps));
  ribbon::smooth_line({cord.points, cord.shape.rows}, row, steps, line);
  std::vector<Vec2> curve;
  curve.reserve(line.size());
  for (const ribbon::LineVertex& vertex : line) curve.push_back(vertex.position);
  return curve;
}

Color strain_color(double strain) {
  // Lighter than the ramp, since the shading of the rope makes it darker.
  const Color color = ramp_color(std::sqrt(std::clamp(strain / max_strain, 0.0, 1.0)));
  return mix(color, {255, 255, 255}, 0.25);
}

void draw_cord(Pen& pen, const DrawnCord& cord, const std::vector<Color>& colors) {
  if (!is_seen(pen, cord)) return;
  if (cord.shape.rows > 1) {
    draw_cloth(pen, cord, steps_between(pen, cord), own_color(pen, cord), colors);
  } else {
    draw_rope(pen, cord, colors);
    draw_whipping(pen, cord, 0, std::min(1, cord.shape.columns - 1));
    draw_whipping(pen, cord, cord.shape.columns - 1, std::max(cord.shape.columns - 2, 0));
  }
  if (cord.is_line) return;  // its pin is at a hook, which is drawn separately
  for (int i = 0; i < cord.shape.columns; ++i) draw_fixing(pen, cord, i);
}

}  // namespace game
