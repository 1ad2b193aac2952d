#include "game/simulation/medals.h"

#include <cmath>

#include "game/simulation/simulation.h"

namespace game {

Medals medals_by_rule(int winning_ticks, const MedalRule& rule) {
  const auto of = [&](double factor) {
    return rule.step * std::ceil(factor * winning_ticks / (ticks_per_second * rule.step));
  };
  return {of(rule.gold), of(rule.silver), of(rule.bronze)};
}

Medal medal_for(int ticks, const Medals& medals) {
  const double seconds = static_cast<double>(ticks) / ticks_per_second;
  // The limit of a medal that the level does not have is 0 s.
  if (seconds <= medals.gold) return Medal::gold;
  if (seconds <= medals.silver) return Medal::silver;
  return seconds <= medals.bronze ? Medal::bronze : Medal::none;
}

int ticks_in(double seconds) { return static_cast<int>(std::floor(seconds * ticks_per_second)); }

}  // namespace game
