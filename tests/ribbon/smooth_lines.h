#pragma once

#include <vector>

#include "ribbon/smooth_line.h"

namespace ribbon {

inline std::vector<LineVertex> line_of(const PointGrid& points, int subdivisions, int row = 0) {
  std::vector<LineVertex> line(smooth_line_size(points.columns(), subdivisions));
  smooth_line(points, row, subdivisions, line);
  return line;
}

inline std::vector<LineVertex> line_of(const std::vector<Vec2>& positions, int subdivisions) {
  return line_of(PointGrid{positions}, subdivisions);
}

inline std::vector<StripVertex> strip_of(const PointGrid& points, double radius, int subdivisions) {
  std::vector<StripVertex> strip(smooth_strip_size(points.columns(), subdivisions));
  smooth_strip(points, radius, subdivisions, strip);
  return strip;
}

}  // namespace ribbon
