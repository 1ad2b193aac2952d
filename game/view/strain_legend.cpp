#include "game/view/strain_legend.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "game/view/cords.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr std::array<std::pair<double, std::string_view>, 5> marks = {
    {{0.0, "0"}, {0.001, "0.1 %"}, {0.01, "1 %"}, {0.04, "4 %"}, {max_strain, "10 %"}}};

}  // namespace

void draw_strain_legend(engine::Canvas& canvas, double text_scale) {
  const double size = 14.0 * text_scale;
  const Vec2 box{96.0 * text_scale, 210.0 * text_scale};
  const Vec2 corner{canvas.width() - box.x - 14.0 * text_scale, 0.5 * (canvas.height() - box.y)};
  canvas.panel(corner, box, 0.5 * size, {20, 24, 34, 170});
  canvas.text(corner + Vec2{0.5 * box.x, 0.4 * size}, "stretched by", size, {255, 255, 255}, engine::Align::center);
  const Vec2 bar = corner + Vec2{14.0 * text_scale, 2.2 * size};
  const double high = box.y - 3.2 * size;
  constexpr int steps = 32;
  engine::TexturedMesh mesh;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;  // from the top
    const Color color = strain_color(max_strain * (1.0 - t) * (1.0 - t));
    mesh.vertices.push_back({bar + Vec2{0.0, t * high}, {}, color});
    mesh.vertices.push_back({bar + Vec2{16.0 * text_scale, t * high}, {}, color});
    if (k > 0) mesh.indices.insert(mesh.indices.end(), {2 * k - 2, 2 * k - 1, 2 * k + 1, 2 * k - 2, 2 * k + 1, 2 * k});
  }
  canvas.textured(mesh, {});
  for (const auto& [strain, words] : marks) {
    const double y = (1.0 - std::sqrt(strain / max_strain)) * high;
    canvas.text(bar + Vec2{24.0 * text_scale, y - 0.6 * size}, words, size, {230, 236, 242});
  }
}

}  // namespace game
