#pragma once

#include <string>

#include "game/screens/session.h"
#include "game/simulation/recorded_run.h"
#include "game/simulation/yard.h"

namespace game {

/// The run that a screen plays, with its recording, and whether it counts. It reports to the session what fails.
class PlayedRun {
 public:
  static constexpr int status_recording_failed = 2;

  /// `direct`: the command line requested this run, and the program ends with it. Throws like RecordedRun.
  PlayedRun(Session& session, const RunOptions& options, bool direct);

  const RecordedRun& run() const { return run_; }
  RecordedRun& run() { return run_; }
  const RunOptions& options() const { return options_; }
  bool is_direct() const { return direct_; }
  /// True for a replay or a number of ticks, which have no menus.
  bool is_plain() const { return run_.has_replay() || options_.ticks; }
  /// True if each run has a recording of its own in the player's folder.
  bool records_runs() const { return !is_plain() && options_.record.empty(); }
  /// The path of the recording of the current run; empty if it has none of its own.
  const std::string& own_recording() const { return recording_; }
  bool recording_failed() const { return recording_failed_; }
  /// True at the end of a replay, or after the number of ticks of the options.
  bool is_over() const;
  /// True if the program should end now.
  bool ends_program() const { return direct_ && is_over() && (options_.ticks || options_.verify); }
  int exit_status() const { return recording_failed_ ? status_recording_failed : run_.exit_status(); }

  bool is_assisted() const { return assisted_; }
  /// Marks the run as assisted: it earns no medal. `assisted` false: it begins again.
  void mark_assisted(bool assisted = true) { assisted_ = assisted; }
  /// Notices that the run was tuned: it counts no more.
  void notice_tuning();

  /// Begins the first run, with the recording of the options. Not for one that records_runs().
  void start() { run_.start_recording(); }
  /// Begins a new run with a recording of its own.
  void begin();
  void tick(const engine::TickInput& input);
  /// Sets the level of the following runs: RecordedRun::set_level.
  void set_level(Level level, bool tuned);
  /// Completes the recording.
  void finish();

  /// Returns whether things can be placed in this run: it is of a sandbox, and no replay.
  bool can_build() const { return run_.level().sandbox && !is_plain(); }
  /// Begins a run that stands still, from where the player is, to build() its yard. Precondition: can_build().
  void begin_building();
  /// Begins it again with another yard.
  void build(const Yard& yard);

 private:
  void report_failure(const engine::ReplayError& error);

  Session* session_;
  RunOptions options_;
  bool direct_;
  RecordedRun run_;
  std::string recording_;
  bool assisted_ = false;
  bool recording_failed_ = false;
};

}  // namespace game
