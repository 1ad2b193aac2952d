#pragma once

#include <optional>

#include "ribbon/box2d/crossing.h"
#include "ribbon/vec2.h"

namespace game {

/// A segment between two points, m.
struct Segment {
  ribbon::Vec2 a;
  ribbon::Vec2 b;
};

/// Returns the place, 0 … 1 from `a` to `b`, where a segment crosses an edge.
inline std::optional<double> crossing(const Segment& segment, const Segment& edge) {
  return ribbon::box2d::crossing(segment.a, segment.b, edge.a, edge.b);
}

/// When and where a moving segment meets something.
struct Meeting {
  double time = 0.0;   ///< above 0 … 1 of the way
  double place = 0.0;  ///< 0 … 1 from `a` to `b`
};

/// Returns when a segment first meets an edge while the ends of both move in straight lines from one place to another.
/// Nothing if they do not meet on the way, or meet at its start already.
std::optional<Meeting> swept_crossing(const Segment& from, const Segment& to, const Segment& edge_from,
                                      const Segment& edge_to);

}  // namespace game
