#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/simulation/run.h"
#include "game/simulation/simulation.h"

namespace game {

/// A run with its options: inputs from a replay, verification of each tick against it, and a recording.
class RecordedRun {
 public:
  /// Loads the replay and the level. Throws engine::ReplayError or engine::MapError for an invalid file, or a replay of
  /// another level or with other settings.
  explicit RecordedRun(const RunOptions& options);
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  const Simulation& simulation() const { return *simulation_; }
  const Level& level() const { return level_; }
  /// Switches error estimates on or off until a restart: see ribbon::box2d::Coupling::estimate_errors.
  void estimate_errors(bool wanted) { simulation_->scene().coupling().estimate_errors(wanted); }
  /// Calls the watcher around each step of the cords, also during seek(): see Simulation::watch. It must outlive the
  /// run.
  void watch(ribbon::box2d::StepWatcher* watcher);
  /// Steps the cords in parallel: see Simulation::use.
  void use(const ribbon::ParallelFor& parallel_for);
  bool has_replay() const { return replay_.has_value(); }
  /// True after the replay has ended, or differed during verification. Always false without a replay.
  bool is_over() const;

  /// Opens the recording, if the options have one, and overwrites the file. Call it after everything else that may
  /// fail, before the first tick. Throws engine::ReplayError if the file cannot be written.
  void start_recording();

  /// Restarts the level with a recording of its own (empty: none). Call finish() before. Only without a replay. Throws
  /// like start_recording; the run is restarted then too.
  void begin(const std::string& record_path);

  /// Runs one tick with the input of the replay if there is one, else with `input`. Precondition: not is_over(). Throws
  /// engine::ReplayError once if the recording cannot be written; the run continues without it.
  void tick(const engine::TickInput& input);

  /// Returns the simulation for changes of its parameters. Marks the run as tuned and ends the recording before this
  /// tick. Not for a replay. Throws engine::ReplayError once if the recording cannot be completed.
  Simulation& tune();
  bool is_tuned() const { return is_tuned_; }
  bool level_is_tuned() const { return level_is_tuned_; }
  /// Sets the level of the following runs. `tuned`: it differs from its file. Ends the recording like tune().
  void set_level(Level level, bool tuned);

  /// Goes to the state after `tick` ticks of the replay: forwards by running ticks without snapshots, backwards by
  /// running from the start. References to simulation() stay valid. Throws engine::ReplayError, without a change, if
  /// there is no replay, the tick is not in it, or the run is verified or recorded.
  void seek(int tick);

  /// The inputs of all ticks since the start of the run.
  std::vector<engine::TickInput> inputs() const;
  /// Returns whether a new run of level() with these inputs is the same: nothing was tuned, and the level not replaced,
  /// since the start.
  bool can_be_repeated() const { return can_be_repeated_; }

  /// Completes the recording. Throws engine::ReplayError if it cannot be written.
  void finish();

  /// Returns the last line of output: the result of the verification, or the hash of the last state.
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
  std::size_t next_ = 0;                   // tick of the replay
  std::vector<engine::TickInput> inputs_;  // without a replay
  bool can_be_repeated_ = true;
  bool is_tuned_ = false;
  bool level_is_tuned_ = false;
  std::optional<engine::ReplayVerifier> verifier_;
  std::optional<engine::ReplayWriter> writer_;
};

}  // namespace game
