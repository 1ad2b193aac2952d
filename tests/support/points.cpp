#include "tests/support/points.h"

#include <algorithm>
#include <limits>

namespace test_support {

using ribbon::Vec2;

std::vector<Vec2> equally_spaced(int count, Vec2 start, Vec2 step) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back(start + static_cast<double>(i) * step);
  return points;
}

std::vector<Vec2> copy(std::span<const Vec2> points) { return {points.begin(), points.end()}; }

double max_distance(std::span<const Vec2> from, std::span<const Vec2> to) {
  double distance = 0.0;
  for (std::size_t p = 0; p < from.size(); ++p) distance = std::max(distance, length(to[p] - from[p]));
  return distance;
}

double path_length(std::span<const Vec2> points) {
  double sum = 0.0;
  for (std::size_t p = 1; p < points.size(); ++p) sum += length(points[p] - points[p - 1]);
  return sum;
}

double distance_to_path(Vec2 p, std::span<const Vec2> path) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec2 a = path[i - 1];
    const Vec2 ab = path[i] - a;
    const double along = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
    nearest = std::min(nearest, length(p - a - along * ab));
  }
  return nearest;
}

bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto is_left = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p) > 0.0; };
  return is_left(a, b, c) != is_left(a, b, d) && is_left(c, d, a) != is_left(c, d, b);
}

bool all_finite(std::span<const Vec2> points) {
  return std::ranges::all_of(points, [](Vec2 p) { return is_finite(p); });
}

}  // namespace test_support
