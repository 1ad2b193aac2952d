#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

/// The distance of a point o from the segment from a to b, and what its first two derivatives need. With the nearest
/// point p = a + s·(b − a), the unit vector n from p to o, and t along the segment,
///
///     δd = n·δo − (1 − s)·n·δa − s·n·δb,
///     δ²d = 2·U·E/L − d·E²/L²,      E = n·(δb − δa),   U = t·((1 − s)·δa + s·δb − δo).
///
/// The second derivative holds for 0 < s < 1: the segment rotates by E/L, and p moves along it.
struct Separation {
  double distance;  ///< d, m, 0 or more
  double along;     ///< s, 0 … 1
  double length;    ///< L, m
  Vec2 normal;      ///< n
  Vec2 tangent;     ///< t
  /// Returns whether the nearest point is between the ends.
  bool is_interior() const { return along > 0.0 && along < 1.0; }
};

/// Returns false only if the point o is further than `distance` [m] from the segment from a to b. Cheaper than the
/// separation.
inline bool may_be_within(double distance, Vec2 o, Vec2 a, Vec2 b) {
  const Vec2 oa = a - o;
  const Vec2 ob = b - o;
  return !((oa.x > distance && ob.x > distance) || (oa.x < -distance && ob.x < -distance) ||
           (oa.y > distance && ob.y > distance) || (oa.y < -distance && ob.y < -distance));
}

/// Returns the separation of the point o from the segment from a to b. At distance 0 the normal points to the left of
/// the segment. If the segment has no length too, the normal points up; t is always perpendicular to n for such a
/// segment.
inline Separation find_separation(Vec2 o, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double size2 = dot(ab, ab);
  Separation found{0.0, 0.0, std::sqrt(size2), {0.0, 1.0}, {1.0, 0.0}};
  if (size2 > 0.0) {
    found.tangent = (1.0 / found.length) * ab;
    found.normal = perp(found.tangent);
    const double s = dot(o - a, ab) / size2;
    found.along = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
  }
  const Vec2 away = o - a - found.along * ab;
  found.distance = ribbon::length(away);
  if (found.distance > 0.0) found.normal = (1.0 / found.distance) * away;
  if (found.length == 0.0) found.tangent = -1.0 * perp(found.normal);
  return found;
}

}  // namespace ribbon
