#pragma once

#include <optional>

namespace game {

/// What makes a run easier by making it another one. Not of the map: replays declare it.
struct Assists {
  static constexpr double long_reach = 1.6;  ///< m, of longer arms

  std::optional<double> player_reach{};  ///< m, from which the hand catches; none: that of PlayerTuning
  bool no_fall = false;                  ///< a fall ends where the player last stood, and does not count

  bool any() const { return player_reach || no_fall; }
};

}  // namespace game
