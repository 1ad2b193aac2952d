#include "ribbon/layout.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ribbon {
namespace {

constexpr double least_distance = 1e-6;  // m, between corners

struct PathPoint {
  Vec2 at;
  std::size_t segment;
};

/// The first point of the path after `from` that is `link` away from it; the last segment goes on straight.
PathPoint next_point(const std::vector<Vec2>& path, const PathPoint& from, double link) {
  std::size_t k = from.segment;
  while (k + 2 < path.size() && length(path[k + 1] - from.at) < link) ++k;
  // |o + t·d| = link, where the segment leaves the circle.
  const Vec2 d = (1.0 / length(path[k + 1] - path[k])) * (path[k + 1] - path[k]);
  const Vec2 o = path[k] - from.at;
  const double b = dot(o, d);
  const double t = std::sqrt(std::max(0.0, b * b - dot(o, o) + link * link)) - b;
  return {path[k] + t * d, k};
}

struct Steps {
  std::vector<Vec2> points;
  bool arrive;  // at the path's end, or behind it
};

/// So many points along the path, each `link` from the next.
Steps step_along(const std::vector<Vec2>& path, double link, int columns) {
  PathPoint here{path[0], 0};
  std::vector<Vec2> points{here.at};
  for (int i = 1; i < columns; ++i) {
    here = next_point(path, here, link);
    points.push_back(here.at);
  }
  const Vec2 last = path.back() - path[path.size() - 2];
  return {std::move(points), here.segment + 2 == path.size() && dot(here.at - path.back(), last) >= 0.0};
}

double length_of(const std::vector<Vec2>& path) {
  double sum = 0.0;
  for (std::size_t k = 1; k < path.size(); ++k) sum += length(path[k] - path[k - 1]);
  return sum;
}

/// The middle of each column.
std::vector<Vec2> in_equal_links(const std::vector<Vec2>& path, int columns) {
  double falls_short = 0.0;
  double arrives = length_of(path) / (columns - 1);  // as long as the path is straight
  for (int halving = 0; halving < 60; ++halving) {
    const double link = 0.5 * (falls_short + arrives);
    (step_along(path, link, columns).arrive ? arrives : falls_short) = link;
  }
  return step_along(path, falls_short, columns).points;
}

/// The rows around that. They lie across the line from the column before to the one after, which at a corner keeps the
/// cells from crossing as long as they can.
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
    if (!(distance >= least_distance)) refuse("path's distance between corners", distance, "1e-06 m or more");
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
