#include "game/view/strain_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "game/view/cords.h"
#include "game/view/hud_style.h"
#include "game/words/words.h"

namespace game {
namespace {

using engine::Color;
using ribbon::Vec2;

constexpr std::array<std::pair<double, const char*>, 5> marks = {
    {{0.0, "0"}, {0.001, "0.1 %"}, {0.01, "1 %"}, {0.04, "4 %"}, {max_strain, "10 %"}}};

constexpr double letter_size = 14.0;  // units of text

}  // namespace

Vec2 strain_legend_size(const engine::Canvas& canvas, double text_scale) {
  const double title = canvas.text_width(words::stretched_by, letter_size * text_scale);
  return {std::max(96.0 * text_scale, title + 20.0 * text_scale), 240.0 * text_scale};
}

void draw_strain_legend(engine::Canvas& canvas, Vec2 corner, double text_scale) {
  const double size = letter_size * text_scale;
  const Vec2 box = strain_legend_size(canvas, text_scale);
  canvas.panel(corner, box, 0.5 * size, hud_style::paper);
  canvas.text(corner + Vec2{0.5 * box.x, 0.4 * size}, words::stretched_by, size, hud_style::white,
              engine::Align::center);
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
  for (const auto& [strain, percentage] : marks) {
    const double y = (1.0 - std::sqrt(strain / max_strain)) * high;
    canvas.text(bar + Vec2{24.0 * text_scale, y - 0.6 * size}, percentage, size, hud_style::faint);
  }
}

}  // namespace game
