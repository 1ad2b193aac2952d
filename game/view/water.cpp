#include "game/view/water.h"

namespace game {
namespace {

constexpr engine::Color shallow{86, 150, 186, 120};
constexpr engine::Color deep{24, 62, 104, 190};
constexpr engine::Color surface{226, 242, 250, 190};
constexpr double fading_depth = 6.0;        // m, below which the water has one colour
constexpr double surface_thickness = 0.04;  // m

}  // namespace

void draw_water(Pen& pen, double level) {
  const double width = pen.canvas.width();
  const double height = pen.canvas.height();
  const double top = pen.canvas.to_pixels({0.0, level}).y;
  if (top >= height) return;
  const double bottom = top + fading_depth * pen.scale();
  pen.fade({0.0, top}, {width, bottom - top}, shallow, deep);
  if (bottom < height) pen.fade({0.0, bottom}, {width, height - bottom}, deep, deep);
  pen.fade({0.0, top}, {width, surface_thickness * pen.scale()}, surface, surface);
}

}  // namespace game
