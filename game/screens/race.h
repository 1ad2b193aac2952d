#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "game/screens/session.h"
#include "game/simulation/ghost.h"
#include "game/simulation/level.h"
#include "game/simulation/splits.h"
#include "game/view/view.h"

namespace game {

/// What a run is compared with: a given recording, or else the best run. It has a ghost and splits.
class Race {
 public:
  /// `rival`: the path of a recording; empty: the best run. The session must outlive it.
  Race(Session& session, std::string rival) : session_(&session), rival_(std::move(rival)) {}

  /// Throws engine::ReplayError if the given recording cannot be read or is of another level.
  void check(const Level& level) const;
  /// Begins a new run of the level. Reports it if the given recording is not of that level any more.
  void begin(const Level& level);
  /// Call it after each tick of the run.
  void tick(const Simulation& simulation);
  /// Advances the ghost by the ticks of the run, and further while there is time.
  void advance(int ticks, int run_tick);

  /// The pose of the ghost; nothing if it is switched off.
  std::optional<GhostPose> ghost_at(int run_tick, int player = 0) const;
  /// The splits of this run, and those that it is compared with; empty: not known.
  const Splits& splits() const { return timer_.splits(); }
  const Splits& reference() const { return reference_; }
  /// The time at the checkpoint that the run has just entered, or null.
  const SplitMessage* message() const { return message_ticks_ > 0 ? &message_ : nullptr; }

 private:
  void find_reference(std::int64_t end_ns);

  Session* session_;
  std::string rival_;
  LevelKey level_;
  std::unique_ptr<Ghost> ghost_;
  std::unique_ptr<Ghost> scout_;  // runs far ahead to find the splits, or null
  Splits reference_;
  SplitTimer timer_;
  SplitMessage message_;
  int message_ticks_ = 0;  // for which it is still shown
};

}  // namespace game
