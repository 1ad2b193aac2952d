#include "game/view/fall.h"

#include <algorithm>

#include "game/simulation/tick_rate.h"
#include "game/view/shading.h"
#include "game/view/veil.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr double gravity = 9.81;  // m/s²

}  // namespace

double Fall::openness(double alpha) const {
  if (!is_shown()) return 1.0;
  const double now = ticks_ - 1.0 + alpha;
  if (is_closing()) return 1.0 - smoothstep(0.0, closing, now + 1.0);
  return smoothstep(closing, closing + opening, now + 1.0);
}

Vec2 Fall::at(double alpha) const {
  const double t = tick_dt * std::max(ticks_ - 1.0 + alpha, 0.0);
  return at_ + t * velocity_ - Vec2{0.0, 0.5 * gravity * t * t};
}

void Fall::draw(Pen& pen, Vec2 player, double alpha) const {
  if (!is_shown()) return;
  const double open = openness(alpha);
  if (pen.reduced_motion) return draw_darkness(pen.canvas, 1.0 - open);
  draw_iris(pen.canvas, pen.canvas.to_pixels(is_closing() ? at(alpha) : player), open);
}

}  // namespace game
