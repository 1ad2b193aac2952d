#include "game/view/palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace game {
namespace {

using engine::Color;

constexpr Palette hills{
    .sky_top = {70, 134, 190},
    .sky_middle = {150, 202, 220},
    .horizon = {255, 232, 196},
    .sun = {255, 246, 214},
    .cloud = {255, 252, 246},
    .mist = {238, 242, 226},
    .hills = {{{164, 198, 218}, {138, 186, 194}, {108, 168, 146}, {70, 134, 104}}},
    .accent = {255, 252, 246},
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
    .figure_rim = {52, 44, 54},
    .lamp = {255, 255, 255, 0},
};

constexpr Palette safe_hills{
    .sky_top = {96, 140, 178},
    .sky_middle = {176, 204, 216},
    .horizon = {246, 238, 222},
    .sun = {255, 250, 232},
    .cloud = {255, 255, 255},
    .mist = {240, 242, 240},
    .hills = {{{190, 206, 214}, {166, 186, 196}, {138, 162, 172}, {104, 132, 144}}},
    .accent = {255, 255, 255},
    .soil = {150, 138, 128},
    .deep_light = 180,
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
    .figure_rim = {30, 30, 40},
    .lamp = {255, 255, 255, 0},
};

constexpr Palette cave{
    .sky_top = {22, 24, 46},
    .sky_middle = {44, 56, 88},
    .horizon = {76, 104, 128},
    .sun = {190, 226, 230},
    .cloud = {70, 88, 120},
    .mist = {66, 86, 118},
    .hills = {{{52, 64, 98}, {41, 49, 79}, {32, 36, 61}, {24, 25, 44}}},
    .accent = {104, 226, 232},
    .soil = {138, 124, 148},
    .deep_light = 84,
    .grass = {176, 170, 198},
    .wood = {206, 156, 106},
    .stone = {128, 126, 146},
    .ropes = {{{255, 232, 186}, {240, 212, 168}, {255, 244, 214}}},
    .ribbons = {{{240, 112, 92}, {92, 190, 208}, {250, 198, 92}, {182, 146, 216}}},
    .balls = {{{250, 122, 94}, {255, 206, 92}, {112, 196, 224}}},
    .iron = {176, 180, 202},
    .line = {255, 248, 224},
    .hook = {206, 200, 222},
    .hook_in_range = {255, 214, 90},
    .banner_down = {176, 176, 194},
    .banner_up = {96, 214, 142},
    .goal = {255, 210, 80},
    .ink = {14, 12, 24},
    .figure_rim = {236, 220, 196},
    .lamp = {255, 200, 120, 74},
};

constexpr Palette harbour{
    .sky_top = {98, 142, 184},
    .sky_middle = {196, 206, 206},
    .horizon = {255, 214, 164},
    .sun = {255, 244, 208},
    .cloud = {255, 242, 226},
    .mist = {250, 224, 194},
    .hills = {{{176, 184, 192}, {148, 162, 176}, {108, 152, 172}, {62, 120, 150}}},
    .accent = {255, 236, 190},
    .soil = {190, 178, 160},
    .deep_light = 150,
    .grass = {206, 160, 112},
    .wood = {186, 134, 90},
    .stone = {160, 156, 152},
    .ropes = {{{164, 118, 76}, {144, 100, 66}, {182, 136, 92}}},
    .ribbons = {{{214, 78, 66}, {46, 124, 158}, {246, 186, 72}, {240, 232, 214}}},
    .balls = {{{236, 92, 66}, {252, 196, 78}, {62, 146, 186}}},
    .iron = {128, 132, 150},
    .line = {252, 244, 222},
    .hook = {92, 84, 100},
    .hook_in_range = {255, 206, 70},
    .banner_down = {150, 146, 156},
    .banner_up = {44, 158, 104},
    .goal = {255, 196, 52},
    .ink = {44, 36, 46},
    .figure_rim = {44, 36, 46},
    .lamp = {255, 255, 255, 0},
};

constexpr Palette storm{
    .sky_top = {40, 50, 68},
    .sky_middle = {78, 94, 114},
    .horizon = {142, 158, 164},
    .sun = {196, 208, 208},
    .cloud = {92, 104, 124},
    .mist = {128, 144, 152},
    .hills = {{{92, 108, 124}, {72, 88, 104}, {55, 70, 86}, {40, 52, 66}}},
    .accent = {236, 240, 255},
    .soil = {112, 120, 136},
    .deep_light = 100,
    .grass = {140, 160, 146},
    .wood = {164, 130, 100},
    .stone = {124, 128, 140},
    .ropes = {{{236, 214, 172}, {220, 194, 152}, {246, 230, 196}}},
    .ribbons = {{{236, 104, 86}, {92, 182, 204}, {248, 196, 88}, {178, 142, 210}}},
    .balls = {{{246, 116, 90}, {252, 202, 88}, {108, 188, 216}}},
    .iron = {164, 170, 186},
    .line = {252, 248, 232},
    .hook = {202, 206, 218},
    .hook_in_range = {255, 214, 86},
    .banner_down = {170, 174, 186},
    .banner_up = {94, 208, 138},
    .goal = {255, 208, 74},
    .ink = {18, 20, 30},
    .figure_rim = {22, 24, 34},
    .lamp = {255, 255, 255, 0},
};

Color greyer(Color c) {
  const auto grey = static_cast<std::uint8_t>((54 * c.r + 183 * c.g + 19 * c.b) / 256);
  return mix(c, {grey, grey, grey, c.a}, 0.5);
}

/// Returns a palette whose surroundings have less colour, with signs and ropes in hues that do not differ by red and
/// green alone.
Palette made_safe(Palette p, bool is_dark) {
  for (Color* const c : {&p.sky_top, &p.sky_middle, &p.horizon, &p.cloud, &p.mist, &p.soil, &p.grass, &p.wood})
    *c = greyer(*c);
  for (Color& c : p.hills) c = greyer(c);
  const Color blue = is_dark ? Color{86, 180, 233} : Color{0, 114, 178};
  p.ropes = is_dark ? safe_hills.ropes : std::array<Color, 3>{{{176, 98, 20}, {140, 76, 10}, {204, 130, 40}}};
  p.ribbons = {{{213, 94, 0}, blue, {240, 228, 66}, {204, 121, 167}}};
  p.balls = {{{213, 94, 0}, {240, 228, 66}, blue}};
  p.line = {255, 255, 255};
  p.hook = is_dark ? Color{214, 216, 230} : safe_hills.hook;
  p.hook_in_range = safe_hills.hook_in_range;
  p.banner_up = blue;
  p.goal = is_dark ? Color{240, 190, 40} : safe_hills.goal;
  p.accent = is_dark ? Color{150, 214, 245} : p.accent;
  return p;
}

}  // namespace

const Palette& palette(bool colour_safe, Place place) {
  static const std::array<Palette, places.size()> standard = {hills, cave, harbour, storm};
  static const std::array<Palette, places.size()> safe = {safe_hills, made_safe(cave, true), made_safe(harbour, false),
                                                          made_safe(storm, true)};
  return (colour_safe ? safe : standard)[static_cast<std::size_t>(place)];
}

Color mix(Color a, Color b, double t) {
  // Does not use lround, which would be a call for each channel.
  const double part = std::clamp(t, 0.0, 1.0);
  const auto channel = [part](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(0.5 + from + part * (to - from));
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
