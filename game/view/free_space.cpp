#include "game/view/free_space.h"

#include <algorithm>
#include <cstddef>

namespace game {

using ribbon::Vec2;

namespace {

constexpr double return_gap = 4.0;  // gaps that must be free before a box returns to an earlier place of its list
constexpr int steps = 24;           // of the search, in either direction

double shared(double a, double a_size, double b, double b_size) {
  return std::max(0.0, std::min(a + a_size, b + b_size) - std::max(a, b));
}

Rectangle widened(const Rectangle& box, double gap) {
  return {box.corner - Vec2{gap, gap}, box.size + Vec2{2.0 * gap, 2.0 * gap}};
}

}  // namespace

double shared_area(const Rectangle& a, const Rectangle& b) {
  return shared(a.corner.x, a.size.x, b.corner.x, b.size.x) * shared(a.corner.y, a.size.y, b.corner.y, b.size.y);
}

Vec2 FreeSpace::inside(Vec2 corner, Vec2 size) const {
  const Vec2 room = area_.size - size;
  return area_.corner + Vec2{std::clamp(corner.x - area_.corner.x, 0.0, std::max(room.x, 0.0)),
                             std::clamp(corner.y - area_.corner.y, 0.0, std::max(room.y, 0.0))};
}

bool FreeSpace::is_free(const Rectangle& box, double gap) const {
  if (box.size.x > area_.size.x || box.size.y > area_.size.y) return false;
  return std::none_of(taken_.begin(), taken_.end(),
                      [&](const Rectangle& taken) { return shared_area(widened(box, gap), taken) > 0.0; });
}

std::optional<Vec2> FreeSpace::nearest_free(Vec2 size, Vec2 wanted) const {
  std::optional<Vec2> best;
  const Vec2 room = area_.size - size;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const Vec2 at = inside(area_.corner + Vec2{room.x * i / steps, room.y * j / steps}, size);
      if (best && length(at - wanted) >= length(*best - wanted)) continue;
      if (is_free({at, size}, gap_)) best = at;
    }
  }
  return best;
}

std::optional<Vec2> FreeSpace::place(Vec2 size, std::span<const Vec2> wanted, int& last) {
  std::optional<Vec2> at;
  int chosen = 0;
  for (std::size_t k = 0; k < wanted.size() && !at; ++k) {
    const bool returns = static_cast<int>(k) < last;
    const Vec2 corner = inside(wanted[k], size);
    if (!is_free({corner, size}, returns ? return_gap * gap_ : gap_)) continue;
    at = corner;
    chosen = static_cast<int>(k);
  }
  if (!at) at = nearest_free(size, inside(wanted.front(), size));
  last = chosen;
  if (at) take({*at, size});
  return at;
}

}  // namespace game
