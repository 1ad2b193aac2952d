#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/simulation/run.h"
#include "game/simulation/simulation.h"

namespace game {

/// A run with what the options ask for around it: the inputs come from the replay if there is one, each tick is held
/// against it if it is to be verified, and each is recorded as it happens.
class RecordedRun {
 public:
  /// Loads the replay and the level. Throws engine::ReplayError or engine::MapError: a file that is none, or a replay
  /// of another level or of other settings.
  explicit RecordedRun(const RunOptions& options);
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  const Simulation& simulation() const { return *simulation_; }
  const Level& level() const { return level_; }
  /// Has the next ticks, until a restart, estimate their errors, or not: see ribbon::box2d::Coupling::estimate_errors.
  void estimate_errors(bool wanted) { simulation_->scene().coupling().estimate_errors(wanted); }
  /// Is called around each step of the cords from now on, those of a seek too: Simulation::watch. Outlives the run.
  void watch(ribbon::box2d::StepWatcher* watcher);
  /// Moves the cords side by side from now on: Simulation::use.
  void use(const ribbon::ParallelFor& parallel_for);
  bool has_replay() const { return replay_.has_value(); }
  /// True when the replay has ended, or has differed while being verified. Never without a replay.
  bool is_over() const;

  /// Opens the recording, if there is to be one. It empties what the file held before, so it comes last, when nothing
  /// else can keep the run from starting; before the first tick. Throws engine::ReplayError if it cannot be written.
  void start_recording();

  /// The level begins anew: another run, with a recording of its own (empty: none), after finish() of the one before.
  /// Only without a replay. Throws as start_recording does; the run has begun all the same.
  void begin(const std::string& record_path);

  /// One tick, with the replay's input if there is one and with `input` otherwise. Only while the run is not over.
  /// Throws engine::ReplayError once if the recording cannot be written; the run goes on without it.
  void tick(const engine::TickInput& input);

  /// Has the run go on among other settings than its level's: whoever changes its simulation asks for it here. It is
  /// tuned from then on, and a recording ends with the ticks before. Not for a replay. Throws engine::ReplayError once
  /// if the recording cannot be completed.
  Simulation& tune();
  bool is_tuned() const { return is_tuned_; }
  bool level_is_tuned() const { return level_is_tuned_; }
  /// What a run begins with from now on: the level with other settings than its file, `tuned`, or that file anew. The
  /// recording ends as by tune().
  void set_level(Level level, bool tuned);

  /// Goes to the state after `tick` ticks of the replay, forwards by running them without looking at them, backwards by
  /// running them from the start; a simulation() taken before stays the one of the run. Throws engine::ReplayError, and
  /// changes nothing, without a replay, for a tick that is not in it, and for a run that is verified or recorded.
  void seek(int tick);

  /// Completes the recording. Throws engine::ReplayError if that cannot be written.
  void finish();

  /// What to say at the end: the verification's result, or the hash of the last state.
  std::string closing_line() const;
  int exit_status() const;

 private:
  void end_recording();
  void make_simulation();

  std::string record_path_;  // empty: no recording
  std::optional<engine::Replay> replay_;
  Level level_;
  std::optional<Simulation> simulation_;
  ribbon::box2d::StepWatcher* watcher_ = nullptr;
  ribbon::ParallelFor parallel_for_;
  std::size_t next_ = 0;  // tick of the replay
  bool is_tuned_ = false;
  bool level_is_tuned_ = false;
  std::optional<engine::ReplayVerifier> verifier_;
  std::optional<engine::ReplayWriter> writer_;
};

}  // namespace game
