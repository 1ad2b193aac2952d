#include "game/view/palette.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace game {
namespace {

using engine::Color;

constexpr Palette standard{
    .sky_top = {70, 134, 190},
    .sky_middle = {150, 202, 220},
    .horizon = {255, 232, 196},
    .sun = {255, 246, 214},
    .cloud = {255, 252, 246},
    .mist = {238, 242, 226},
    .hills = {{{164, 198, 218}, {138, 186, 194}, {108, 168, 146}, {70, 134, 104}}},
    .soil = {214, 160, 112},
    .deep_light = 120,
    .grass = {150, 208, 84},
    .wood = {222, 164, 104},
    .stone = {158, 154, 156},
    .ropes = {{{255, 212, 138}, {244, 190, 120}, {255, 226, 168}}},
    .ribbons = {{{236, 96, 78}, {72, 166, 186}, {248, 188, 72}, {160, 122, 196}}},
    .balls = {{{250, 112, 84}, {255, 200, 78}, {96, 184, 214}}},
    .iron = {136, 140, 158},
    .line = {252, 242, 214},
    .hook = {96, 90, 110},
    .hook_in_range = {255, 208, 74},
    .banner_down = {150, 150, 164},
    .banner_up = {72, 178, 112},
    .goal = {255, 204, 62},
    .ink = {52, 44, 54},
};

constexpr Palette safe{
    .sky_top = {96, 140, 178},
    .sky_middle = {176, 204, 216},
    .horizon = {246, 238, 222},
    .sun = {255, 250, 232},
    .cloud = {255, 255, 255},
    .mist = {240, 242, 240},
    .hills = {{{190, 206, 214}, {166, 186, 196}, {138, 162, 172}, {104, 132, 144}}},
    .soil = {150, 138, 128},
    .deep_light = 120,
    .grass = {176, 190, 150},
    .wood = {166, 146, 124},
    .stone = {158, 158, 164},
    .ropes = {{{240, 228, 120}, {230, 180, 60}, {250, 240, 180}}},
    .ribbons = {{{213, 94, 0}, {0, 114, 178}, {240, 228, 66}, {204, 121, 167}}},
    .balls = {{{213, 94, 0}, {240, 228, 66}, {0, 114, 178}}},
    .iron = {60, 62, 74},
    .line = {255, 255, 255},
    .hook = {40, 42, 60},
    .hook_in_range = {240, 228, 66},
    .banner_down = {120, 120, 132},
    .banner_up = {0, 114, 178},
    .goal = {230, 159, 0},
    .ink = {30, 30, 40},
};

}  // namespace

const Palette& palette(bool colour_safe) { return colour_safe ? safe : standard; }

Color mix(Color a, Color b, double t) {
  const auto channel = [t](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + std::clamp(t, 0.0, 1.0) * (to - from)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b), channel(a.a, b.a)};
}

Color with_alpha(Color color, int alpha) {
  color.a = static_cast<std::uint8_t>(std::clamp(alpha, 0, 255));
  return color;
}

Color ramp_color(double value) {
  constexpr std::array<Color, 6> stops = {
      {{68, 1, 84}, {65, 68, 135}, {42, 120, 142}, {34, 168, 132}, {122, 209, 81}, {253, 231, 37}}};
  const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[below], stops[below + 1], place - static_cast<double>(below));
}

}  // namespace game
