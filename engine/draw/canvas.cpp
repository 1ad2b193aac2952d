#include "engine/draw/canvas.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace engine {

using ribbon::Vec2;

void Canvas::set_view(View view) {
  if (!is_finite(view.center)) throw std::invalid_argument("set_view: the center of the view must be finite");
  if (!std::isfinite(view.pixels_per_metre) || view.pixels_per_metre <= 0.0)
    throw std::invalid_argument("set_view: pixels_per_metre must be finite and positive");
  view_ = view;
}

Vec2 Canvas::to_pixels(Vec2 world) const {
  const Vec2 from_center = view_.pixels_per_metre * (world - view_.center);
  return {width() / 2.0 + from_center.x, height() / 2.0 - from_center.y};
}

Vec2 Canvas::to_world(Vec2 pixels) const {
  return view_.center + (1.0 / view_.pixels_per_metre) * Vec2{pixels.x - width() / 2.0, height() / 2.0 - pixels.y};
}

std::span<const Vec2> Canvas::pixels_of(std::span<const Vec2> world) {
  pixels_.clear();
  for (const Vec2 p : world) pixels_.push_back(to_pixels(p));
  return pixels_;
}

template <typename AddShape>
void Canvas::paint(Color color, AddShape add_shape) {
  mesh_.clear();
  add_shape(mesh_);
  if (!mesh_.is_empty() && color.a > 0) paint_mesh(mesh_, color);
}

void Canvas::polygon(std::span<const Vec2> corners, Color color) {
  paint(color, [&](Mesh& mesh) { add_convex(mesh, pixels_of(corners)); });
}

void Canvas::circle(Vec2 center, double radius, Color color) {
  paint(color, [&](Mesh& mesh) { add_disc(mesh, to_pixels(center), radius * view_.pixels_per_metre); });
}

void Canvas::ring(Vec2 center, double radius, double width, Color color) {
  const double scale = view_.pixels_per_metre;
  paint(color, [&](Mesh& mesh) { add_ring(mesh, to_pixels(center), radius * scale, width * scale); });
}

void Canvas::polyline(std::span<const Vec2> points, double width, Color color) {
  paint(color, [&](Mesh& mesh) { add_polyline(mesh, pixels_of(points), width * view_.pixels_per_metre); });
}

void Canvas::triangles(std::span<const Vec2> vertices, std::span<const int> indices, Color color) {
  paint(color, [&](Mesh& mesh) { add_triangles(mesh, pixels_of(vertices), indices); });
}

void Canvas::strip(std::span<const Vec2> points, const StripLook& look) {
  const double scale = view_.pixels_per_metre;
  if (!std::isfinite(look.image_length) || look.image_length <= 0.0 || look.color.a == 0) return;
  textured_.clear();
  add_band(
      textured_, pixels_of(points),
      {look.width * scale, 1.0 / (look.image_length * scale), look.start / look.image_length, look.color, look.colors});
  textured(textured_, {look.image, Filter::linear, Wrap::repeat, Wrap::clamp});
}

void Canvas::textured(const TexturedMesh& mesh, const Texture& texture, const PixelBox& clip) {
  if (!mesh.indices.empty() && is_paintable(mesh)) paint_textured(mesh, texture, clip);
}

void Canvas::skyline(std::span<const Vec2> line, const SkylineLook& look) {
  const auto is_good = [](Vec2 p) { return is_finite(p) && std::abs(p.x) <= 1e12 && std::abs(p.y) <= 1e12; };
  const bool is_ordered = std::is_sorted(line.begin(), line.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  const bool has_gradient = std::isfinite(look.top) && std::isfinite(look.bottom) && look.bottom > look.top;
  if (line.size() < 2 || !has_gradient || std::isnan(look.end)) return;
  if (is_ordered && std::all_of(line.begin(), line.end(), is_good)) paint_skyline(line, look);
}

void Canvas::mesh(const Mesh& mesh, Color color) {
  if (!mesh.is_empty() && color.a > 0 && is_paintable(mesh)) paint_mesh(mesh, color);
}

void Canvas::panel(Vec2 top_left, Vec2 size, double corner_radius, Color color) {
  paint(color, [&](Mesh& mesh) { add_rounded_rectangle(mesh, top_left, size, corner_radius); });
}

void Canvas::text(Vec2 at, std::string_view utf8, double size, Color color, Align align) {
  if (utf8.empty() || !is_finite(at) || !std::isfinite(size) || size <= 0.0 || color.a == 0) return;
  if (align == Align::center) at.x -= text_width(utf8, size) / 2.0;
  if (align == Align::right) at.x -= text_width(utf8, size);
  paint_text(at, utf8, size, color);
}

}  // namespace engine
