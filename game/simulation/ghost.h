#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"
#include "game/simulation/splits.h"

namespace game {

/// The player of an earlier run at one tick.
struct GhostPose {
  ribbon::Vec2 at;        ///< m, the centre of the body
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = true;
  std::optional<ribbon::Vec2> held{};  ///< m, the held position on a cord
};

/// The track of the player, or of both players, of an earlier run. The run is simulated again, some ticks in each
/// frame.
class Ghost {
 public:
  /// Ticks that it is simulated ahead, to have poses for frames that take long.
  static constexpr int max_lead = 120;

  /// Loads a recording of that level, with any assists. Throws engine::ReplayError if it cannot be read or is of
  /// another level.
  static std::unique_ptr<Ghost> open(const std::string& path, const Level& level);
  /// The same, but returns null if there is no recording or it does not fit.
  static std::unique_ptr<Ghost> load(const std::string& path, const Level& level);

  /// Simulates one more tick, unless it is max_lead ticks ahead of `run_tick`, at the end, or differs from the
  /// recording. Returns whether it did.
  bool advance(int run_tick);
  /// Simulates one more tick, as far ahead as one likes. Returns false at the end, or if it differs from the recording.
  bool advance_far();
  /// The splits of the run, as far as it is simulated.
  const Splits& splits() const { return splits_.splits(); }
  /// Returns the pose of a player at a tick; nothing after the end, before it is simulated, or of a player that the run
  /// does not have.
  std::optional<GhostPose> at(int run_tick, int player = 0) const;

 private:
  Ghost(engine::Replay replay, Level level);
  using Poses = std::array<GhostPose, 2>;  // the second one is unused in a run of one
  Poses poses() const;

  engine::Replay replay_;
  Level level_;
  Simulation simulation_;
  SplitTimer splits_;
  std::vector<Poses> track_;  // by tick, from 0
};

}  // namespace game
