#include "ribbon/cord_line.h"

#include <algorithm>

namespace ribbon {

Vec2 CordLine::tangent(int link) const {
  const Vec2 edge = at(link + 1) - at(link);
  const double size = length(edge);
  return size > 0.0 ? (1.0 / size) * edge : Vec2{};
}

/// Returns the place on a link, 0 … 1, that is nearest to a position.
double CordLine::nearest(int link, Vec2 position) const {
  const Vec2 edge = at(link + 1) - at(link);
  const double size2 = dot(edge, edge);
  return size2 > 0.0 ? std::clamp(dot(position - at(link), edge) / size2, 0.0, 1.0) : 0.0;
}

double CordLine::nearest_column(int link, Vec2 position) const {
  double along = nearest(link, position);
  double distance = length(position - place(link, along));
  for (;;) {
    const int next = link + (along >= 1.0 ? 1 : along <= 0.0 ? -1 : 0);
    if (next == link || next < 0 || next >= links()) return link + along;
    const double next_along = nearest(next, position);
    const double next_distance = length(position - place(next, next_along));
    if (!(next_distance < distance)) return link + along;
    link = next;
    along = next_along;
    distance = next_distance;
  }
}

}  // namespace ribbon
