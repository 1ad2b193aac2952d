#pragma once

#include "tests/extremes/any_scene/placement.h"

namespace any_scene {

/// Adds one to three things that a gentle scene lacks: overlaps, kinematic bodies that move or hold, drags, reels,
/// climbers and speeds up to 100 m/s.
void make_wild(Dice& dice, Scene& scene);

}  // namespace any_scene
