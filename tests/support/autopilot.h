#pragma once

#include <cstdint>

#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace test_support {

/// Returns the level first_swing, loaded once.
const game::Level& first_swing_level();

/// Plays first_swing by what is on screen: runs, jumps to the first cord, pumps, releases while rising, catches the
/// next cord, lands before the hammock, and walks to the goal. With it recordings can be renewed when the physics
/// changes.
class Autopilot {
 public:
  /// Returns the buttons for the next tick.
  std::uint16_t buttons(const game::Simulation& simulation);

 private:
  std::uint16_t hang(const game::Simulation& simulation, const ribbon::box2d::CordPoint& held);
  std::uint16_t fly_or_run(const game::Simulation& simulation) const;

  int last_cord_ = -1;
  int ticks_on_cord_ = 0;
};

}  // namespace test_support
