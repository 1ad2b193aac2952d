#include "game/view/fraying.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr int most_fibres = 5;  // of a link
constexpr Color danger{214, 40, 40};

/// Draws a fibre that stands off the rope between two points.
void draw_fibre(Pen& pen, Vec2 from, Vec2 to, double strength, int seed) {
  const Vec2 piece = to - from;
  const double far = length(piece);
  if (far <= 0.0) return;
  const Vec2 along = (1.0 / far) * piece;
  const double side = scatter(seed, 1, 5) < 0.5 ? -1.0 : 1.0;
  const Vec2 foot = from + scatter(seed, 2, 5) * piece;
  const double out = strength * (0.1 + 0.14 * scatter(seed, 3, 5));
  const Vec2 tip = foot + side * out * perp(along) + (0.5 - scatter(seed, 4, 5)) * 0.16 * along;
  const std::array fibre = {foot, 0.5 * (foot + tip) + 0.03 * along, tip};
  pen.canvas.polyline(fibre, 0.045, pen.colors.ink);
  pen.canvas.polyline(fibre, 0.022, mix({240, 226, 190}, danger, strength));
}

}  // namespace

double load_share(const DrawnCord& cord, int link) {
  const ribbon::box2d::CordView view = cord.coupling.cord(cord.index);
  if (cord.shape.rows > 1 || view.solver() != ribbon::box2d::Solver::direct) return 0.0;
  const auto tensions = view.direct().tensions();
  if (link < 0 || static_cast<std::size_t>(link) >= tensions.size()) return 0.0;
  const double most = view.direct().breaking_force(link);
  if (!std::isfinite(most) || most <= 0.0) return 0.0;
  return std::max(0.0, tensions[static_cast<std::size_t>(link)] / most);
}

void draw_frays(Pen& pen, const DrawnCord& cord) {
  for (int link = 0; link + 1 < cord.shape.columns; ++link) {
    const double load = load_share(cord, link);
    if (load < fraying_load) continue;
    const double strength = std::min(1.0, (load - fraying_load) / (1.0 - fraying_load));
    const Vec2 from = cord.at(cord.point(link, 0));
    const Vec2 to = cord.at(cord.point(link + 1, 0));
    if (!pen.sees(from, 1.0)) continue;
    const int fibres = 1 + static_cast<int>(strength * (most_fibres - 1));
    for (int k = 0; k < fibres; ++k) draw_fibre(pen, from, to, 0.4 + 0.6 * strength, 97 * link + 7 * k + cord.index);
  }
}

}  // namespace game
