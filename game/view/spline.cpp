#include "game/view/spline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace game {
namespace {

using ribbon::Vec2;

/// Returns the knot interval between two points: the square root of their distance, but not 0.
double knots_between(Vec2 a, Vec2 b) { return std::max(std::sqrt(length(b - a)), 1e-4); }

/// Evaluates the spline between p1 (s = 0) and p2 (s = 1) with Barry and Goldman's pyramid.
Vec2 between(Vec2 p0, Vec2 p1, Vec2 p2, Vec2 p3, double s) {
  const double t0 = knots_between(p0, p1);
  const double t1 = knots_between(p1, p2);
  const double t2 = knots_between(p2, p3);
  const double t = s * t1;  // from p1
  const auto line = [t](Vec2 a, Vec2 b, double at_a, double at_b) {
    return a + ((t - at_a) / (at_b - at_a)) * (b - a);
  };
  const Vec2 before = line(p0, p1, -t0, 0.0);
  const Vec2 middle = line(p1, p2, 0.0, t1);
  const Vec2 after = line(p2, p3, t1, t1 + t2);
  return line(line(before, middle, -t0, t1), line(middle, after, 0.0, t1 + t2), 0.0, t1);
}

}  // namespace

void smooth_curve(std::span<const Vec2> points, int steps, std::vector<Vec2>& curve) {
  curve.clear();
  if (points.empty()) return;
  const std::size_t last = points.size() - 1;
  curve.reserve(1 + last * static_cast<std::size_t>(std::max(steps, 1)));
  curve.push_back(points.front());
  for (std::size_t i = 0; i < last; ++i) {
    const Vec2 p1 = points[i];
    const Vec2 p2 = points[i + 1];
    // Beyond its ends the curve continues as the reflection of its first and last piece.
    const Vec2 p0 = i > 0 ? points[i - 1] : p1 - (p2 - p1);
    const Vec2 p3 = i + 1 < last ? points[i + 2] : p2 + (p2 - p1);
    for (int k = 1; k < steps; ++k) curve.push_back(between(p0, p1, p2, p3, static_cast<double>(k) / steps));
    curve.push_back(p2);
  }
}

}  // namespace game
