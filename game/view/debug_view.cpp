#include "game/view/debug_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace game {
namespace {

using engine::Color;
using ribbon::PointKind;
using ribbon::Vec2;

// As in Goto 2017, Fig. 4.1.
constexpr Color free_point{40, 90, 230};
constexpr Color sleeping_point{150, 150, 165};
constexpr Color operated_point{250, 220, 40};
constexpr Color constrained_point{225, 40, 40};
constexpr Color contact_color{255, 120, 220};

bool is_direct(const DrawnCord& cord) {
  return cord.coupling.cord(cord.index).solver() == ribbon::box2d::Solver::direct;
}

/// Returns the colour of the tension; white if it is unknown.
Color bar_color(const DrawnCord& cord, int column) {
  if (cord.shape.rows > 1 || !is_direct(cord)) return {255, 255, 255, 200};
  return tension_color(cord.coupling.cord(cord.index).direct().tensions()[static_cast<std::size_t>(column)]);
}

void draw_bars(Pen& pen, const DrawnCord& cord) {
  const double width = cord.shape.rows > 1 ? 0.015 : 0.05;
  const auto draw_bar = [&](int a, int i, int j) {
    if (i >= cord.shape.columns || j < 0 || j >= cord.shape.rows) return;
    const int column = a / cord.shape.rows;
    pen.canvas.polyline(std::array{cord.at(a), cord.at(cord.point(i, j))}, width, bar_color(cord, column));
  };
  for (int i = 0; i < cord.shape.columns; ++i) {
    for (int j = 0; j < cord.shape.rows; ++j) {
      const int a = cord.point(i, j);
      draw_bar(a, i, j + 1);
      draw_bar(a, i + 1, j);
      if (!cord.shape.braced) continue;
      draw_bar(a, i + 1, j - 1);
      draw_bar(a, i + 1, j + 1);
    }
  }
}

void draw_points(Pen& pen, const DrawnCord& cord) {
  const bool sleeps = is_direct(cord) && cord.coupling.cord(cord.index).direct().is_asleep();
  for (int p = 0; p < cord.size(); ++p) {
    const PointKind kind = cord.kind(p);
    const Color color = kind == PointKind::free       ? (sleeps ? sleeping_point : free_point)
                        : kind == PointKind::operated ? operated_point
                                                      : constrained_point;
    pen.canvas.circle(cord.at(p), kind == PointKind::operated ? 0.11 : 0.055, color);
  }
}

/// Rows are numbered to the left of the direction along the cord, so the corners of a cell are counter-clockwise.
void draw_inverted_cells(Pen& pen, const DrawnCord& cord) {
  for (int i = 0; i + 1 < cord.shape.columns; ++i) {
    for (int j = 0; j + 1 < cord.shape.rows; ++j) {
      const std::array corners = {cord.at(cord.point(i, j)), cord.at(cord.point(i + 1, j)),
                                  cord.at(cord.point(i + 1, j + 1)), cord.at(cord.point(i, j + 1))};
      if (cross(corners[2] - corners[0], corners[3] - corners[1]) > 0.0) continue;
      pen.canvas.triangles(corners, std::array{0, 1, 2, 0, 2, 3}, {225, 40, 40, 170});
    }
  }
}

void draw_swept_aabb(Pen& pen, const DrawnCord& cord) {
  const ribbon::Box& box = cord.coupling.cord(cord.index).swept_aabb();
  const std::array corners = {box.low, Vec2{box.high.x, box.low.y}, box.high, Vec2{box.low.x, box.high.y}, box.low};
  pen.canvas.polyline(corners, 0.02, {255, 255, 255, 150});
}

/// Draws each contact with its normal, whose length grows with the square root of the impulse.
void draw_contacts(Pen& pen, const DrawnCord& cord) {
  if (!is_direct(cord)) return;
  for (const ribbon::Touch& touch : cord.coupling.cord(cord.index).direct().touches()) {
    const double size = std::clamp(0.25 * std::sqrt(std::abs(touch.impulse)), 0.2, 1.2);
    pen.canvas.polyline(std::array{touch.point, touch.point + size * touch.normal}, 0.035, contact_color);
    pen.canvas.circle(touch.point, 0.06, contact_color);
  }
}

}  // namespace

Color tension_color(double tension) { return ramp_color(0.25 * std::log10(std::max(tension, 1.0))); }

void draw_debug(Pen& pen, const DrawnCord& cord) {
  draw_swept_aabb(pen, cord);
  draw_inverted_cells(pen, cord);
  draw_bars(pen, cord);
  draw_points(pen, cord);
  draw_contacts(pen, cord);
}

}  // namespace game
