#pragma once

#include <optional>

namespace game {

/// Settings that make a run easier. They change the run, so replays record them; maps do not have them.
struct Assists {
  static constexpr double long_grab_range = 1.6;  ///< m, of the option "Longer reach"

  std::optional<double> grab_range{};  ///< m, replaces PlayerTuning::grab_range
  bool no_fall = false;                ///< after a fall the player returns to the last foothold; it is not counted

  bool any() const { return grab_range || no_fall; }
};

}  // namespace game
