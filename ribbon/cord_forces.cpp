#include "ribbon/cord_forces.h"

#include <algorithm>
#include <cmath>

#include "ribbon/system/cord_parts.h"

namespace ribbon {
namespace {

void check_point(const Cord& cord, int point) { check_range("point", point, 0, cord.size() - 1.0); }

}  // namespace

CordEnergy energy_of(const Cord& cord, Vec2 gravity) { return cord.parts().energy(gravity); }

double tension_of(const Cord& cord, int link) {
  check_range("link", link, 0, cord.def().points - 2);
  return cord.parts().tension(static_cast<std::size_t>(link));
}

Vec2 reaction(const Cord& cord, int point, Vec2 gravity) {
  check_point(cord, point);
  return cord.kind(point) == PointKind::free ? Vec2{} : holding_force(cord, point, gravity);
}

Vec2 holding_force(const Cord& cord, int point, Vec2 gravity) {
  check_point(cord, point);
  return cord.parts().holding_force(static_cast<std::size_t>(point), gravity);
}

std::optional<int> overloaded_link(const Cord& cord) {
  if (cord.parts().state.breaking_forces.empty() && std::isinf(cord.def().breaking_force)) return std::nullopt;
  std::optional<int> overloaded;
  double highest = 1.0;
  for (int link = 0; link + 1 < cord.def().points; ++link) {
    // A link without any strength breaks under any tension.
    const double load = std::max(0.0, tension_of(cord, link)) / cord.breaking_force(link);
    if (!(load > highest)) continue;
    highest = load;
    overloaded = link;
  }
  return overloaded;
}

}  // namespace ribbon
