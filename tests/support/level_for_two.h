#pragma once

#include "game/simulation/level.h"

namespace test_support {

/// The options of a level for two.
struct LevelForTwo {
  bool tied = true;
  bool knows_checkpoint = false;  ///< one at x = 12 m on the left ground
  double second_mass = 60.0;      ///< kg
};

/// Returns a level of 44 × 14 m: ground up to y = 4 m from x = 0 to 16 and from 26 to 44 m, an abyss between, a round
/// post of 0.5 m at (21, 8), a flag at x = 40. The players stand at x = 8 and 14 m. The rope between them is 7.5 m long
/// and lies on the ground.
game::Level level_for_two(const LevelForTwo& options = {});

}  // namespace test_support
