#pragma once

#include <array>

#include "engine/draw/color.h"

namespace game {

/// The colours of everything. The backdrop's come from far to near.
struct Palette {
  engine::Color sky_top, sky_middle, horizon, sun, cloud, mist;
  std::array<engine::Color, 4> hills;
  engine::Color soil;
  int deep_light;  ///< 0 … 255: how bright the soil is some metres below the grass
  engine::Color grass, wood, stone;
  std::array<engine::Color, 3> ropes;    ///< one after the other, so that neighbours differ
  std::array<engine::Color, 4> ribbons;  ///< likewise
  std::array<engine::Color, 3> balls;
  engine::Color iron, line;
  engine::Color hook, hook_in_reach;
  engine::Color banner_down, banner_up, goal;
  engine::Color ink;
};

/// The usual one, or one whose playing pieces stay apart for who sees red and green alike: hues of Okabe and Ito's set,
/// different in lightness too.
const Palette& palette(bool colour_safe);

/// How a share 0 … 1 is coloured: dark blue over green to yellow, as bright as it is large, in steps that look equal,
/// and apart for who sees red and green alike (the map viridis).
engine::Color ramp_color(double share);

/// `share` (0 … 1) of the way from a to b.
engine::Color mix(engine::Color a, engine::Color b, double share);
engine::Color with_alpha(engine::Color color, int alpha);

}  // namespace game
