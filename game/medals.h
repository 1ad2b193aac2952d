#pragma once

#include <string>

#include "game/level.h"

namespace game {

enum class Medal { none, bronze, silver, gold };

/// For a run of so many ticks.
Medal medal_for(int ticks, const Medals& medals);

/// The most ticks that a run within so many seconds has.
int ticks_in(double seconds);

/// "Gold"; empty for none.
std::string medal_title(Medal medal);

}  // namespace game
