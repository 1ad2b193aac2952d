#pragma once

#include <string>

#include "game/simulation/level.h"

namespace game {

enum class Medal { none, bronze, silver, gold };

/// What a level's medals are for, as shares of the time of its recorded winning run: who plays as well as the script
/// has a quarter to spare for gold, and who just gets there earns bronze. Rounded up to half a second, as players read
/// them.
struct MedalRule {
  double gold = 1.25;
  double silver = 2.0;
  double bronze = 4.0;
  double step = 0.5;  ///< s
};
/// By that rule, of a run that reached the goal after so many ticks.
Medals medals_by_rule(int winning_ticks, const MedalRule& rule = {});

/// For a run of so many ticks.
Medal medal_for(int ticks, const Medals& medals);

/// The most ticks that a run within so many seconds has.
int ticks_in(double seconds);

/// "Gold"; empty for none.
std::string medal_title(Medal medal);

}  // namespace game
