#pragma once

#include <optional>
#include <string>

namespace game {

/// The slowest times that still get them, s; 0 where there are none.
struct Medals {
  double gold = 0.0;
  double silver = 0.0;
  double bronze = 0.0;
};

enum class Medal { none, bronze, silver, gold };

/// For a run of so many ticks.
Medal medal_for(int ticks, const Medals& medals);

/// "Gold"; empty for none.
std::string medal_title(Medal medal);

}  // namespace game
