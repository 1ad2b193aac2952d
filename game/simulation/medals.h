#pragma once

#include "game/simulation/level.h"

namespace game {

enum class Medal { none, bronze, silver, gold };

/// The medal limits of a level as factors of the time of its recorded winning run, rounded up to `step`.
struct MedalRule {
  double gold = 1.25;
  double silver = 2.0;
  double bronze = 4.0;
  double step = 0.5;  ///< s
};
/// Returns the limits for a winning run that reached the goal after `winning_ticks`.
Medals medals_by_rule(int winning_ticks, const MedalRule& rule = {});

/// Returns the medal of a run of `ticks` ticks.
Medal medal_for(int ticks, const Medals& medals);

/// Returns the number of whole ticks in `seconds`.
int ticks_in(double seconds);

}  // namespace game
