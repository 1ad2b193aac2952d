#include "game/view/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/convert.h"

namespace game {
namespace {

using engine::Color;
using engine::to_double;
using ribbon::Vec2;

constexpr double beam = 1.45;          // m; thinner ground is of wood
constexpr double image_size = 4.0;     // m of the world on an image of earth
constexpr double grass_high = 0.62;    // m, of the fringe, roots included
constexpr double grass_long = 5.0;     // m, of one image
constexpr double darkest_below = 5.0;  // m

/// Counter-clockwise.
std::vector<Vec2> corners_of(const b2PolygonShape& shape, const Snapshot::Body& pose) {
  std::vector<Vec2> corners;
  for (int k = 0; k < shape.m_count; ++k) corners.push_back(placed(pose, to_double(shape.m_vertices[k])));
  return corners;
}

struct Extent {
  Vec2 along;  // the direction of the longest edge
  double length = 0.0;
  double width = 0.0;
};

Extent extent_of(const std::vector<Vec2>& corners) {
  Extent extent;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 edge = corners[(k + 1) % corners.size()] - corners[k];
    if (length(edge) <= extent.length) continue;
    extent.length = length(edge);
    extent.along = (1.0 / extent.length) * edge;
  }
  for (const Vec2 a : corners)
    for (const Vec2 b : corners) extent.width = std::max(extent.width, dot(perp(extent.along), b - a));
  return extent;
}

void add_polygon(Pen& pen, const std::vector<Vec2>& corners, const engine::UvMap& map, Color color) {
  std::vector<Vec2> pixels;
  for (const Vec2 p : corners) pixels.push_back(pen.canvas.to_pixels(p));
  pen.shape.clear();
  pen.mesh.clear();
  engine::add_convex(pen.shape, pixels);
  add_shape(pen.mesh, pen.shape, map, color);
}

void draw_outline(Pen& pen, const std::vector<Vec2>& corners, double width, Color color) {
  std::vector<Vec2> closed;
  for (std::size_t k = 0; k <= corners.size(); ++k) closed.push_back(corners[k % corners.size()]);
  pen.canvas.polyline(closed, width, color);
}

void draw_beam(Pen& pen, const std::vector<Vec2>& corners, const Extent& extent) {
  const Vec2 along = extent.along.x < -0.1 ? -extent.along : extent.along;
  const Vec2 across = perp(along);
  Vec2 corner = corners.front();  // where the image begins: the first along it, and the upper one across
  for (const Vec2 p : corners) {
    corner += std::min(dot(p - corner, along), 0.0) * along;
    corner += std::max(dot(p - corner, across), 0.0) * across;
  }
  const double scale = pen.scale();
  const Vec2 u = 1.0 / (scale * 4.0 * extent.width) * Vec2{along.x, -along.y};
  const Vec2 v = 1.0 / (scale * extent.width) * Vec2{-across.x, across.y};
  draw_outline(pen, corners, 0.06, pen.colors.ink);
  add_polygon(pen, corners, {pen.canvas.to_pixels(corner), u, v}, pen.colors.wood);
  pen.canvas.textured(pen.mesh, {&pen.images.wood});
}

/// Along the edges that face up, from left to right.
void draw_grass(Pen& pen, const std::vector<Vec2>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 right = corners[k];
    const Vec2 left = corners[(k + 1) % corners.size()];
    const Vec2 way = right - left;
    if (way.x < 0.8 * length(way)) continue;
    // One strip of a size that is never blurred, on whole images of the world's, so that neighbours match.
    engine::StripLook look;
    look.image = &pen.images.grass;
    look.width = grass_high;
    look.image_length = grass_long;
    look.start = left.x;
    look.color = pen.colors.grass;
    pen.canvas.strip(std::array{left, right}, look);
  }
}

void draw_earth(Pen& pen, const std::vector<Vec2>& corners) {
  const double texel = 1.0 / (image_size * pen.scale());
  const Vec2 origin = pen.canvas.to_pixels({0.0, 0.0});
  double top = corners.front().y;
  for (const Vec2 p : corners) top = std::max(top, p.y);
  add_polygon(pen, corners, {origin, {texel, 0.0}, {0.0, texel}}, pen.colors.soil);
  for (engine::TexturedVertex& v : pen.mesh.vertices)
    v.color = mix(pen.colors.soil, pen.colors.soil_deep, (top - pen.canvas.to_world(v.at).y) / darkest_below);
  draw_outline(pen, corners, 0.07, mix(pen.colors.soil_deep, pen.colors.ink, 0.5));
  pen.canvas.textured(pen.mesh, {&pen.images.soil});
  draw_grass(pen, corners);
}

void draw_polygon(Pen& pen, const b2PolygonShape& shape, const Snapshot::Body& pose) {
  const std::vector<Vec2> corners = corners_of(shape, pose);
  Vec2 middle;
  for (const Vec2 p : corners) middle += (1.0 / static_cast<double>(corners.size())) * p;
  double reach = 0.0;
  for (const Vec2 p : corners) reach = std::max(reach, length(p - middle));
  if (!pen.sees(middle, reach + 0.5)) return;
  const Extent extent = extent_of(corners);
  if (extent.width < beam && corners.size() == 4) {
    draw_beam(pen, corners, extent);
  } else {
    draw_earth(pen, corners);
  }
}

/// A peg that a cord winds round: the end of a trunk.
void draw_peg(Pen& pen, Vec2 center, double radius) {
  pen.canvas.circle(center, radius, pen.colors.ink);
  pen.disc(pen.images.wood, center, radius - 0.04, mix(pen.colors.wood, pen.colors.ink, 0.25));
  pen.canvas.circle(center, 0.78 * radius, mix(pen.colors.wood, {255, 255, 255}, 0.35));
  for (const double ring : {0.58, 0.36, 0.14})
    pen.canvas.ring(center, ring * radius, 0.03, mix(pen.colors.wood, pen.colors.ink, 0.2));
}

void draw_ball(Pen& pen, Vec2 center, double radius, double angle, Color color) {
  pen.canvas.circle(center, radius, mix(pen.colors.ink, color, 0.25));
  pen.disc(pen.images.ball, center, radius - 0.025, color, angle);
  pen.disc(pen.images.shade, center, radius - 0.025, {255, 255, 255});
}

}  // namespace

Vec2 placed(const Snapshot::Body& pose, Vec2 local) {
  const double c = std::cos(pose.angle);
  const double s = std::sin(pose.angle);
  return pose.position + Vec2{c * local.x - s * local.y, s * local.x + c * local.y};
}

void draw_body(Pen& pen, const b2Body& body, const Snapshot::Body& pose, int number) {
  for (const b2Fixture* fixture = body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext()) {
    const b2Shape& shape = *fixture->GetShape();
    if (shape.GetType() == b2Shape::e_polygon) {
      draw_polygon(pen, static_cast<const b2PolygonShape&>(shape), pose);
    } else if (shape.GetType() == b2Shape::e_circle) {
      const auto& circle = static_cast<const b2CircleShape&>(shape);
      const Vec2 center = placed(pose, to_double(circle.m_p));
      const double radius = static_cast<double>(circle.m_radius);
      if (!pen.sees(center, radius)) continue;
      if (body.GetType() == b2_staticBody) {
        draw_peg(pen, center, radius);
      } else {
        draw_ball(pen, center, radius, pose.angle,
                  pen.colors.balls[static_cast<std::size_t>(number) % pen.colors.balls.size()]);
      }
    }
  }
}

}  // namespace game
