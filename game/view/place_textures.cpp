#include "game/view/place_textures.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "game/view/noise.h"
#include "game/view/props.h"
#include "game/view/shading.h"

namespace game {
namespace {

using engine::Color;
using engine::Image;

using std::numbers::pi;
constexpr int ground_side = 256;  // texels that are computed; the image has twice as many

/// Makes an image that repeats, at twice the resolution by linear interpolation. Thus it can be drawn without a filter,
/// which is several times faster.
template <typename Shade>
Image ground_image(Shade shade) {
  std::vector<Color> texels;
  for (int y = 0; y < ground_side; ++y)
    for (int x = 0; x < ground_side; ++x) texels.push_back(shade((x + 0.5) / ground_side, (y + 0.5) / ground_side));
  const auto at = [&](int x, int y) {
    return texels[static_cast<std::size_t>(y & (ground_side - 1)) * ground_side +
                  static_cast<std::size_t>(x & (ground_side - 1))];
  };
  return drawn(2 * ground_side, 2 * ground_side, [&](double u, double v) {
    const double x = u * ground_side - 0.5;
    const double y = v * ground_side - 0.5;
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    return mix(mix(at(i, j), at(i + 1, j), x - i), mix(at(i, j + 1), at(i + 1, j + 1), x - i), y - j);
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

/// Earth in beds, with stones.
Image earth_image(Color color) {
  return ground_image([color](double u, double v) {
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

/// The distances to the two nearest of scattered points, in cells of a grid.
struct Cells {
  double nearest = 9.0;
  double second = 9.0;
  int number = 0;  // of the nearest
};

Cells cells_at(double x, double y, int period, int seed) {
  Cells found;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  for (int j = row - 1; j <= row + 1; ++j) {
    for (int i = column - 1; i <= column + 1; ++i) {
      const int wi = (i + period) % period;
      const int wj = (j + period) % period;
      const double away =
          std::hypot(x - i - 0.15 - 0.7 * scatter(wi, wj, seed), y - j - 0.15 - 0.7 * scatter(wi, wj, seed + 1));
      if (away < found.nearest) {
        found.second = std::exchange(found.nearest, away);
        found.number = wi + period * wj;
      } else if (away < found.second) {
        found.second = away;
      }
    }
  }
  return found;
}

/// Rock in facets with cracks.
Image rock_image(Color color) {
  return ground_image([=](double u, double v) {
    const double bend = 0.35 * (tiled_noise(6.0 * u, 6.0 * v, 6, 120) - 0.5);
    const Cells large = cells_at(6.0 * u + bend, 6.0 * v - bend, 6, 121);
    const Cells small = cells_at(17.0 * u, 17.0 * v, 17, 131);
    const double facet = 0.70 + 0.20 * scatter(large.number, 0, 125) + 0.07 * scatter(small.number, 1, 126);
    const double crack = smoothstep(0.02, 0.12, large.second - large.nearest);
    const double slope = 0.12 * (0.5 - large.nearest);
    const double grain = 0.10 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 140) - 0.5);
    return tinted(grey((facet + slope + grain) * (0.66 + 0.34 * crack)), color);
  });
}

/// Courses of large blocks.
Image quay_image(Color color) {
  return ground_image([=](double u, double v) {
    constexpr int courses = 6;
    const int row = static_cast<int>(courses * v);
    const double along = 4.0 * u + 0.5 * (row % 2) + 0.12 * (scatter(row, 0, 160) - 0.5);
    const int block = static_cast<int>(std::floor(along)) & 3;
    const double x = fraction(along);
    const double y = fraction(courses * v);
    const double edge = std::min(1.5 * std::min(x, 1.0 - x), std::min(y, 1.0 - y));
    const double worn = 0.05 * tiled_noise(24.0 * u, 24.0 * v, 24, 161);
    const double joint = smoothstep(0.035 + worn, 0.10 + worn, edge);
    const double tone =
        0.78 + 0.15 * scatter(block, row, 162) + 0.12 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 163) - 0.5);
    const double light = 0.08 * smoothstep(0.32, 0.12, y) - 0.07 * smoothstep(0.72, 0.9, y);
    return tinted(grey((tone + light) * (0.62 + 0.38 * joint)), color);
  });
}

/// Thin layers of slate that dip to one side.
Image slate_image(Color color) {
  return ground_image([=](double u, double v) {
    const double dip = v + 0.5 * u + 0.02 * tiled_noise(6.0 * u, 6.0 * v, 6, 170);
    const double along = 12.0 * dip;
    const int layer = static_cast<int>(std::floor(along));
    const double y = fraction(along);
    const int piece = static_cast<int>(std::floor(5.0 * u + 5.0 * scatter(layer % 12, 0, 171)));
    const double end = fraction(5.0 * u + 5.0 * scatter(layer % 12, 0, 171));
    const double tone = 0.72 + 0.22 * scatter(layer % 12, piece % 5, 172);
    const double joint = smoothstep(0.0, 0.16, y) * smoothstep(0.0, 0.05, std::min(end, 1.0 - end));
    const double wet = 0.20 * smoothstep(0.3, 0.18, y) * smoothstep(0.08, 0.16, y);
    return tinted(
        grey((tone + wet + 0.10 * (tiled_cloudiness(8.0 * u, 8.0 * v, 8, 173) - 0.5)) * (0.64 + 0.36 * joint)), color);
  });
}

/// Returns the colour of a lit rim of rock: broken stones along the surface, which is at v = 0.5.
Color rock_rim_at(double u, double v) {
  const double top = 0.47 - 0.10 * tiled_noise(40.0 * u, 0.0, 40, 181) * tiled_noise(13.0 * u, 0.5, 13, 182);
  const double bottom = 0.56 + 0.12 * tiled_noise(30.0 * u, 0.0, 30, 183) + 0.05 * tiled_noise(90.0 * u, 0.0, 90, 184);
  if (v < top || v > bottom) return grey(0.5, 0.0);
  const double lit = smoothstep(0.09, 0.0, v - top);
  const double stones = 0.12 * tiled_noise(60.0 * u, 20.0 * v, 60, 185);
  return grey(0.66 + 0.34 * lit + stones - 0.22 * smoothstep(bottom - 0.05, bottom, v));
}

/// Returns the colour of planks seen from the side, with a shadow below.
Color planks_at(double u, double v) {
  constexpr int planks = 5;
  constexpr double top = 0.44;
  constexpr double bottom = 0.60;
  if (v > bottom && v < bottom + 0.08) return {20, 16, 20, byte(0.45 * (1.0 - (v - bottom) / 0.08))};
  if (v < top || v > bottom) return grey(0.5, 0.0);
  const double x = fraction(planks * u);
  const int plank = static_cast<int>(planks * u);
  const double y = (v - top) / (bottom - top);
  const double grain = 0.12 * (tiled_noise(16.0 * u, 90.0 * v, 160, 191 + plank) - 0.5);
  const double nail = smoothstep(0.010, 0.006, std::hypot(std::min(x, 1.0 - x) - 0.03, 0.16 * (y - 0.5)));
  const double joint = smoothstep(0.0, 0.012, std::min(x, 1.0 - x));
  const double edge = 1.0 - 0.35 * smoothstep(0.80, 0.96, y) + 0.12 * smoothstep(0.16, 0.06, y);
  return grey((0.80 + 0.10 * scatter(plank, 0, 192) + grain) * edge * (0.45 + 0.55 * joint) * (1.0 - 0.6 * nail));
}

/// Returns the colour of wet stone with tufts of grass.
Color wet_rim_at(double u, double v) {
  const Color rim = rock_rim_at(u + 0.37, v);
  if (tiled_noise(9.0 * u, 0.0, 9, 195) > 0.56) {
    const Color blade = grass_at(u, std::min(v, 0.58));
    if (blade.a > 0 && v < 0.58) return tinted(blade, {196, 226, 190});
  }
  return rim;
}

}  // namespace

/// A rope of twisted strands, each shaded as a round bar.
Image rope_image(const RopeLook& look) {
  return drawn(128, 32, [look](double u, double v) {
    const double across = 2.0 * v - 1.0;
    // The slope of a strand grows towards the edge of the round rope.
    const double wound = std::asin(std::clamp(across, -1.0, 1.0)) / pi;
    const double strand = fraction(look.strands * u + look.slant * wound);
    const double bulge = roundness(2.0 * strand - 1.0);
    const double fibre =
        tiled_noise(64.0 * u, 24.0 * (strand + std::floor(look.strands * u + look.slant * wound)), 64, 3);
    const double light = (0.42 + 0.58 * bulge) * (0.5 + 0.5 * roundness(across)) + look.fibres * (fibre - 0.5);
    const double shine = look.shine * bulge * smoothstep(0.35, 0.0, std::abs(across + 0.3));
    return grey((light + 0.5 * shine) * (1.0 - 0.45 * smoothstep(0.8, 1.0, std::abs(across))));
  });
}

PlaceImages make_place_images(const Palette& colors, Place place) {
  switch (place) {
    case Place::cave:
      return {rope_image({.strands = 4, .slant = 1.0, .fibres = 0.07}),
              rock_image(colors.soil),
              drawn(512, 64, rock_rim_at),
              {crystal_image(colors.accent, 7), crystal_image(colors.accent, 8)}};
    case Place::harbour:
      return {
          rope_image({.strands = 3, .slant = 1.0, .fibres = 0.06, .shine = 0.5}),
          quay_image(colors.soil),
          drawn(512, 64, planks_at),
          {crane_image(mix(colors.hills[1], colors.ink, 0.10)), ship_image(mix(colors.hills[2], colors.ink, 0.35))}};
    case Place::storm:
      return {rope_image({.strands = 3, .slant = 1.0, .fibres = 0.05, .shine = 0.8}),
              slate_image(colors.soil),
              drawn(512, 64, wet_rim_at),
              {bent_tree_image(colors.hills[2]), bent_tree_image(colors.hills[3])}};
    case Place::hills:
    default:
      return {rope_image({}),
              earth_image(colors.soil),
              drawn(512, 64, grass_at),
              {fir_image(colors.hills[2]), fir_image(colors.hills[3])}};
  }
}

}  // namespace game
