#pragma once

#include <cstddef>
#include <span>
#include <variant>

#include "ribbon/cord.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/vec2.h"

namespace ribbon {

// Smooth lines and strips of triangles along cords, for drawing. They are written to memory of the caller, as plain
// data that any renderer takes; nothing is allocated. All functions throw DefinitionError, and write nothing, for a
// value out of range.
//
// The line is a centripetal Catmull-Rom spline. It passes through the points of the cord, so it stays at pins, grips
// and contacts, where a B-spline cuts corners. A piece between two points depends on four points only. With this
// parametrisation a piece has no cusp, does not cross itself and stays within a quarter of its link's length of the
// straight link, however unequal the links are (Yuksel, Schaefer & Keyser 2011). Beyond an end, the cord continues as
// its mirror image across the middle of the end link, so that an arc of a circle stays one up to its ends. Points in
// the same place count as one.

/// Rest lengths of the links from column to column: a small view to copy. What it refers to must outlive it.
class RestLengths {
 public:
  /// All links have the length `link` [m, 0 … 1e9].
  explicit RestLengths(double link) : lengths_(link) {}
  /// The lengths by link [m, 0 … 1e9].
  explicit RestLengths(std::span<const double> links) : lengths_(links) {}
  /// Those of a cord, also while it is reeled.
  explicit RestLengths(const Cord& cord) : lengths_(&cord) {}

  /// Returns whether there are this many links.
  bool fits(int links) const;
  /// Returns the length of a link, m. Does not check the index.
  double operator[](int link) const;

 private:
  std::variant<double, std::span<const double>, const Cord*> lengths_;
};

/// Points to draw: those of a cord, or others, such as positions between two ticks.
struct PointGrid {
  std::span<const Vec2> positions;              ///< m, within ±1e9; point (i, j) has index i·rows + j
  int rows = 1;                                 ///< number of points across the cord, 1 … 64
  RestLengths rest_lengths = RestLengths(1.0);  ///< of the links between columns

  /// Returns the number of points along the cord; at least 2 are accepted.
  int columns() const { return static_cast<int>(positions.size()) / rows; }
};

/// Returns the points of a cord. Valid until the cord is stepped, changed or moved.
/// @{
PointGrid point_grid(const Cord& cord);
PointGrid point_grid(const ThesisCord& cord);
/// @}

/// A vertex of a smooth line.
struct LineVertex {
  Vec2 position;     ///< m
  Vec2 normal;       ///< unit vector, to the left of the direction along the line
  double arc = 0.0;  ///< m of rest length from the first point

  bool operator==(const LineVertex&) const = default;
};

/// A vertex of a strip of triangles. `arc` and `across` are its texture coordinates.
struct StripVertex {
  Vec2 position;        ///< m
  double arc = 0.0;     ///< m of rest length from the first point
  double across = 0.0;  ///< 0 at the right edge, which is row 0 of a ribbon, and 1 at the left one

  bool operator==(const StripVertex&) const = default;
};

/// Returns the number of vertices of a line through `columns` points, 2 … 1,000,000, with 1 … 1000 `subdivisions` of
/// each link: one for each point and subdivisions − 1 between two of them.
std::size_t smooth_line_size(int columns, int subdivisions);
/// Returns the number of vertices of a strip: two for each vertex of its line.
std::size_t smooth_strip_size(int columns, int subdivisions);

/// Writes the smooth line through one row of points and returns the vertices that it wrote: the first
/// smooth_line_size(columns, subdivisions) of `vertices`, which may be more. Vertex i·subdivisions is at point i, and
/// `arc` there is the sum of the rest lengths before it; between two points, `arc` grows with the length of the line.
/// A normal is perpendicular to the mean direction of the two pieces at its vertex. Where the line folds back on
/// itself, it points back along the line; where the line has no length, it is that of the vertex before.
std::span<LineVertex> smooth_line(const PointGrid& points, int row, int subdivisions, std::span<LineVertex> vertices);

/// Writes the outline of a cord as a strip of triangles and returns the vertices that it wrote: the first
/// smooth_strip_size(columns, subdivisions) of `vertices`, alternately on the right and on the left edge. Each vertex
/// and the two after it are a triangle. `radius` [m, 0 … 1e6] is usually CordDef::radius. The ends are cut straight.
///
/// A rope is 2·radius wide, also at bends between two vertices of up to 90°; at sharper ones its edges stay within
/// √2·radius of its line, so nothing sticks out. The edges of a ribbon are the smooth lines through its outer rows,
/// each moved outwards by `radius`; `arc` grows with the length of the line midway between them.
std::span<StripVertex> smooth_strip(const PointGrid& points, double radius, int subdivisions,
                                    std::span<StripVertex> vertices);

}  // namespace ribbon
