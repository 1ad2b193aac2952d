#include "game/view/sticky_rim.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr int corners_of_circle = 32;
constexpr double rope_width = 0.13;   // m
constexpr double rope_length = 0.32;  // m, of the rope's image
constexpr double rim_outline = 0.05;  // m, on each side

/// Returns the closed outline of a fixture in the world, m; nothing for a shape without an inside.
std::vector<Vec2> outline_of(const DrawnBody& body, const b2Fixture& fixture) {
  std::vector<Vec2> corners;
  if (fixture.GetType() == b2Shape::e_polygon) {
    const auto& polygon = static_cast<const b2PolygonShape&>(*fixture.GetShape());
    for (int k = 0; k < polygon.m_count; ++k) corners.push_back(placed(body.pose, to_double(polygon.m_vertices[k])));
  } else if (fixture.GetType() == b2Shape::e_circle) {
    const auto& circle = static_cast<const b2CircleShape&>(*fixture.GetShape());
    const Vec2 center = placed(body.pose, to_double(circle.m_p));
    for (int k = 0; k < corners_of_circle; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / corners_of_circle;
      corners.push_back(center + static_cast<double>(circle.m_radius) * Vec2{std::cos(angle), std::sin(angle)});
    }
  }
  if (!corners.empty()) corners.push_back(corners.front());
  return corners;
}

}  // namespace

void draw_sticky_rims(Pen& pen, std::span<const DrawnBody> bodies) {
  for (const DrawnBody& body : bodies) {
    if (!body.is_sticky) continue;
    for (const b2Fixture* fixture = body.body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
      const std::vector<Vec2> rim = outline_of(body, *fixture);
      if (rim.empty()) continue;
      pen.canvas.polyline(rim, rope_width + 2.0 * rim_outline, pen.colors.ink);
      pen.canvas.strip(rim, {&pen.images.cord, rope_width, rope_length, 0.0, pen.colors.hook_in_range});
    }
  }
}

}  // namespace game
