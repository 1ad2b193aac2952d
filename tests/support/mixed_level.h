#pragma once

#include <string>

#include "game/simulation/level.h"

namespace test_support {

/// The map of first_swing with its hanging cords moved by the thesis's solver, and a player whom they carry; its
/// hammock stays with the direct one.
std::string mixed_swing_map();
game::Level mixed_swing();

}  // namespace test_support
