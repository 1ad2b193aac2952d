#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

namespace test_support {

/// A recorded run that goes back some ticks and forward again with the same inputs.
class Rollback {
 public:
  static constexpr int ticks = 8;  ///< back and forward

  /// Loads assets/replays/NAME.replay and its level.
  explicit Rollback(const std::string& name);

  /// What differs from the run that did not go back, after the ticks forward.
  struct Difference {
    bool same_bits = false;  ///< hashes of the game, of all cords and of all bodies are the same
    double body = 0.0;       ///< m, largest distance of the positions of a body
    double cord = 0.0;       ///< m, the same of a point of a cord
    double us = 0.0;         ///< time back and forward, with a save in each tick
    std::string first;       ///< the first part that differs, in words
  };
  /// Runs from the start to `tick`, goes back and forward. Nothing if the player restarted the level in these ticks.
  std::optional<Difference> go_back(int tick);

  /// Lets bodies fall asleep, or not; initially true. It takes effect at the start of a run.
  void allow_sleep(bool allowed) { allows_sleep_ = allowed; }
  /// The number of points of all cords at the last tick.
  int points() const;
  /// The number of ticks of the run.
  int size() const { return static_cast<int>(replay_.ticks.size()); }

  /// Runs from the start to `tick`, for back_and_forward.
  void seek(int tick);
  /// Goes back and forward. Returns false if the level was restarted in these ticks.
  bool back_and_forward();

 private:
  game::SavedTick& saved(int tick) { return ring_[static_cast<std::size_t>(tick) % ring_.size()]; }
  void run(int to);

  engine::Replay replay_;
  game::Level level_;
  std::optional<game::Simulation> simulation_;
  bool allows_sleep_ = true;
  int tick_ = 0;
  std::array<game::SavedTick, ticks + 2> ring_;  // before each of the last ticks, and now
};

/// The names of the recorded runs in the assets folder, sorted.
std::vector<std::string> recorded_runs();

}  // namespace test_support
