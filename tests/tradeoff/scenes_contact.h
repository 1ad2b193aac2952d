#pragma once

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

// One file per scene.
Scene mass_ratio_scene();
Scene drape_scene();
Scene bridge_scene();
Scene capstan_scene();
Scene cords_and_circles_scene();
Scene coil_scene();
Scene tightened_coil_scene();
Scene strips_scene();
// Shorter versions for the standard report:
Scene short_coil_scene();
Scene short_strips_scene();

}  // namespace tradeoff
