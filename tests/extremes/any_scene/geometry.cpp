#include "tests/extremes/any_scene/geometry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/slot.h"

namespace any_scene {

using ribbon::Vec2;

namespace {

constexpr double own_neighbourhood = 3.0;  // radii, as in the solver
constexpr double polygon_skin = 0.01;      // m, b2_polygonRadius

using test_support::slot;

double depth_in_box(Vec2 half, Vec2 a, Vec2 b) {
  const auto inside = [&](double s) {
    const Vec2 p = a + s * (b - a);
    const Vec2 q{std::abs(p.x) - half.x, std::abs(p.y) - half.y};
    if (q.x <= 0.0 && q.y <= 0.0) return -std::max(q.x, q.y);
    return -ribbon::length({std::max(q.x, 0.0), std::max(q.y, 0.0)});
  };
  double low = 0.0;  // the depth is a concave function along the segment: ternary search
  double high = 1.0;
  for (int k = 0; k < 40; ++k) {
    const double third = (high - low) / 3.0;
    if (inside(low + third) < inside(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  return inside(0.5 * (low + high));
}

}  // namespace

double distance(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 ab = b - a;
  const double size2 = dot(ab, ab);
  const double s = size2 > 0.0 ? std::clamp(dot(p - a, ab) / size2, 0.0, 1.0) : 0.0;
  return length(p - a - s * ab);
}

double distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (crosses(a, b, c, d)) return 0.0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// Where points are collinear, as in a straight rope that falls, the sides are rounding errors. The boxes tell then.
bool crosses(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const bool apart = std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
                     std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
  if (apart) return false;
  const double side_c = cross(b - a, c - a);
  const double side_d = cross(b - a, d - a);
  const double side_a = cross(d - c, a - c);
  const double side_b = cross(d - c, b - c);
  return ((side_c > 0.0 && side_d < 0.0) || (side_c < 0.0 && side_d > 0.0)) &&
         ((side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0));
}

/// The point is on the link's line where cross(e + t·δe, q + t·δq) = 0, e = b − a, q = p − a: a quadratic in t.
std::optional<double> passes(Swept p, Swept a, Swept b) {
  const Vec2 e = b.before - a.before;
  const Vec2 q = p.before - a.before;
  const Vec2 de = b.after - a.after - e;
  const Vec2 dq = p.after - a.after - q;
  const double c0 = cross(e, q);
  const double c1 = cross(e, dq) + cross(de, q);
  const double c2 = cross(de, dq);
  std::array<double, 2> roots = {-1.0, -1.0};
  const double square = c1 * c1 - 4.0 * c2 * c0;
  if (square < 0.0) return std::nullopt;
  const double half = -0.5 * (c1 + (c1 < 0.0 ? -1.0 : 1.0) * std::sqrt(square));
  if (c2 != 0.0) roots[0] = half / c2;
  if (half != 0.0) roots[1] = c0 / half;
  int count = 0;
  double where = 0.0;
  for (const double t : roots) {
    if (!(t > 0.0 && t <= 1.0)) continue;
    const Vec2 along = e + t * de;
    const double s = dot(q + t * dq, along) / dot(along, along);
    if (!(s >= 0.0 && s <= 1.0)) continue;
    ++count;
    where = s;
  }
  return count == 1 ? std::optional(where) : std::nullopt;
}

Vec2 Pose::to_world(Vec2 local) const {
  return position + Vec2{cos * local.x - sin * local.y, sin * local.x + cos * local.y};
}

Vec2 Pose::to_local(Vec2 world) const {
  const Vec2 d = world - position;
  return {cos * d.x + sin * d.y, cos * d.y - sin * d.x};
}

Pose pose_of(const Solid& solid) { return {solid.position, std::cos(solid.angle), std::sin(solid.angle)}; }

double skin(const Solid& solid) { return solid.shape == Shape::circle ? 0.0 : polygon_skin; }

double depth(const Solid& solid, const Pose& pose, Vec2 a, Vec2 b) {
  const Vec2 local_a = pose.to_local(a);
  const Vec2 local_b = pose.to_local(b);
  switch (solid.shape) {
    case Shape::circle: return solid.half.x - distance({}, local_a, local_b);
    case Shape::edge: return -distance({-solid.half.x, 0.0}, {solid.half.x, 0.0}, local_a, local_b);
    default: return depth_in_box(solid.half, local_a, local_b);
  }
}

void Outline::lay_on_wheel(int before, int after) {
  on_wheel.resize(slot(links()));
  std::fill(on_wheel.begin() + before, on_wheel.begin() + after, char{1});
}

bool Outline::is_at_wheel(int point) const {
  return (point > 0 && is_on_wheel(point - 1)) || (point < links() && is_on_wheel(point));
}

Outline outline(const ribbon::CordDef& def, std::span<const Vec2> positions) {
  Outline around{{}, def.rows > 1};
  if (def.rows == 1) {
    around.points.assign(positions.begin(), positions.end());
    return around;
  }
  const auto add = [&](int i, int j) { around.points.push_back(positions[slot(i * def.rows + j)]); };
  for (int i = 0; i < def.points; ++i) add(i, 0);
  for (int j = 1; j + 1 < def.rows; ++j) add(def.points - 1, j);
  for (int i = def.points; i-- > 0;) add(i, def.rows - 1);
  for (int j = def.rows - 1; j-- > 1;) add(0, j);
  return around;
}

Outline outline_at_rest(const ribbon::CordDef& def) {
  std::vector<Vec2> positions;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      positions.push_back({def.length * i / (def.points - 1), def.rows > 1 ? def.width * j / (def.rows - 1) : 0.0});
    }
  }
  return outline(def, positions);
}

namespace {

std::vector<char> near_links(const Outline& a, const Outline& b, Vec2 shift, double radius) {
  std::vector<char> near;
  for (int i = 0; i < a.links(); ++i) {
    for (int j = 0; j < b.links(); ++j) {
      const double apart = distance(a.start(i), a.end(i), b.start(j) + shift, b.end(j) + shift);
      // Links that share a point have distance 0.
      near.push_back(apart <= 1e-9 || apart < own_neighbourhood * radius * (1.0 + 1e-9) ? 1 : 0);
    }
  }
  return near;
}

}  // namespace

std::vector<char> neighbours(const ribbon::CordDef& def) {
  const Outline rest = outline_at_rest(def);
  return near_links(rest, rest, {}, def.radius);
}

std::vector<char> neighbours(const ribbon::CordDef& before, const ribbon::CordDef& after) {
  return near_links(outline_at_rest(before), outline_at_rest(after), {before.length, 0.0}, before.radius);
}

}  // namespace any_scene
