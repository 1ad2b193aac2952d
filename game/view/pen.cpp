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

void Pen::prepare(const Image& image, Vec2 size, Color color) {
  const int width = static_cast<int>(std::lround(size.x));
  const int height = static_cast<int>(std::lround(size.y));
  if (stamps != nullptr && width > 0 && height > 0) stamps->get(image, width, height, color);
}

void Pen::stamp(const Image& image, Vec2 center, Vec2 size, Color color) {
  const int width = static_cast<int>(std::lround(size.x));
  const int height = static_cast<int>(std::lround(size.y));
  if (width < 1 || height < 1) return;
  const Vec2 corner{std::round(center.x - 0.5 * width), std::round(center.y - 0.5 * height)};
  if (corner.x >= canvas.width() || corner.y >= canvas.height() || corner.x + width <= 0.0 || corner.y + height <= 0.0)
    return;
  Stamps own;
  const Stamps::Stamp& made = (stamps != nullptr ? *stamps : own).get(image, width, height, color);
  const double u = 1.0 * width / made.image.width();
  const double v = 1.0 * height / made.image.height();
  mesh.clear();
  add_rectangle(mesh, corner, {1.0 * width, 1.0 * height}, white, white, {u, v});
  canvas.textured(mesh, {&made.image, Filter::nearest, Wrap::clamp, Wrap::clamp});
}

void Pen::disc(const Image& image, Vec2 center, double radius, Color color, double angle) {
  const Vec2 middle = canvas.to_pixels(center);
  const double pixels = radius * scale();
  mesh.clear();
  const Vec2 u = 0.5 / pixels * Vec2{std::cos(angle), -std::sin(angle)};
  const Vec2 v{-u.y, u.x};
  add_disc(mesh, middle, pixels, {middle - pixels * pixels * 2.0 * (u + v), u, v}, color);
  canvas.textured(mesh, {&image, Filter::linear, Wrap::clamp, Wrap::clamp});
}

void Pen::fade(Vec2 top_left, Vec2 size, Color top, Color bottom) {
  mesh.clear();
  add_rectangle(mesh, top_left, size, top, bottom);
  canvas.textured(mesh, {});
}

}  // namespace game
