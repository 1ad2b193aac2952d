#include "tests/support/contact_figures.h"

#include <algorithm>
#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/elastic/cell.h"
#include "ribbon/geometry/separation.h"
#include "tests/support/slot.h"

namespace test_support {
namespace {

using ribbon::find_separation;
using ribbon::Vec2;
using ribbon::box2d::to_double;

struct Bounds {
  Vec2 low, high;
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  void grow(double by) {
    low -= {by, by};
    high += {by, by};
  }
  bool meets(const Bounds& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y;
  }
};

Bounds bounds_of(std::span<const Vec2> line) {
  Bounds bounds{line[0], line[0]};
  for (const Vec2 p : line) bounds.add(p);
  return bounds;
}

std::size_t links_of(std::span<const Vec2> line, bool closed) { return closed ? line.size() : line.size() - 1; }

/// 1, 0 or −1: left, on or right of the line through a and b.
int side(Vec2 a, Vec2 b, Vec2 p) {
  const double twice_area = cross(b - a, p - a);
  return twice_area > 0.0 ? 1 : twice_area < 0.0 ? -1 : 0;
}

/// Returns how far the nearer one of a and b is beyond `edge` along n; negative if it is not beyond.
double beyond(Vec2 n, Vec2 edge, Vec2 a, Vec2 b) { return std::min(dot(n, a - edge), dot(n, b - edge)); }

double depth_in_circle(const b2CircleShape& circle, const b2Body& body, Vec2 a, Vec2 b) {
  const Vec2 center = to_double(body.GetWorldPoint(circle.m_p));
  return static_cast<double>(circle.m_radius) - find_separation(center, a, b).distance;
}

double depth_in_edge(const b2EdgeShape& edge, const b2Body& body, Vec2 a, Vec2 b) {
  const Vec2 c = to_double(body.GetWorldPoint(edge.m_vertex1));
  const Vec2 d = to_double(body.GetWorldPoint(edge.m_vertex2));
  const double ends = std::min(find_separation(a, c, d).distance, find_separation(b, c, d).distance);
  if (is_crossing(a, b, c, d)) return ends;
  return -std::min({ends, find_separation(c, a, b).distance, find_separation(d, a, b).distance});
}

/// Two convex shapes overlap by the least displacement along a normal of either that separates them (separating axes).
double depth_in_polygon(const b2PolygonShape& polygon, const b2Body& body, Vec2 a, Vec2 b) {
  const Vec2 across = length(b - a) > 0.0 ? (1.0 / length(b - a)) * perp(b - a) : Vec2{0.0, 1.0};
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  double apart = most;
  double distance = least;
  for (int k = 0; k < polygon.m_count; ++k) {
    const Vec2 c = to_double(body.GetWorldPoint(polygon.m_vertices[k]));
    const Vec2 d = to_double(body.GetWorldPoint(polygon.m_vertices[(k + 1) % polygon.m_count]));
    apart = std::max(apart, beyond(to_double(body.GetWorldVector(polygon.m_normals[k])), c, a, b));
    least = std::min(least, dot(across, c - a));
    most = std::max(most, dot(across, c - a));
    distance = std::min({distance, find_separation(a, c, d).distance, find_separation(b, c, d).distance,
                         find_separation(c, a, b).distance});
  }
  apart = std::max({apart, least, -most});
  return apart < 0.0 ? -apart : -distance;
}

Bounds bounds_of(const b2Fixture& fixture) {
  b2AABB box;
  fixture.GetShape()->ComputeAABB(&box, fixture.GetBody()->GetTransform(), 0);
  return {to_double(box.lowerBound), to_double(box.upperBound)};
}

}  // namespace

bool is_crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

int self_crossings(std::span<const Vec2> line, bool closed) {
  const std::size_t n = line.size();
  const std::size_t links = links_of(line, closed);
  int count = 0;
  for (std::size_t i = 0; i < links; ++i) {
    for (std::size_t j = i + 2; j < links; ++j) {
      if ((j + 1) % n == i) continue;  // the neighbour across the seam
      count += is_crossing(line[i], line[i + 1], line[j], line[(j + 1) % n]) ? 1 : 0;
    }
  }
  return count;
}

int mutual_crossings(std::span<const Vec2> a, bool a_closed, std::span<const Vec2> b, bool b_closed) {
  const Bounds around_b = bounds_of(b);
  if (!bounds_of(a).meets(around_b)) return 0;
  int count = 0;
  for (std::size_t i = 0; i < links_of(a, a_closed); ++i) {
    const Vec2 p = a[i];
    const Vec2 q = a[(i + 1) % a.size()];
    Bounds link{p, p};
    link.add(q);
    if (!link.meets(around_b)) continue;
    for (std::size_t j = 0; j < links_of(b, b_closed); ++j) {
      count += is_crossing(p, q, b[j], b[(j + 1) % b.size()]) ? 1 : 0;
    }
  }
  return count;
}

std::vector<Vec2> outline_of(std::span<const Vec2> points, int rows) {
  if (rows == 1) return {points.begin(), points.end()};
  const int columns = static_cast<int>(points.size()) / rows;
  std::vector<Vec2> around;
  for (int i = 0; i < columns; ++i) around.push_back(points[slot(i * rows)]);
  for (int j = 1; j + 1 < rows; ++j) around.push_back(points[slot((columns - 1) * rows + j)]);
  for (int i = columns; i-- > 0;) around.push_back(points[slot(i * rows + rows - 1)]);
  for (int j = rows - 1; j-- > 1;) around.push_back(points[slot(j)]);
  return around;
}

int self_crossings(const CoupledWorld& world) {
  int count = 0;
  for (int c = 0; c < world.cords(); ++c) count += self_crossings(world.outline(c), world.is_closed(c));
  return count;
}

int mutual_crossings(const CoupledWorld& world) {
  std::vector<std::vector<Vec2>> lines;
  for (int c = 0; c < world.cords(); ++c) lines.push_back(world.outline(c));
  int count = 0;
  for (int a = 0; a < world.cords(); ++a) {
    for (int b = a + 1; b < world.cords(); ++b) {
      count += mutual_crossings(lines[slot(a)], world.is_closed(a), lines[slot(b)], world.is_closed(b));
    }
  }
  return count;
}

int inverted_cells(const CoupledWorld& world) {
  int count = 0;
  for (int c = 0; c < world.cords(); ++c) {
    const int rows = world.def(c).rows;
    const std::vector<Vec2> x = world.points(c);
    for (int i = 0; i + 1 < world.def(c).points; ++i) {
      for (int j = 0; j + 1 < rows; ++j) {
        const ribbon::Corners corners{x[slot(i * rows + j)], x[slot(i * rows + j + 1)], x[slot((i + 1) * rows + j)],
                                      x[slot((i + 1) * rows + j + 1)]};
        const auto areas = doubled_corner_areas(corners);
        count += std::any_of(areas.begin(), areas.end(), [](double area) { return area <= 0.0; }) ? 1 : 0;
      }
    }
  }
  return count;
}

bool meets(const b2Fixture& fixture, const b2Filter& filter) {
  if (fixture.IsSensor() || !fixture.GetBody()->IsEnabled()) return false;
  const b2Filter& other = fixture.GetFilterData();
  if (filter.groupIndex == other.groupIndex && filter.groupIndex != 0) return filter.groupIndex > 0;
  return (filter.maskBits & other.categoryBits) != 0 && (filter.categoryBits & other.maskBits) != 0;
}

double depth(const b2Fixture& fixture, Vec2 a, Vec2 b) {
  const b2Body& body = *fixture.GetBody();
  switch (fixture.GetType()) {
    case b2Shape::e_circle: return depth_in_circle(static_cast<const b2CircleShape&>(*fixture.GetShape()), body, a, b);
    case b2Shape::e_edge: return depth_in_edge(static_cast<const b2EdgeShape&>(*fixture.GetShape()), body, a, b);
    case b2Shape::e_polygon:
      return depth_in_polygon(static_cast<const b2PolygonShape&>(*fixture.GetShape()), body, a, b);
    default: return -std::numeric_limits<double>::infinity();
  }
}

double penetration(const b2World& world, const Outline& outline, const b2Filter& filter) {
  Bounds near = bounds_of(outline.points);
  near.grow(outline.radius);
  double deepest = 0.0;
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (!meets(*fixture, filter) || !near.meets(bounds_of(*fixture))) continue;
      for (std::size_t k = 0; k < links_of(outline.points, outline.closed); ++k) {
        const Vec2 next = outline.points[(k + 1) % outline.points.size()];
        deepest = std::max(deepest, outline.radius + depth(*fixture, outline.points[k], next));
      }
    }
  }
  return deepest;
}

double penetration(const CoupledWorld& world) {
  b2Filter met;
  met.maskBits = static_cast<uint16>(~CoupledWorld::box_category);
  if (world.method().thesis) met.maskBits &= static_cast<uint16>(~CoupledWorld::edge_category);
  double deepest = 0.0;
  for (int c = 0; c < world.cords(); ++c) {
    const Outline outline{world.outline(c), world.is_closed(c), world.radius(c)};
    deepest = std::max(deepest, penetration(world.world, outline, met));
  }
  return deepest;
}

double stretch(const CoupledWorld& world, int cord) {
  const std::vector<Vec2> points = world.points(cord);
  double along = 0.0;
  for (std::size_t p = 1; p < points.size(); ++p) along += length(points[p] - points[p - 1]);
  return along / world.def(cord).length - 1.0;
}

}  // namespace test_support
