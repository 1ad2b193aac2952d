#pragma once

#include <cstdint>

#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace test_support {

/// Returns the level first_swing, loaded once.
const game::Level& first_swing();

/// Plays first_swing as a person would, from what is on screen: runs, jumps to the first cord, pumps, lets go on the
/// way up, catches the next, lands before the hammock, and walks to the goal. It keeps recorded runs renewable when the
/// physics changes.
class Autopilot {
 public:
  /// The buttons for the next tick.
  std::uint16_t buttons(const game::Simulation& simulation);

 private:
  std::uint16_t hang(const game::Simulation& simulation, const ribbon::box2d::CordPoint& held);
  std::uint16_t fly_or_run(const game::Simulation& simulation) const;

  int last_cord_ = -1;
  int ticks_on_cord_ = 0;
};

}  // namespace test_support
