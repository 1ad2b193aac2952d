#include "tests/support/contact_figures.h"

#include <algorithm>

#include "engine/convert.h"
#include "ribbon/cell.h"
#include "ribbon/gap.h"

namespace test_support {
namespace {

using engine::to_double;
using ribbon::gap_between;
using ribbon::Vec2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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

/// m, how much nearer the segment a b is to the fixture than `radius` allows.
double depth(const b2Fixture& fixture, Vec2 a, Vec2 b, double radius) {
  const b2Body& body = *fixture.GetBody();
  if (fixture.GetType() == b2Shape::e_circle) {
    const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
    const Vec2 center = to_double(body.GetWorldPoint(circle.m_p));
    return radius + static_cast<double>(circle.m_radius) - gap_between(center, a, b).distance;
  }
  if (fixture.GetType() != b2Shape::e_edge) return 0.0;
  const auto& edge = static_cast<const b2EdgeShape&>(*fixture.GetShape());
  const Vec2 c = to_double(body.GetWorldPoint(edge.m_vertex1));
  const Vec2 d = to_double(body.GetWorldPoint(edge.m_vertex2));
  const double ends = std::min(gap_between(a, c, d).distance, gap_between(b, c, d).distance);
  if (is_crossing(a, b, c, d)) return radius + ends;
  return radius - std::min({ends, gap_between(c, a, b).distance, gap_between(d, a, b).distance});
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
      count += mutual_crossings(lines[at(a)], world.is_closed(a), lines[at(b)], world.is_closed(b));
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
        const ribbon::Corners corners{x[at(i * rows + j)], x[at(i * rows + j + 1)], x[at((i + 1) * rows + j)],
                                      x[at((i + 1) * rows + j + 1)]};
        const auto areas = doubled_corner_areas(corners);
        count += std::any_of(areas.begin(), areas.end(), [](double area) { return area <= 0.0; }) ? 1 : 0;
      }
    }
  }
  return count;
}

double penetration(const CoupledWorld& world) {
  struct Obstacle {
    const b2Fixture* fixture;
    Bounds bounds;
  };
  std::vector<Obstacle> obstacles;
  for (const b2Body* body = world.world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    for (const b2Fixture* fixture = body->GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      if (fixture->GetType() == b2Shape::e_polygon) continue;  // a chain's boxes
      if (world.method().thesis && fixture->GetType() != b2Shape::e_circle) continue;
      b2AABB box;
      fixture->GetShape()->ComputeAABB(&box, body->GetTransform(), 0);
      obstacles.push_back({fixture, {to_double(box.lowerBound), to_double(box.upperBound)}});
    }
  }
  double deepest = 0.0;
  for (int c = 0; c < world.cords(); ++c) {
    const std::vector<Vec2> line = world.outline(c);
    const double radius = world.radius(c);
    Bounds near = bounds_of(line);
    near.grow(radius);
    for (const Obstacle& obstacle : obstacles) {
      if (!near.meets(obstacle.bounds)) continue;
      for (std::size_t k = 0; k < links_of(line, world.is_closed(c)); ++k) {
        deepest = std::max(deepest, depth(*obstacle.fixture, line[k], line[(k + 1) % line.size()], radius));
      }
    }
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
