#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "game/view/figure.h"

namespace game {
namespace {

using engine::Color;

/// The relative luminance of WCAG 2.1.
double luminance(Color color) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

double contrast(Color a, Color b) {
  const double ratio = (luminance(a) + 0.05) / (luminance(b) + 0.05);
  return std::max(ratio, 1.0 / ratio);
}

Color over(Color top, Color below) { return mix(below, top, top.a / 255.0); }

std::vector<Color> backdrops(const Palette& colors) {
  std::vector<Color> all{colors.sky_top, colors.sky_middle, colors.horizon, colors.sun,  colors.cloud,
                         colors.mist,    colors.soil,       colors.grass,   colors.wood, colors.stone};
  all.insert(all.end(), colors.hills.begin(), colors.hills.end());
  all.push_back(mix({0, 0, 0}, colors.soil, colors.deep_light / 255.0));
  return all;
}

/// Calls use(colors, name) for both palettes of all places.
template <typename Use>
void each_palette(Use use) {
  for (const Place place : places)
    for (const bool safe : {false, true})
      use(palette(safe, place), std::string(place_name(place)) + (safe ? ", colour-safe" : ""));
}

/// With any kind of colour blindness.
TEST(Clothes, OfTwoPlayersDifferInBrightness) {
  EXPECT_GE(contrast(clothes_of(0).jacket, clothes_of(1).jacket), 2.0);
  EXPECT_GE(contrast(clothes_of(0).scarf, clothes_of(1).scarf), 2.0);
}

TEST(Ghost, DiffersFromEveryBackdrop) {
  each_palette([](const Palette& colors, const std::string& name) {
    const GhostColors ghost = ghost_colors(colors);
    for (const Color& backdrop : backdrops(colors)) {
      const Color outline = over(ghost.outline, backdrop);
      const Color body = over(ghost.body, outline);
      EXPECT_GE(std::max(contrast(outline, backdrop), contrast(body, backdrop)), 1.5) << name << luminance(backdrop);
      EXPECT_GE(contrast(outline, body), 1.5) << name << luminance(backdrop);
    }
  });
}

/// Each of them is drawn with an outline of ink: one of the two differs from any backdrop, and they from each other.
TEST(Contrast, RopesHooksAndTheGoalAreReadableInAllPlaces) {
  each_palette([](const Palette& colors, const std::string& name) {
    std::vector<std::pair<std::string, Color>> marks{{"hook", mix(colors.hook, {255, 255, 255}, 0.35)},
                                                     {"hook in range", colors.hook_in_range},
                                                     {"line", colors.line},
                                                     {"goal", colors.goal},
                                                     {"banner", colors.banner_up}};
    for (const Color rope : colors.ropes) marks.emplace_back("rope", rope);
    for (const auto& [mark, color] : marks) {
      EXPECT_GE(contrast(color, colors.ink), 2.0) << name << ": " << mark;
      for (const Color& backdrop : backdrops(colors))
        EXPECT_GE(std::max(contrast(color, backdrop), contrast(colors.ink, backdrop)), 2.5)
            << name << ": " << mark << " on " << luminance(backdrop);
    }
  });
}

/// The outline, the jacket, the trousers or the scarf of a player differ from any backdrop.
TEST(Contrast, PlayersAreReadableInAllPlaces) {
  each_palette([&](const Palette& colors, const std::string& name) {
    for (const Color& backdrop : backdrops(colors)) {
      for (const int player : {0, 1}) {
        const Clothes& clothes = clothes_of(player);
        double best = 0.0;
        for (const Color part : {colors.figure_rim, clothes.jacket, clothes.trousers, clothes.scarf})
          best = std::max(best, contrast(part, backdrop));
        EXPECT_GE(best, 2.0) << name << luminance(backdrop) << " player " << player;
      }
    }
  });
}

}  // namespace
}  // namespace game
