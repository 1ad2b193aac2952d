#include "game/view/view_in.h"

#include <algorithm>

namespace game {

using ribbon::Vec2;

namespace {

constexpr double margin = 3.0;  // m, from the player to the side of the part

}  // namespace

engine::View view_in(const Rectangle& part, const engine::Canvas& canvas, const engine::View& of_part, Vec2 player,
                     Vec2 level) {
  const double half = 0.5 * part.size.x / of_part.pixels_per_metre;
  const double room = std::max(half - margin, 0.0);
  double x = std::clamp(of_part.center.x, player.x - room, player.x + room);
  if (2.0 * half < level.x) x = std::clamp(x, half, level.x - half);
  const Vec2 off = part.corner + 0.5 * part.size - 0.5 * Vec2{1.0 * canvas.width(), 1.0 * canvas.height()};
  const double metres = 1.0 / of_part.pixels_per_metre;
  return {Vec2{x, of_part.center.y} + metres * Vec2{-off.x, off.y}, of_part.pixels_per_metre};
}

}  // namespace game
