#pragma once

#include <algorithm>

#include "ribbon/vec2.h"

/// The edges of triangles along rows of pixels; private to the rasteriser.
namespace engine {

/// Returns the first pixel whose middle is at x or after it, clamped to low … high.
inline int first_pixel(double x, int low, int high) {
  // Does not use ceil, which would be a call.
  const double near = std::clamp(x - 0.5, static_cast<double>(low), static_cast<double>(high));
  const int whole = static_cast<int>(near);
  return whole + (whole < near ? 1 : 0);
}

/// An edge, to find its x at a height. Always computed from its upper end, so that two triangles that share an edge get
/// the same x: no pixel between them is missed or painted twice.
struct Edge {
  Edge(ribbon::Vec2 upper, ribbon::Vec2 lower) : at(upper), slope((lower.x - upper.x) / (lower.y - upper.y)) {}
  double x(double y) const { return at.x + (y - at.y) * slope; }

  ribbon::Vec2 at;
  double slope;
};

/// The order of the corners of a triangle: from the top, and from the left at the same height.
inline bool is_above(ribbon::Vec2 a, ribbon::Vec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }

}  // namespace engine
