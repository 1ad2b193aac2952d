#include "game/view/props.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "game/view/noise.h"
#include "game/view/palette.h"
#include "game/view/shading.h"
#include "ribbon/vec2.h"

namespace game {

using engine::Color;
using engine::Image;
using ribbon::Vec2;

namespace {

/// A straight bar from a to b. Lengths in heights of the image.
struct Bar {
  Vec2 a, b;
  double width;
};

double distance(Vec2 p, const Bar& bar) {
  const Vec2 along = bar.b - bar.a;
  const double t = std::clamp(dot(p - bar.a, along) / dot(along, along), 0.0, 1.0);
  return length(p - bar.a - t * along) - 0.5 * bar.width;
}

/// Returns the cover of bars at p, 0 … 1; `texel`: the size of a texel.
double cover(std::span<const Bar> bars, Vec2 p, double texel) {
  double nearest = 9.0;
  for (const Bar& bar : bars) nearest = std::min(nearest, distance(p, bar));
  return smoothstep(0.7 * texel, -0.7 * texel, nearest);
}

}  // namespace

Image fir_image(Color color) {
  return drawn(64, 128, [color](double u, double v) {
    const double x = std::abs(2.0 * u - 1.0);
    if (v > 0.9) return tinted(grey(0.5, x < 0.08 ? 1.0 : 0.0), color);
    const double tier = fraction(4.2 * v + 0.15);
    const double reach =
        (0.14 + 0.66 * v) * (0.52 + 0.48 * tier) * (0.9 + 0.2 * tiled_noise(8.0 * u, 24.0 * v, 64, 95));
    return tinted(
        grey(0.86 + 0.14 * (u < 0.5 ? 1.0 : -1.0) * smoothstep(0.0, 0.4, x), smoothstep(reach, reach - 0.05, x)),
        color);
  });
}

Image bent_tree_image(Color color) {
  return drawn(64, 128, [color](double u, double v) {
    const double up = 1.0 - v;
    const double x = 2.0 * u - 1.0 - 0.55 * up * up;  // leans to the right
    if (v > 0.88) return tinted(grey(0.5, std::abs(x) < 0.07 ? 1.0 : 0.0), color);
    const double tier = fraction(5.2 * v + 0.15);
    const double ragged = 0.85 + 0.3 * tiled_noise(8.0 * u, 24.0 * v, 64, 96);
    const double reach = (0.08 + 0.50 * v) * (0.45 + 0.55 * tier) * ragged * (x > 0.0 ? 1.15 : 0.45);
    const double inside = smoothstep(reach, reach - 0.06, std::abs(x));
    return tinted(grey(0.84 + 0.10 * (x > 0.0 ? -1.0 : 1.0), inside), color);
  });
}

Image crystal_image(Color color, int seed) {
  return drawn(128, 128, [color, seed](double u, double v) {
    double best = -1.0;
    double light = 0.0;
    for (int k = 0; k < 6; ++k) {
      const double lean = 0.9 * (k - 2.5) / 2.5 + 0.2 * (scatter(k, 0, seed) - 0.5);
      const double tall = 0.45 + 0.5 * scatter(k, 1, seed) - 0.22 * std::abs(lean);
      const double half = 0.05 + 0.035 * scatter(k, 2, seed);
      const double s = std::sin(0.6 * lean);
      const double c = std::cos(0.6 * lean);
      const Vec2 p{u - 0.5 - 0.05 * (k - 2.5), 1.02 - v};
      const double along = s * p.x + c * p.y;
      const double across = c * p.x - s * p.y;
      const double width = half * std::min(1.0, (tall - along) / (2.2 * half));
      const double inside = width - std::abs(across);
      if (inside < -0.01 || along < 0.0 || inside < best) continue;
      best = inside;
      const double facet = across < -0.25 * width ? 1.0 : across < 0.45 * width ? 0.74 : 0.5;
      light = facet * (0.55 + 0.45 * along / tall);
    }
    const Color glass =
        mix({30, 44, 82}, mix(color, {255, 255, 255}, 0.6 * smoothstep(0.75, 1.0, light)), 0.25 + 0.75 * light);
    return Color{glass.r, glass.g, glass.b, byte(0.95 * smoothstep(-0.008, 0.008, best))};
  });
}

Image crane_image(Color color) {
  static constexpr std::array<Bar, 21> bars = {
      {{{0.30, 1.0}, {0.34, 0.42}, 0.020},  {{0.48, 1.0}, {0.44, 0.42}, 0.020},  {{0.30, 1.0}, {0.46, 0.82}, 0.009},
       {{0.47, 1.0}, {0.31, 0.82}, 0.009},  {{0.31, 0.82}, {0.46, 0.82}, 0.012}, {{0.31, 0.82}, {0.45, 0.62}, 0.009},
       {{0.46, 0.82}, {0.33, 0.62}, 0.009}, {{0.33, 0.62}, {0.45, 0.62}, 0.012}, {{0.33, 0.62}, {0.44, 0.44}, 0.009},
       {{0.45, 0.62}, {0.34, 0.44}, 0.009}, {{0.26, 0.40}, {0.52, 0.40}, 0.050}, {{0.30, 0.34}, {0.40, 0.34}, 0.090},
       {{0.44, 0.40}, {0.94, 0.10}, 0.020}, {{0.42, 0.40}, {0.40, 0.16}, 0.014}, {{0.40, 0.16}, {0.94, 0.10}, 0.007},
       {{0.40, 0.16}, {0.22, 0.38}, 0.009}, {{0.56, 0.33}, {0.60, 0.28}, 0.008}, {{0.70, 0.245}, {0.74, 0.20}, 0.008},
       {{0.92, 0.11}, {0.92, 0.52}, 0.006}, {{0.92, 0.52}, {0.92, 0.55}, 0.022}, {{0.20, 0.36}, {0.28, 0.36}, 0.060}}};
  return drawn(256, 256, [color](double u, double v) {
    return tinted(grey(0.98 - 0.10 * v, cover(bars, {u, v}, 1.0 / 256.0)), color);
  });
}

Image ship_image(Color color) {
  static constexpr std::array<Bar, 18> bars = {{{{0.26, 0.84}, {0.26, 0.16}, 0.016},
                                                {{0.48, 0.84}, {0.48, 0.06}, 0.018},
                                                {{0.68, 0.84}, {0.68, 0.20}, 0.015},
                                                {{0.14, 0.34}, {0.38, 0.34}, 0.020},
                                                {{0.16, 0.52}, {0.36, 0.52}, 0.022},
                                                {{0.35, 0.24}, {0.61, 0.24}, 0.020},
                                                {{0.34, 0.44}, {0.62, 0.44}, 0.024},
                                                {{0.58, 0.36}, {0.78, 0.36}, 0.018},
                                                {{0.57, 0.54}, {0.79, 0.54}, 0.022},
                                                {{0.84, 0.80}, {0.98, 0.66}, 0.014},
                                                {{0.68, 0.20}, {0.97, 0.67}, 0.004},
                                                {{0.48, 0.06}, {0.68, 0.30}, 0.004},
                                                {{0.26, 0.16}, {0.48, 0.14}, 0.004},
                                                {{0.26, 0.16}, {0.08, 0.80}, 0.004},
                                                {{0.26, 0.18}, {0.36, 0.84}, 0.004},
                                                {{0.48, 0.08}, {0.60, 0.84}, 0.004},
                                                {{0.48, 0.08}, {0.38, 0.84}, 0.004},
                                                {{0.68, 0.22}, {0.78, 0.84}, 0.004}}};
  return drawn(256, 256, [color](double u, double v) {
    const double deck = 0.84 - 0.06 * std::pow(std::abs(2.0 * u - 1.0), 2.0);
    const double bow = 0.90 - 0.10 * (v - deck) / 0.16;
    const double stern = 0.08 + 0.05 * (v - deck) / 0.16;
    const double hull = smoothstep(-0.004, 0.004, std::min({v - deck, bow - u, u - stern}));
    const double stripe = smoothstep(0.012, 0.006, std::abs(v - deck - 0.05));
    const double all = std::max(hull, cover(bars, {u, v}, 1.0 / 256.0));
    return tinted(grey(0.92 + 0.08 * stripe - 0.12 * (1.0 - v), all),
                  mix(color, {255, 240, 220}, 0.35 * stripe * hull));
  });
}

}  // namespace game
