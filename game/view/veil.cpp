#include "game/view/veil.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace game {
namespace {

using ribbon::Vec2;

constexpr engine::Color dark{14, 12, 20};

}  // namespace

void draw_darkness(engine::Canvas& canvas, double darkness) {
  const double opacity = 255.0 * std::clamp(darkness, 0.0, 1.0);
  if (opacity < 0.5) return;
  engine::Color color = dark;
  color.a = static_cast<std::uint8_t>(std::lround(opacity));
  const Vec2 size{1.0 * canvas.width(), 1.0 * canvas.height()};
  engine::TexturedMesh mesh;
  add_rectangle(mesh, {0.0, 0.0}, size, color, color);
  canvas.textured(mesh, {});
}

void draw_iris(engine::Canvas& canvas, Vec2 center, double open) {
  if (open >= 1.0) return;
  const Vec2 size{1.0 * canvas.width(), 1.0 * canvas.height()};
  const Vec2 inside{std::clamp(center.x, 0.0, size.x), std::clamp(center.y, 0.0, size.y)};
  const double whole = length(Vec2{std::max(inside.x, size.x - inside.x), std::max(inside.y, size.y - inside.y)});
  const double radius = std::max(open, 0.0) * whole;
  constexpr int corners = 96;
  engine::Mesh mesh;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    const Vec2 out{std::cos(angle), std::sin(angle)};
    mesh.vertices.push_back({inside + std::max(radius - 0.5, 0.0) * out, 0.0});
    mesh.vertices.push_back({inside + (radius + 0.5) * out, 1.0});
    mesh.vertices.push_back({inside + 1.01 * (whole + 2.0) * out, 1.0});
    if (k == 0) continue;
    const int v = 3 * k - 3;
    for (const int ring : {0, 1})
      mesh.indices.insert(mesh.indices.end(),
                          {v + ring, v + ring + 1, v + ring + 4, v + ring, v + ring + 4, v + ring + 3});
  }
  canvas.mesh(mesh, dark);
}

}  // namespace game
