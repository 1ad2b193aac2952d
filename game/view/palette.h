#pragma once

#include <array>

#include "engine/draw/color.h"
#include "game/simulation/place.h"

namespace game {

inline constexpr engine::Color white{255, 255, 255};

/// The colours of a place. Those of the backdrop are in order from far to near.
struct Palette {
  engine::Color sky_top, sky_middle, horizon, sun, cloud, mist;
  std::array<engine::Color, 4> hills;  ///< or rocks, or coast, quay and water
  engine::Color accent;                ///< crystals of a cave, light on water, lightning
  engine::Color soil;
  int deep_light;  ///< 0 … 255, the brightness of soil some metres below its surface
  engine::Color grass, wood, stone;
  std::array<engine::Color, 3> ropes;    ///< used in turn, so that neighbours differ
  std::array<engine::Color, 4> ribbons;  ///< used in turn
  std::array<engine::Color, 3> balls;
  engine::Color iron, line;
  engine::Color hook, hook_in_range;
  engine::Color banner_down, banner_up, goal;
  engine::Color ink;
  engine::Color figure_rim;  ///< the outline of the player: pale where it is dark
  engine::Color lamp;        ///< the light around the player; alpha 0: none
};

/// Returns the standard palette of a place, or one for red-green colour blindness: hues of Okabe and Ito's palette that
/// also differ in lightness.
const Palette& palette(bool colour_safe, Place place = Place::hills);

/// Returns the colour of a value 0 … 1 in the colour map viridis: dark violet over green to yellow, with perceptually
/// uniform brightness, also for red-green colour blindness.
engine::Color ramp_color(double value);

/// Interpolates linearly; `t` is 0 … 1 for a … b.
engine::Color mix(engine::Color a, engine::Color b, double t);
engine::Color with_alpha(engine::Color color, int alpha);

}  // namespace game
