#include "ribbon/layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ribbon {
namespace {

constexpr double min_corner_distance = 1e-6;  // m

/// A point of a path, m, and the segment that it is on.
struct PathPoint {
  Vec2 position;
  std::size_t segment;
};

/// Returns the first point of the path after `from` with the distance `link` [m] from it. The last segment is extended.
PathPoint next_point(const std::vector<Vec2>& path, const PathPoint& from, double link) {
  std::size_t k = from.segment;
  while (k + 2 < path.size() && length(path[k + 1] - from.position) < link) ++k;
  // The segment leaves the circle around `from` at the larger root t of |o + t·d| = link.
  const Vec2 d = (1.0 / length(path[k + 1] - path[k])) * (path[k + 1] - path[k]);
  const Vec2 o = path[k] - from.position;
  const double b = dot(o, d);
  const double t = std::sqrt(std::max(0.0, b * b - dot(o, o) + link * link)) - b;
  return {path[k] + t * d, k};
}

struct Steps {
  std::vector<Vec2> points;  // m
  bool reach_end;            // the last point is at the end of the path, or beyond
};

/// Returns `columns` points along the path, neighbours at the distance `link` [m].
Steps step_along(const std::vector<Vec2>& path, double link, int columns) {
  PathPoint current{path[0], 0};
  std::vector<Vec2> points{current.position};
  for (int i = 1; i < columns; ++i) {
    current = next_point(path, current, link);
    points.push_back(current.position);
  }
  const Vec2 last = path.back() - path[path.size() - 2];
  return {std::move(points), current.segment + 2 == path.size() && dot(current.position - path.back(), last) >= 0.0};
}

double length_of(const std::vector<Vec2>& path) {
  double sum = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) sum += length(path[k] - path[k - 1]);
  return sum;
}

/// Returns the middle of each column [m]. Bisection finds the link length with which the last one is at the end of the
/// path.
std::vector<Vec2> in_equal_links(const std::vector<Vec2>& path, int columns) {
  double short_link = 0.0;
  double long_link = length_of(path) / (columns - 1);  // exact for a straight path
  for (int halving = 0; halving < 60; ++halving) {
    const double link = 0.5 * (short_link + long_link);
    (step_along(path, link, columns).reach_end ? long_link : short_link) = link;
  }
  return step_along(path, short_link, columns).points;
}

/// Returns the points of all rows [m]. A column is perpendicular to the line between its neighbours: so cells overlap
/// at a corner only if the corner is too sharp for their width.
std::vector<Vec2> rows_across(const std::vector<Vec2>& middle, int rows, double width) {
  if (rows == 1) return middle;
  std::vector<Vec2> positions;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Vec2 along = middle[std::min(i + 1, middle.size() - 1)] - middle[i > 0 ? i - 1 : 0];
    const double distance = length(along);
    const Vec2 across = distance > 0.0 ? (1.0 / distance) * perp(along) : Vec2{0.0, 1.0};
    for (int j = 0; j < rows; ++j) positions.push_back(middle[i] + (width * (1.0 * j / (rows - 1) - 0.5)) * across);
  }
  return positions;
}

void check_path(const std::vector<Vec2>& path) {
  if (path.size() < 2) refuse("path.size", static_cast<double>(path.size()), "2 corners or more");
  for (const Vec2 corner : path) check_coordinates("path", corner);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const double distance = length(path[k] - path[k - 1]);
    if (!(distance >= min_corner_distance)) refuse("path's distance between corners", distance, "1e-06 m or more");
  }
}

}  // namespace

void lay_along(CordDef& def, const std::vector<Vec2>& path) {
  check_size(def);
  check_path(path);
  const std::vector<Vec2> middle = in_equal_links(path, def.points);
  def.length = length_of(middle);
  if (def.width == 0.0) def.width = (def.rows - 1) * def.length / (def.points - 1);
  def.positions = rows_across(middle, def.rows, def.width);
}

std::vector<int> triangle_indices(int columns, int rows) {
  std::vector<int> indices;
  for (int i = 0; i + 1 < columns; ++i) {
    for (int j = 0; j + 1 < rows; ++j) {
      const int a = i * rows + j;
      const int b = a + rows;
      indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return indices;
}

}  // namespace ribbon
