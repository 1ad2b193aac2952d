#include "ribbon/smooth_line.h"

#include <cmath>
#include <numbers>
#include <string>

#include "ribbon/definition.h"
#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr int max_points = 1'000'000;
constexpr int max_rows = 64;
constexpr int max_subdivisions = 1000;
constexpr double max_rest_length = 1e9;  // m
constexpr double max_radius = 1e6;       // m
constexpr double same_place = 1e-150;    // m; squares of smaller distances are rounded to few digits or to 0
// Of the distance of an edge from the line. At a bend by the angle β the full width takes a distance of
// radius / cos(β/2): here up to 90°.
constexpr double max_mitre = std::numbers::sqrt2;

void check_size(int columns, int subdivisions) {
  check_range("columns", columns, 2, max_points);
  check_range("subdivisions", subdivisions, 1, max_subdivisions);
}

void check_grid(const PointGrid& points) {
  check_range("rows", points.rows, 1, max_rows);
  const std::size_t size = points.positions.size();
  if (size > at(max_points) || size % at(points.rows) != 0) {
    refuse("positions.size", static_cast<double>(size), "a multiple of rows, up to 1e+06");
  }
  check_range("columns", points.columns(), 2, max_points);
  for (const Vec2 position : points.positions) check_coordinates("positions", position);
  const int links = points.columns() - 1;
  if (!points.rest_lengths.fits(links)) {
    refuse("columns", points.columns(), "one more than there are rest lengths");
  }
  for (int i = 0; i < links; ++i) check_range("rest length", points.rest_lengths[i], 0.0, max_rest_length);
}

void check_room(std::size_t room, std::size_t needed) {
  if (room >= needed) return;
  refuse("vertices.size", static_cast<double>(room), (std::to_string(needed) + " or more").c_str());
}

bool is_same_place(Vec2 a, Vec2 b) { return !(length(b - a) > same_place); }

/// Returns the unit vector from a to b, or `otherwise` if they are in the same place.
Vec2 direction(Vec2 a, Vec2 b, Vec2 otherwise) {
  const double distance = length(b - a);
  return distance > same_place ? (1.0 / distance) * (b - a) : otherwise;
}

/// Returns the link at one end of `link` as the mirror image, across the middle, of the one at its other end. Neither
/// has length 0.
Vec2 mirrored(Vec2 other, Vec2 link) {
  const Vec2 u = direction({}, link, {});
  return (2.0 * dot(other, u)) * u - other;
}

/// The spline along a link.
class CurvePiece {
 public:
  /// From `start`, along the second of three links. None has length 0.
  CurvePiece(Vec2 start, Vec2 before, Vec2 link, Vec2 after) : start_(start) {
    // Centripetal knot intervals: the square roots of the lengths.
    const double t0 = std::sqrt(length(before));
    const double t1 = std::sqrt(length(link));
    const double t2 = std::sqrt(length(after));
    const Vec2 v0 = (1.0 / t0) * before;
    const Vec2 v1 = (1.0 / t1) * link;
    const Vec2 v2 = (1.0 / t2) * after;
    // The slopes of the parabolas through three points, by knots: means of v that are weighted with the other interval.
    slope_ = (t1 / (t0 + t1)) * (t1 * v0 + t0 * v1);
    const Vec2 end_slope = (t1 / (t1 + t2)) * (t2 * v1 + t1 * v2);
    square_ = 3.0 * link - 2.0 * slope_ - end_slope;
    cube_ = slope_ + end_slope - 2.0 * link;
  }

  /// Returns the position at s, 0 at its start to 1 at its end.
  Vec2 at(double s) const { return start_ + s * (slope_ + s * (square_ + s * cube_)); }

 private:
  Vec2 start_, slope_, square_, cube_;  // m
};

/// One row of points.
class Row {
 public:
  Row(const PointGrid& points, int row) : points_(points), row_(row) {}

  Vec2 at(int i) const { return points_.positions[ribbon::at(i * points_.rows + row_)]; }

  /// Calls write(k, position) for each vertex of its smooth line.
  template <typename Write>
  void trace(int subdivisions, const Write& write) const {
    const int last = points_.columns() - 1;
    std::size_t k = 0;
    for (int i = 0; i < last; ++i) {
      write(k++, at(i));
      if (is_same_place(at(i), at(i + 1))) {
        for (int n = 1; n < subdivisions; ++n) write(k++, at(i));
      } else if (subdivisions > 1) {
        const CurvePiece piece = piece_from(i);
        for (int n = 1; n < subdivisions; ++n) write(k++, piece.at(1.0 * n / subdivisions));
      }
    }
    write(k, at(last));
  }

 private:
  CurvePiece piece_from(int i) const {
    int before = i - 1;
    while (before >= 0 && is_same_place(at(before), at(i))) --before;
    int after = i + 2;
    while (after < points_.columns() && is_same_place(at(after), at(i + 1))) ++after;
    const bool begins = before < 0;
    const bool ends = after == points_.columns();
    const Vec2 link = at(i + 1) - at(i);
    const Vec2 in = begins ? link : at(i) - at(before);
    const Vec2 out = ends ? link : at(after) - at(i + 1);
    return {at(i), begins ? mirrored(out, link) : in, link, ends ? mirrored(in, link) : out};
  }

  const PointGrid& points_;
  int row_;
};

/// Writes the rest length from the first point to each vertex, arc(k), of a line with vertices at middle(k).
template <typename Middle, typename Arc>
void measure_arcs(const PointGrid& points, int subdivisions, const Middle& middle, const Arc& arc) {
  double start = 0.0;
  std::size_t first = 0;
  for (int i = 0; i + 1 < points.columns(); ++i, first += at(subdivisions)) {
    double total = 0.0;
    for (std::size_t k = first; k < first + at(subdivisions); ++k) {
      arc(k) = total;
      total += length(middle(k + 1) - middle(k));
    }
    const double rest = points.rest_lengths[i];
    for (std::size_t k = first; k < first + at(subdivisions); ++k) {
      const double even = static_cast<double>(k - first) / subdivisions;
      arc(k) = start + rest * (total > 0.0 ? arc(k) / total : even);
    }
    start += rest;
  }
  arc(first) = start;
}

/// The normal of a line at one of its vertices.
struct Normal {
  Vec2 unit;     // to the left
  double mitre;  // distance of an edge from the vertex, relative to the radius

  /// Of a vertex between pieces in these directions.
  Normal(Vec2 in, Vec2 out) {
    const Vec2 sum = in + out;
    const double size = length(sum);  // 2·cos(β/2)
    unit = perp(direction({}, sum, perp(in)));
    mitre = size > 2.0 / max_mitre ? 2.0 / size : max_mitre;
  }
};

/// Calls write(k, position, normal) for each vertex of a line. A piece without length has the direction of the one
/// before it. `write` may change the vertex.
template <typename Position, typename Write>
void visit_normals(std::size_t size, const Position& position, const Write& write) {
  std::size_t start = 1;
  while (start + 1 < size && is_same_place(position(start), position(0))) ++start;
  Vec2 in = direction(position(0), position(start), {1.0, 0.0});
  Vec2 here = position(0);
  for (std::size_t k = 0; k < size; ++k) {
    const Vec2 next = k + 1 < size ? position(k + 1) : here;
    const Vec2 out = direction(here, next, in);
    write(k, here, Normal(in, out));
    in = out;
    here = next;
  }
}

/// Moves both edges of a rope away from its line, where they are.
void widen_rope(std::span<StripVertex> strip, double radius) {
  const auto position = [&](std::size_t k) { return strip[2 * k].position; };
  visit_normals(strip.size() / 2, position, [&](std::size_t k, Vec2 middle, const Normal& normal) {
    const Vec2 offset = (radius * normal.mitre) * normal.unit;
    strip[2 * k].position = middle - offset;
    strip[2 * k + 1].position = middle + offset;
  });
}

/// Moves the edges of a ribbon apart. Where they meet, it uses the direction across at the vertex before.
void widen_ribbon(std::span<StripVertex> strip, double radius) {
  Vec2 across{0.0, 1.0};
  for (std::size_t k = 0; k < strip.size(); k += 2) {
    across = direction(strip[k].position, strip[k + 1].position, across);
    strip[k].position -= radius * across;
    strip[k + 1].position += radius * across;
  }
}

}  // namespace

bool RestLengths::fits(int links) const {
  if (const auto* by_link = std::get_if<std::span<const double>>(&lengths_)) return by_link->size() == at(links);
  const auto* cord = std::get_if<const Cord*>(&lengths_);
  return cord == nullptr || (*cord)->def().points == links + 1;
}

double RestLengths::operator[](int link) const {
  if (const auto* each = std::get_if<double>(&lengths_)) return *each;
  if (const auto* by_link = std::get_if<std::span<const double>>(&lengths_)) return (*by_link)[at(link)];
  return std::get<const Cord*>(lengths_)->rest_length(link);
}

PointGrid point_grid(const Cord& cord) { return {cord.positions(), cord.def().rows, RestLengths(cord)}; }

PointGrid point_grid(const ThesisCord& cord) {
  return {cord.positions(), cord.def().h, RestLengths(cord.def().spacing)};
}

std::size_t smooth_line_size(int columns, int subdivisions) {
  check_size(columns, subdivisions);
  return at(columns - 1) * at(subdivisions) + 1;
}

std::size_t smooth_strip_size(int columns, int subdivisions) { return 2 * smooth_line_size(columns, subdivisions); }

std::span<LineVertex> smooth_line(const PointGrid& points, int row, int subdivisions, std::span<LineVertex> vertices) {
  check_grid(points);
  check_range("row", row, 0, points.rows - 1);
  const std::size_t size = smooth_line_size(points.columns(), subdivisions);
  check_room(vertices.size(), size);
  const std::span<LineVertex> line = vertices.first(size);
  const auto position = [&](std::size_t k) { return line[k].position; };
  Row(points, row).trace(subdivisions, [&](std::size_t k, Vec2 x) { line[k].position = x; });
  measure_arcs(points, subdivisions, position, [&](std::size_t k) -> double& { return line[k].arc; });
  visit_normals(size, position, [&](std::size_t k, Vec2 /*x*/, const Normal& normal) { line[k].normal = normal.unit; });
  return line;
}

std::span<StripVertex> smooth_strip(const PointGrid& points, double radius, int subdivisions,
                                    std::span<StripVertex> vertices) {
  check_grid(points);
  check_range("radius", radius, 0.0, max_radius);
  const std::size_t size = smooth_strip_size(points.columns(), subdivisions);
  check_room(vertices.size(), size);
  const std::span<StripVertex> strip = vertices.first(size);
  Row(points, 0).trace(subdivisions, [&](std::size_t k, Vec2 x) { strip[2 * k].position = x; });
  Row(points, points.rows - 1).trace(subdivisions, [&](std::size_t k, Vec2 x) { strip[2 * k + 1].position = x; });
  const auto middle = [&](std::size_t k) { return 0.5 * (strip[2 * k].position + strip[2 * k + 1].position); };
  measure_arcs(points, subdivisions, middle, [&](std::size_t k) -> double& { return strip[2 * k].arc; });
  if (points.rows == 1) {
    widen_rope(strip, radius);
  } else {
    widen_ribbon(strip, radius);
  }
  for (std::size_t k = 0; k < size; k += 2) {
    strip[k].across = 0.0;
    strip[k + 1] = {strip[k + 1].position, strip[k].arc, 1.0};
  }
  return strip;
}

}  // namespace ribbon
