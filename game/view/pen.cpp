#include "game/view/pen.h"

#include <cmath>

namespace game {

using engine::Color;
using engine::Filter;
using engine::Image;
using engine::Wrap;
using ribbon::Vec2;

bool Pen::sees(Vec2 center, double radius) const {
  const Vec2 low = left_bottom();
  const Vec2 high = right_top();
  return center.x > low.x - radius && center.x < high.x + radius && center.y > low.y - radius &&
         center.y < high.y + radius;
}

void Pen::sprite(const Image& image, Vec2 center, Vec2 size, Color color, double angle) {
  const Vec2 right = 0.5 * size.x * Vec2{std::cos(angle), std::sin(angle)};
  const Vec2 down = 0.5 * size.y * Vec2{-std::sin(angle), std::cos(angle)};
  mesh.clear();
  mesh.vertices = {{center - right - down, {0.0, 0.0}, color},
                   {center + right - down, {1.0, 0.0}, color},
                   {center + right + down, {1.0, 1.0}, color},
                   {center - right + down, {0.0, 1.0}, color}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  canvas.textured(mesh, {&image, Filter::linear, Wrap::clamp, Wrap::clamp});
}

void Pen::disc(const Image& image, Vec2 center, double radius, Color color, double angle) {
  const Vec2 middle = canvas.to_pixels(center);
  const double pixels = radius * scale();
  shape.clear();
  mesh.clear();
  engine::add_disc(shape, middle, pixels);
  const Vec2 u = 0.5 / pixels * Vec2{std::cos(angle), -std::sin(angle)};
  const Vec2 v{-u.y, u.x};
  add_shape(mesh, shape, {middle - pixels * pixels * 2.0 * (u + v), u, v}, color);
  canvas.textured(mesh, {&image, Filter::linear, Wrap::clamp, Wrap::clamp});
}

void Pen::fade(Vec2 top_left, Vec2 size, Color top, Color bottom) {
  mesh.clear();
  mesh.vertices = {{top_left, {}, top},
                   {top_left + Vec2{size.x, 0.0}, {}, top},
                   {top_left + size, {}, bottom},
                   {top_left + Vec2{0.0, size.y}, {}, bottom}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  canvas.textured(mesh, {});
}

}  // namespace game
