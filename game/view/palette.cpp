#include "game/view/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace game {
namespace {

using engine::Color;

constexpr Palette usual{
    .sky_top = {70, 134, 190},
    .sky_middle = {150, 202, 220},
    .horizon = {255, 232, 196},
    .sun = {255, 246, 214},
    .cloud = {255, 252, 246},
    .hills = {{{176, 204, 214}, {146, 186, 186}, {110, 162, 146}, {72, 126, 102}}},
    .soil = {176, 128, 92},
    .soil_deep = {96, 66, 58},
    .grass = {124, 178, 72},
    .wood = {190, 136, 84},
    .stone = {158, 154, 156},
    .ropes = {{{236, 192, 124}, {220, 168, 104}, {242, 208, 150}}},
    .ribbons = {{{214, 84, 70}, {64, 140, 158}, {228, 168, 62}, {128, 96, 158}}},
    .balls = {{{226, 98, 72}, {240, 178, 66}, {86, 150, 172}}},
    .iron = {86, 88, 102},
    .line = {252, 242, 214},
    .hook = {96, 90, 110},
    .hook_in_reach = {255, 208, 74},
    .banner_down = {150, 150, 164},
    .banner_up = {72, 178, 112},
    .goal = {244, 190, 58},
    .ink = {52, 44, 54},
};

constexpr Palette safe{
    .sky_top = {96, 140, 178},
    .sky_middle = {176, 204, 216},
    .horizon = {246, 238, 222},
    .sun = {255, 250, 232},
    .cloud = {255, 255, 255},
    .hills = {{{190, 206, 214}, {166, 186, 196}, {138, 162, 172}, {104, 132, 144}}},
    .soil = {150, 138, 128},
    .soil_deep = {74, 68, 70},
    .grass = {176, 190, 150},
    .wood = {166, 146, 124},
    .stone = {158, 158, 164},
    .ropes = {{{240, 228, 120}, {230, 180, 60}, {250, 240, 180}}},
    .ribbons = {{{213, 94, 0}, {0, 114, 178}, {240, 228, 66}, {204, 121, 167}}},
    .balls = {{{213, 94, 0}, {240, 228, 66}, {0, 114, 178}}},
    .iron = {60, 62, 74},
    .line = {255, 255, 255},
    .hook = {40, 42, 60},
    .hook_in_reach = {240, 228, 66},
    .banner_down = {120, 120, 132},
    .banner_up = {0, 114, 178},
    .goal = {230, 159, 0},
    .ink = {30, 30, 40},
};

}  // namespace

const Palette& palette(bool colour_safe) { return colour_safe ? safe : usual; }

Color mix(Color a, Color b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + std::clamp(share, 0.0, 1.0) * (to - from)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

Color with_alpha(Color color, int alpha) {
  color.a = static_cast<std::uint8_t>(std::clamp(alpha, 0, 255));
  return color;
}

Color ramp_color(double share) {
  constexpr std::array<Color, 6> stops = {
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[below], stops[below + 1], place - static_cast<double>(below));
}

}  // namespace game
