#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

/// The distance from a point o to the segment from a to b, and what its first two derivatives need. With n the unit
/// vector from the nearest point p = a + s·(b − a) to o, and t along the segment,
///
///     δd = n·δo − (1 − s)·n·δa − s·n·δb,
///     δ²d = 2·U·E/L − d·E²/L²,      E = n·(δb − δa),   U = t·((1 − s)·δa + s·δb − δo),
///
/// the second for 0 < s < 1: the segment turns by E/L, and the nearest point moves along it.
struct Gap {
  double distance;  ///< d, m
  double along;     ///< s, 0 … 1
  double length;    ///< L, m
  Vec2 normal;      ///< n
  Vec2 tangent;     ///< t
  bool inside() const { return along > 0.0 && along < 1.0; }
};

/// False only if the point o is further than `distance` from the segment from a to b.
inline bool may_be_within(double distance, Vec2 o, Vec2 a, Vec2 b) {
  const Vec2 oa = a - o;
  const Vec2 ob = b - o;
  return !((oa.x > distance && ob.x > distance) || (oa.x < -distance && ob.x < -distance) ||
           (oa.y > distance && ob.y > distance) || (oa.y < -distance && ob.y < -distance));
}

/// A point that lies on the segment is taken to be left of it, one on a segment without length above it; along that is
/// at right angles to the normal.
inline Gap gap_between(Vec2 o, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double size2 = dot(ab, ab);
  Gap gap{0.0, 0.0, std::sqrt(size2), {0.0, 1.0}, {1.0, 0.0}};
  if (size2 > 0.0) {
    gap.tangent = (1.0 / gap.length) * ab;
    gap.normal = perp(gap.tangent);
    const double s = dot(o - a, ab) / size2;
    gap.along = s < 0.0 ? 0.0 : s > 1.0 ? 1.0 : s;
  }
  const Vec2 away = o - a - gap.along * ab;
  gap.distance = ribbon::length(away);
  if (gap.distance > 0.0) gap.normal = (1.0 / gap.distance) * away;
  if (gap.length == 0.0) gap.tangent = -1.0 * perp(gap.normal);
  return gap;
}

}  // namespace ribbon
