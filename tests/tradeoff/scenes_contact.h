#pragma once

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

// Each in a file of its own.
Scene mass_ratio_scene();
Scene drape_scene();
Scene bridge_scene();
Scene capstan_scene();
Scene cords_and_circles_scene();
Scene coil_scene();
Scene strips_scene();
// As the standard report runs them, for it has minutes and not an hour:
Scene short_coil_scene();
Scene short_strips_scene();

}  // namespace tradeoff
