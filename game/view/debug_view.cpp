#include "game/view/debug_view.h"

#include <array>

namespace game {
namespace {

using engine::Color;
using ribbon::PointKind;

// Goto 2017, Fig. 4.1.
constexpr Color free_point{40, 90, 230};
constexpr Color operated_point{250, 220, 40};
constexpr Color constrained_point{225, 40, 40};

void draw_bars(Pen& pen, const DrawnCord& cord) {
  const auto draw_bar = [&](int a, int i, int j) {
    if (i >= cord.shape.columns || j < 0 || j >= cord.shape.rows) return;
    pen.canvas.polyline(std::array{cord.at(a), cord.at(cord.point(i, j))}, 0.015, {255, 255, 255, 200});
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

}  // namespace

void draw_cord_points(Pen& pen, const DrawnCord& cord) {
  draw_bars(pen, cord);
  for (int p = 0; p < cord.size(); ++p) {
    const PointKind kind = cord.kind(p);
    const Color color = kind == PointKind::free       ? free_point
                        : kind == PointKind::operated ? operated_point
                                                      : constrained_point;
    pen.canvas.circle(cord.at(p), kind == PointKind::operated ? 0.11 : 0.055, color);
  }
}

}  // namespace game
