#include "game/view/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "game/view/marks.h"
#include "game/view/palette.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;
using ribbon::box2d::to_double;

constexpr double beam = 1.45;          // m; ground thinner than this is a wooden beam
constexpr double image_size = 4.0;     // m, the size of the image of earth
constexpr double grass_high = 0.62;    // m, including the roots
constexpr double grass_long = 5.0;     // m, the length of the image
constexpr double darkest_depth = 5.0;  // m

/// Returns the corners in the world, counter-clockwise.
std::vector<Vec2> corners_of(const b2PolygonShape& shape, const Snapshot::Body& pose) {
  std::vector<Vec2> corners;
  corners.reserve(static_cast<std::size_t>(shape.m_count));
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
  pixels.reserve(corners.size());
  for (const Vec2 p : corners) pixels.push_back(pen.canvas.to_pixels(p));
  pen.shape.clear();
  pen.mesh.clear();
  engine::add_convex(pen.shape, pixels);
  add_shape(pen.mesh, pen.shape, map, color);
}

void draw_outline(Pen& pen, const std::vector<Vec2>& corners, double width, Color color) {
  std::vector<Vec2> closed;
  closed.reserve(corners.size() + 1);
  for (std::size_t k = 0; k <= corners.size(); ++k) closed.push_back(corners[k % corners.size()]);
  pen.canvas.polyline(closed, width, color);
}

void draw_beam(Pen& pen, const std::vector<Vec2>& corners, const Extent& extent) {
  const Vec2 along = extent.along.x < -0.1 ? -extent.along : extent.along;
  const Vec2 across = perp(along);
  Vec2 corner = corners.front();  // the origin of the image: minimum along the beam, maximum across it
  for (const Vec2 p : corners) {
    corner += std::min(dot(p - corner, along), 0.0) * along;
    corner += std::max(dot(p - corner, across), 0.0) * across;
  }
  const double scale = pen.scale();
  const Vec2 u = 1.0 / (scale * 4.0 * extent.width) * Vec2{along.x, -along.y};
  const Vec2 v = 1.0 / (scale * extent.width) * Vec2{-across.x, across.y};
  add_polygon(pen, corners, {pen.canvas.to_pixels(corner), u, v}, pen.colors.wood);
  pen.canvas.textured(pen.mesh, {&pen.images.wood});
}

/// Draws grass along the edges that face up, from left to right.
void draw_grass(Pen& pen, const std::vector<Vec2>& corners) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 right = corners[k];
    const Vec2 left = corners[(k + 1) % corners.size()];
    const Vec2 edge = right - left;
    if (edge.x < 0.8 * length(edge)) continue;
    // The position in the image is that in the world, so that neighbours match.
    engine::StripLook look;
    look.image = &pen.images.grass;
    look.width = grass_high;
    look.image_length = grass_long;
    look.start = left.x;
    look.color = pen.colors.grass;
    const Vec2 lifted{0.0, 0.05};  // above the outline
    pen.canvas.strip(std::array{left + lifted, right + lifted}, look);
  }
}

double top_of(const std::vector<Vec2>& corners) {
  double top = corners.front().y;
  for (const Vec2 p : corners) top = std::max(top, p.y);
  return top;
}

void draw_earth(Pen& pen, const std::vector<Vec2>& corners) {
  const double texel = 1.0 / (image_size * pen.scale());
  const Vec2 origin = pen.canvas.to_pixels({0.0, 0.0});
  const double top = top_of(corners);
  add_polygon(pen, corners, {origin, {texel, 0.0}, {0.0, texel}}, {255, 255, 255});
  // The earth gets darker with depth, down to darkest_depth.
  const auto deep = static_cast<std::uint8_t>(pen.colors.deep_light);
  for (engine::TexturedVertex& v : pen.mesh.vertices)
    v.color = mix(white, {deep, deep, deep}, (top - pen.canvas.to_world(v.at).y) / darkest_depth);
  pen.canvas.textured(pen.mesh, {&pen.images.soil, engine::Filter::nearest});
}

bool is_beam(const std::vector<Vec2>& corners) { return corners.size() == 4 && extent_of(corners).width < beam; }

bool is_seen(const Pen& pen, const std::vector<Vec2>& corners) {
  Vec2 middle;
  for (const Vec2 p : corners) middle += (1.0 / static_cast<double>(corners.size())) * p;
  double radius = 0.0;
  for (const Vec2 p : corners) radius = std::max(radius, length(p - middle));
  return pen.sees(middle, radius + 0.5);
}

/// Draws a shank from a weight to its cord, with a ring. The weight is drawn over it.
void draw_eye(Pen& pen, Vec2 at, Vec2 body) {
  const std::array shank = {at, body};
  pen.canvas.polyline(shank, 0.16, pen.colors.ink);
  pen.canvas.polyline(shank, 0.09, pen.colors.iron);
  pen.canvas.ring(at, 0.11, 0.11, pen.colors.ink);
  pen.canvas.ring(at, 0.11, 0.05, pen.colors.iron);
}

/// Draws a polygonal weight.
void draw_block(Pen& pen, const DrawnBody& drawn, const std::vector<Vec2>& corners) {
  const Extent extent = extent_of(corners);
  draw_outline(pen, corners, 0.08, pen.colors.ink);
  const Vec2 middle = pen.canvas.to_pixels(drawn.pose.position);
  const Vec2 u = 0.5 / (0.75 * extent.length * pen.scale()) * Vec2{extent.along.x, -extent.along.y};
  const Vec2 v{-u.y, u.x};
  const double half = 0.5 / dot(u, u);
  add_polygon(pen, corners, {middle - half * (u + v), u, v}, mix(pen.colors.iron, {255, 255, 255}, 0.12));
  pen.canvas.textured(pen.mesh, {&pen.images.iron});
  draw_mass(pen, drawn.pose.position, 0.5 * std::min(extent.width, extent.length),
            static_cast<double>(drawn.body.GetMass()));
}

/// Draws a static circle as the end of a trunk.
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

void draw_circle(Pen& pen, const DrawnBody& drawn, const b2CircleShape& shape) {
  const Vec2 center = placed(drawn.pose, to_double(shape.m_p));
  const double radius = static_cast<double>(shape.m_radius);
  if (!pen.sees(center, radius) && !(pen.prepares && drawn.is_load)) return;
  if (drawn.is_load)
    return draw_weight(pen, center, radius, drawn.pose.angle, static_cast<double>(drawn.body.GetMass()));
  if (drawn.body.GetType() == b2_staticBody) return draw_peg(pen, center, radius);
  const auto kind = static_cast<std::size_t>(drawn.number) % pen.colors.balls.size();
  draw_ball(pen, center, radius, drawn.pose.angle, pen.colors.balls[kind]);
}

/// Calls use(drawn, shape) for each shape of this type.
template <typename Shape, typename Use>
void each_shape(std::span<const DrawnBody> bodies, b2Shape::Type type, Use use) {
  for (const DrawnBody& drawn : bodies)
    for (const b2Fixture* fixture = drawn.body.GetFixtureList(); fixture != nullptr; fixture = fixture->GetNext())
      if (fixture->GetType() == type) use(drawn, static_cast<const Shape&>(*fixture->GetShape()));
}

}  // namespace

Vec2 placed(const Snapshot::Body& pose, Vec2 local) {
  const double c = std::cos(pose.angle);
  const double s = std::sin(pose.angle);
  return pose.position + Vec2{c * local.x - s * local.y, s * local.x + c * local.y};
}

void draw_bodies(Pen& pen, std::span<const DrawnBody> bodies) {
  std::vector<std::vector<Vec2>> grounds;
  std::vector<std::pair<const DrawnBody*, std::vector<Vec2>>> weights;
  each_shape<b2PolygonShape>(bodies, b2Shape::e_polygon, [&](const DrawnBody& drawn, const b2PolygonShape& shape) {
    std::vector<Vec2> corners = corners_of(shape, drawn.pose);
    if (!is_seen(pen, corners) && !(pen.prepares && drawn.is_load)) return;
    if (drawn.is_load) {
      weights.emplace_back(&drawn, std::move(corners));
    } else {
      grounds.push_back(std::move(corners));
    }
  });
  std::stable_sort(grounds.begin(), grounds.end(), [](const auto& a, const auto& b) { return top_of(a) > top_of(b); });
  // All outlines first, so that adjacent pieces merge; grass last, since it overlaps its neighbours.
  for (const auto& corners : grounds) draw_outline(pen, corners, 0.09, pen.colors.ink);
  for (const auto& corners : grounds)
    if (!is_beam(corners)) draw_earth(pen, corners);
  for (const auto& corners : grounds)
    if (is_beam(corners)) draw_beam(pen, corners, extent_of(corners));
  for (const auto& corners : grounds)
    if (!is_beam(corners)) draw_grass(pen, corners);
  for (const DrawnBody& drawn : bodies)
    if (drawn.is_load && drawn.eye && !(*drawn.eye == drawn.pose.position))
      draw_eye(pen, *drawn.eye, drawn.pose.position);
  for (const auto& [drawn, corners] : weights) draw_block(pen, *drawn, corners);
  each_shape<b2CircleShape>(bodies, b2Shape::e_circle, [&](const DrawnBody& drawn, const b2CircleShape& shape) {
    draw_circle(pen, drawn, shape);
  });
}

}  // namespace game
