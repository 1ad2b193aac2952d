#pragma once

#include <vector>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

std::vector<Scene> thesis_scenes();     ///< the thesis's step with the banded solve and with a dense inverse
std::vector<Scene> swing_scenes();      ///< a heavy load on a rope: the direct solver against others' methods
std::vector<Scene> reference_scenes();  ///< the direct solver against exact solutions
std::vector<Scene> lamp_scenes();       ///< what cords at rest cost
std::vector<Scene> cost_scenes();       ///< what long cords, ribbons and many of them cost
std::vector<Scene> scale_scenes();      ///< what large worlds and a thousand cords cost
std::vector<Scene> guide_scenes();      ///< what each term of the model costs, and what more links bring

/// Cords that touch: the direct solver in a Box2D world against Box2D's own chains.
Scene thesis_trade_scene();
std::vector<Scene> contact_scenes();

}  // namespace tradeoff
