#include "game/view/textures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "game/view/noise.h"

namespace game {
namespace {

using engine::Color;
using engine::Image;

constexpr double pi = std::numbers::pi;

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

Color tinted(Color light, Color color) {
  const auto channel = [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a * b + 127) / 255); };
  return {channel(light.r, color.r), channel(light.g, color.g), channel(light.b, color.b), light.a};
}

double fraction(double x) { return x - std::floor(x); }

std::uint8_t byte(double x) { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(x, 0.0, 1.0))); }
Color grey(double light, double opacity = 1.0) { return {byte(light), byte(light), byte(light), byte(opacity)}; }

/// Makes an image with the colours shade(u, v) at the middles of the texels; u and v are 0 … 1.
template <typename Shade>
Image drawn(int width, int height, Shade shade) {
  std::vector<Color> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) pixels.push_back(shade((x + 0.5) / width, (y + 0.5) / height));
  return {width, height, pixels};
}

/// Returns the brightness of a round bar at −1 … 1 across it, lit from the front.
double roundness(double across) { return std::sqrt(std::max(1.0 - across * across, 0.0)); }

/// A rope of twisted strands, each shaded as a round bar.
Image rope_image(int strands, double slant, double fibres) {
  return drawn(128, 32, [=](double u, double v) {
    const double across = 2.0 * v - 1.0;
    // The slope of a strand grows towards the edge of the round rope.
    const double wound = std::asin(std::clamp(across, -1.0, 1.0)) / pi;
    const double strand = fraction(strands * u + slant * wound);
    const double bulge = roundness(2.0 * strand - 1.0);
    const double fibre = tiled_noise(64.0 * u, 24.0 * (strand + std::floor(strands * u + slant * wound)), 64, 3);
    const double light = (0.42 + 0.58 * bulge) * (0.5 + 0.5 * roundness(across)) + fibres * (fibre - 0.5);
    return grey(light * (1.0 - 0.45 * smoothstep(0.8, 1.0, std::abs(across))));
  });
}

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

/// Returns the brightness of the pebbles at (u, v), 0 where there is none. Some cells of a grid have a pebble.
double pebble(double u, double v, int cells, int seed) {
  double brightest = 0.0;
  const int column = static_cast<int>(std::floor(cells * u));
  const int row = static_cast<int>(std::floor(cells * v));
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      const int wi = (i + cells) % cells;
      const int wj = (j + cells) % cells;
      if (scatter(wi, wj, seed) > 0.35) continue;
      const double x = cells * u - i - 0.2 - 0.6 * scatter(wi, wj, seed + 1);
      const double y = cells * v - j - 0.2 - 0.6 * scatter(wi, wj, seed + 2);
      const double size = 0.16 + 0.26 * scatter(wi, wj, seed + 3);
      const double away = std::sqrt(x * x + 1.7 * y * y) / size;
      brightest = std::max(brightest, smoothstep(1.0, 0.8, away) * (0.75 - 0.4 * y / size));
    }
  }
  return brightest;
}

Image soil_image(Color color) {
  return drawn(256, 256, [color](double u, double v) {
    const double wave = 0.025 * std::sin(2.0 * pi * (2.0 * u + v)) + 0.03 * tiled_noise(8.0 * u, 8.0 * v, 8, 20);
    const double bed = tiled_noise(0.5, 10.0 * (v + wave), 10, 22);
    const double layers = 0.10 * (smoothstep(0.4, 0.5, bed) - 0.5) + 0.05 * smoothstep(0.62, 0.66, bed);
    const double grain = 0.10 * (tiled_noise(64.0 * u, 64.0 * v, 64, 21) - 0.5) +
                         0.08 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 23) - 0.5);
    const double stone = std::max(pebble(u, v, 6, 31), 0.9 * pebble(u, v, 15, 41));
    const double earth = 0.80 + layers + grain;
    return tinted(grey(stone > 0.05 ? earth + 0.36 * (stone - 0.36) : earth), color);
  });
}

/// Returns the colour of the grass at (u, v): the brightest of the blades there, or the roots below the surface.
Color grass_at(double u, double v) {
  constexpr int blades = 110;
  constexpr double ground = 0.5;  // v of the surface
  double light = -1.0;
  for (int k = static_cast<int>(blades * u) - 3; k <= static_cast<int>(blades * u) + 3; ++k) {
    const int wk = (k + blades) % blades;
    const double tall = 0.10 + 0.12 * scatter(wk, 0, 51) + 0.22 * scatter(wk, 0, 51) * scatter(wk, 1, 51);
    const double height = (ground + 0.04 - v) / tall;
    if (height < 0.0 || height > 1.0) continue;
    const double lean = 2.6 * (scatter(wk, 2, 51) - 0.5) * height * height;
    const double width = 1.5 * (1.0 - height);
    if (std::abs(blades * u - k - 0.5 - lean) < 0.5 * width)
      light = std::max(light, 0.70 + 0.26 * height + 0.16 * (scatter(wk, 3, 51) - 0.5));
  }
  if (light >= 0.0) return grey(light);
  const double fringe = ground + 0.18 + 0.24 * tiled_noise(24.0 * u, 0.0, 24, 57) * tiled_noise(60.0 * u, 0.0, 60, 58);
  if (v < ground || v > fringe) return grey(0.5, 0.0);
  const double rim = smoothstep(fringe - 0.05, fringe - 0.03, v);
  return grey((0.92 - 0.5 * (v - ground) + 0.1 * (tiled_noise(64.0 * u, 32.0 * v, 64, 59) - 0.5)) * (1.0 - 0.4 * rim));
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

Image tree_image(Color color) {
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

}  // namespace

const Textures& textures(const Palette& colors) {
  const auto make = [](const Palette& of) {
    return Textures{rope_image(3, 1.0, 0.1),
                    rope_image(6, 2.0, 0.06),
                    cloth_image(),
                    soil_image(of.soil),
                    drawn(512, 64, grass_at),
                    wood_image(),
                    stone_image(),
                    shade_image(),
                    ball_image(),
                    iron_image(),
                    glow_image(),
                    {tree_image(of.hills[2]), tree_image(of.hills[3])},
                    {cloud_image(101), cloud_image(202), cloud_image(303)}};
  };
  if (&colors == &palette(true)) {
    static const Textures safe = make(colors);
    return safe;
  }
  static const Textures standard = make(colors);
  return standard;
}

}  // namespace game
