#include "game/view/textures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include "game/view/noise.h"
#include "game/view/place_textures.h"
#include "game/view/shading.h"

namespace game {
namespace {

using engine::Color;
using engine::Image;

using std::numbers::pi;

Image cloth_image() {
  return drawn(64, 64, [](double u, double v) {
    const double warp = std::sin(2.0 * pi * 16.0 * u);
    const double weft = std::sin(2.0 * pi * 16.0 * v);
    const double hem = std::min(v, 1.0 - v);
    const bool stitch = hem > 0.085 && hem < 0.115 && fraction(8.0 * u) < 0.55;
    const double weave = 0.9 + 0.055 * warp * weft + 0.05 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 11) - 0.5);
    const double edge = hem < 0.14 ? 0.82 : 1.0;
    return grey(stitch ? 1.0 : weave * edge * (0.7 + 0.3 * smoothstep(0.0, 0.04, hem)));
  });
}

Image wood_image() {
  return drawn(256, 64, [](double u, double v) {
    const double bend = 0.35 * tiled_noise(4.0 * u, 3.0 * v, 4, 61) + 0.1 * tiled_noise(8.0 * u, 6.0 * v, 8, 62);
    const double rings = 0.5 + 0.5 * std::sin(2.0 * pi * (5.0 * v + 2.0 * bend));
    const double grain = tiled_noise(8.0 * u, 64.0 * v, 64, 63);
    const double rim = std::min(v, 1.0 - v);
    return grey((0.78 + 0.14 * rings + 0.12 * (grain - 0.5)) * (0.62 + 0.38 * smoothstep(0.0, 0.1, rim)) +
                0.1 * smoothstep(0.2, 0.06, v) * smoothstep(0.0, 0.08, v));
  });
}

Image stone_image() {
  return drawn(128, 128, [](double u, double v) {
    const int row = static_cast<int>(4.0 * v);
    const double along = fraction(2.0 * u + 0.5 * (row % 2));
    const double up = fraction(4.0 * v);
    const double joint = std::min(2.0 * std::min(along, 1.0 - along), std::min(up, 1.0 - up));
    const int block = static_cast<int>(std::floor(2.0 * u + 0.5 * (row % 2))) % 2;
    const double tone =
        0.78 + 0.12 * scatter(block, row, 71) + 0.14 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 72) - 0.5);
    return grey((tone + 0.08 * smoothstep(0.3, 0.1, up)) * (0.62 + 0.38 * smoothstep(0.02, 0.12, joint)));
  });
}

Image shade_image() {
  return drawn(128, 128, [](double u, double v) {
    const double x = 2.0 * u - 1.0;
    const double y = 2.0 * v - 1.0;
    const double lit = std::exp(-9.0 * ((x + 0.36) * (x + 0.36) + (y + 0.42) * (y + 0.42)));
    const double dark = smoothstep(0.55, 1.45, std::hypot(x + 0.25, y + 0.3)) * 0.62;
    if (lit > 0.25) return grey(1.0, 0.75 * (lit - 0.25));
    return Color{30, 16, 30, byte(dark)};
  });
}

Image ball_image() {
  return drawn(128, 128, [](double u, double v) {
    const double x = 2.0 * u - 1.0;
    const double y = 2.0 * v - 1.0;
    const double away = std::hypot(x, y);
    const double band = smoothstep(0.30, 0.27, std::abs(y + 0.10 * x * x));
    const double hub = smoothstep(0.2, 0.17, away);
    return grey((0.84 + 0.16 * band - 0.45 * hub) * (1.0 - 0.22 * smoothstep(0.90, 0.95, away)));
  });
}

Image iron_image() {
  return drawn(128, 128, [](double u, double v) {
    const double away = std::hypot(2.0 * u - 1.0, 2.0 * v - 1.0);
    const double rim = smoothstep(0.74, 0.78, away) - smoothstep(0.92, 0.98, away);
    return grey(0.8 + 0.2 * rim + 0.16 * (tiled_cloudiness(10.0 * u, 10.0 * v, 10, 91) - 0.5) -
                0.2 * smoothstep(0.94, 1.0, away));
  });
}

Image glow_image() {
  return drawn(64, 64, [](double u, double v) {
    const double away = std::hypot(2.0 * u - 1.0, 2.0 * v - 1.0);
    const double left = std::max(1.0 - away, 0.0);
    return grey(1.0, left * left);
  });
}

/// A row of puffs, the larger ones in the middle, flat below and lit from above.
Image cloud_image(int seed) {
  return drawn(256, 128, [seed](double u, double v) {
    const double ragged = 0.10 * (tiled_cloudiness(8.0 * u, 4.0 * v, 8, seed) - 0.5);
    const double x = 2.0 * u;  // in heights of the image
    double inside = -1.0;
    double light = 0.0;
    for (int k = 0; k < 9; ++k) {
      const double along = -1.0 + k / 4.0;
      const double size = (0.13 + 0.09 * scatter(k, 0, seed)) * (1.35 - 0.85 * std::abs(along));
      const double lift = (0.05 + 0.16 * scatter(k, 1, seed)) * (1.0 - std::abs(along));
      const double y = 0.76 - 0.72 * size - lift;
      const double depth = size - std::hypot(x - 1.0 - 0.68 * along, v - y) + ragged;
      if (depth > inside) light = std::clamp(0.5 + 0.5 * (y - v) / size, 0.0, 1.0);
      inside = std::max(inside, depth);
    }
    const double base = smoothstep(0.80, 0.72, v + 0.4 * ragged);
    const double shade = 0.84 + 0.16 * smoothstep(0.1, 0.75, light);
    return Color{byte(shade), byte(shade + 0.01), byte(shade + 0.05),
                 byte(0.96 * smoothstep(0.0, 0.035, inside) * base)};
  });
}

const CommonImages& common_images() {
  static const CommonImages images{rope_image({.strands = 6, .slant = 2.0, .fibres = 0.06}),
                                   cloth_image(),
                                   wood_image(),
                                   stone_image(),
                                   shade_image(),
                                   ball_image(),
                                   iron_image(),
                                   glow_image(),
                                   {cloud_image(101), cloud_image(202), cloud_image(303)}};
  return images;
}

}  // namespace

const Textures& textures(bool colour_safe, Place place) {
  static std::array<std::optional<Textures>, 2 * places.size()> made;
  std::optional<Textures>& own = made.at(2 * static_cast<std::size_t>(place) + (colour_safe ? 1 : 0));
  if (!own) own.emplace(make_place_images(palette(colour_safe, place), place), common_images());
  return *own;
}

}  // namespace game
