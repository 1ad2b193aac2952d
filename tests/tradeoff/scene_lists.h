#pragma once

#include <vector>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

std::vector<Scene> thesis_scenes();     ///< the thesis's step with the banded solve and with a dense inverse
std::vector<Scene> swing_scenes();      ///< a heavy load on a rope: the direct solver against others' methods
std::vector<Scene> reference_scenes();  ///< the direct solver against exact solutions
std::vector<Scene> lamp_scenes();       ///< the cost of cords at rest
std::vector<Scene> cost_scenes();       ///< the cost of long cords, ribbons and many cords
std::vector<Scene> tie_scenes();        ///< cords that are tied
std::vector<Scene> pulley_scenes();     ///< cords around wheels
std::vector<Scene> wind_scenes();       ///< cords in a medium
std::vector<Scene> scale_scenes();      ///< the cost of large worlds and a thousand cords
std::vector<Scene> guide_scenes();      ///< the cost of each term, and the effect of more links
std::vector<Scene> back_scenes();       ///< the cost of saving, restoring and going back

/// Cords that touch: the direct solver in a Box2D world against Box2D's own chains.
Scene thesis_trade_scene();
std::vector<Scene> contact_scenes();

}  // namespace tradeoff
