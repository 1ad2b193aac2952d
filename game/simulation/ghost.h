#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/simulation.h"

namespace game {

/// Somebody who ran here before, at this moment of the run.
struct GhostPose {
  ribbon::Vec2 at;        ///< m, the middle of the body
  ribbon::Vec2 velocity;  ///< m/s
  bool faces_left = false;
  bool on_ground = true;
  std::optional<ribbon::Vec2> held{};  ///< m, the place of a cord that the hands hold
};

/// Where the player of an earlier run was in each of its ticks: the run is simulated again, a little in every frame.
class Ghost {
 public:
  /// How far it goes ahead, so that a frame that takes long finds it there, ticks.
  static constexpr int ahead = 120;

  /// Of a recording of that level, with whatever assists. None if there is no recording, or it is of something else.
  static std::unique_ptr<Ghost> load(const std::string& path, const Level& level);

  /// One tick further, unless it is `ahead` of the run's tick already, has come to the end, or is no longer what was
  /// recorded. True if it went on.
  bool advance(int run_tick);
  /// None where there is none (any more), or not yet.
  std::optional<GhostPose> at(int run_tick) const;

 private:
  Ghost(engine::Replay replay, Level level);
  GhostPose pose() const;

  engine::Replay replay_;
  Level level_;
  Simulation simulation_;
  std::vector<GhostPose> track_;  // after so many ticks
};

}  // namespace game
