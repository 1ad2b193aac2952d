#pragma once

#include <string>

#include "game/simulation/level.h"

namespace test_support {

/// The map of first_swing with the thesis's solver for its hanging cords and a player that they can carry; the hammock
/// keeps the direct solver.
std::string mixed_swing_map();
game::Level mixed_swing();

}  // namespace test_support
