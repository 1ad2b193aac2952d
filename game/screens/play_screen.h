#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/files/file_watch.h"
#include "engine/tick/tick.h"
#include "game/screens/hint.h"
#include "game/screens/race.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/settings/controls.h"
#include "game/simulation/meter.h"
#include "game/simulation/recorded_run.h"
#include "game/tuning/tuning_panel.h"
#include "game/view/view.h"

namespace game {

/// The screen of a run that is played, or of a replay.
class PlayScreen : public Screen {
 public:
  static constexpr int status_recording_failed = 2;

  /// `direct`: the command line requested this run, and the program ends with it. Throws like RecordedRun.
  PlayScreen(Session& session, const RunOptions& options, bool direct);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  void draw_below(engine::Canvas& canvas, double text_scale) override;
  void leave() override;
  bool shows_notice() const override { return true; }
  std::string title() const override;
  Tune tune() const override { return stopped_ ? Tune::none : tune_of(run_.level()); }

  /// Stops the run and runs one tick.
  void step();
  /// Restarts the level.
  void restart();
  /// Returns whether things can be placed in this run: it is of a sandbox, and no replay.
  bool can_build() const { return run_.level().sandbox && !is_plain(); }
  /// Begins a run that stands still, from where the player is, to build() its yard. Precondition: can_build().
  void begin_building();
  /// Begins it again with another yard.
  void build(const Yard& yard);
  /// Begins the run that is played, and recorded, with that yard.
  void end_building();
  /// Marks the run as assisted: it earns no medal.
  void mark_assisted() { assisted_ = true; }

  /// The side of the canvas, −1 left or 1 right, at which a card does not cover the player.
  double free_side(const engine::Canvas& canvas) const;

  const Simulation& simulation() const { return run_.simulation(); }
  const RunOptions& options() const { return options_; }
  const RecordedRun& run() const { return run_; }
  const Race& race() const { return race_; }
  bool is_direct() const { return direct_; }
  bool is_assisted() const { return assisted_; }
  /// The path of the recording of the current run; empty if it has none of its own.
  const std::string& own_recording() const { return recording_; }
  /// True at the end of a replay, or after the number of ticks of the options.
  bool is_over() const;
  /// True if the program should end now.
  bool ends_program() const { return direct_ && is_over() && (options_.ticks || options_.verify); }
  int exit_status() const { return recording_failed_ ? status_recording_failed : run_.exit_status(); }

 private:
  /// True for a replay or a number of ticks, which have no menus.
  bool is_plain() const { return run_.has_replay() || options_.ticks; }
  /// True if each run has a recording of its own in the player's folder.
  bool records_runs() const { return !is_plain() && options_.record.empty(); }
  void begin_run();
  Next play(const Frame& frame);
  void take_controls(const engine::WindowInput& input, ribbon::Vec2 mouse);
  engine::TickInput next_input();
  void handle_keys(const Frame& frame);
  void reload_if_changed(std::int64_t elapsed_ns);
  bool wants_pause(const Frame& frame) const;
  int ticks_to_run(const Frame& frame);
  void tick();
  bool is_won() const;
  void finish_recording();
  void report_recording_failure(const engine::ReplayError& error);
  void choose_message();
  void fill_hud(const engine::Canvas& canvas, double text_scale);
  void draw_run(engine::Canvas& canvas, double text_scale, bool with_hud);

  Session* session_;
  RunOptions options_;
  bool direct_;
  RecordedRun run_;
  View view_;
  Meter meter_;
  TuningPanel panel_;
  std::optional<engine::FileWatch> level_file_;  // not for replays
  ViewOptions view_options_;
  Controls controls_;
  Controls second_controls_;  // in a level for two
  engine::FixedTick clock_{ticks_per_second};
  Race race_;
  std::vector<std::string> keys_;
  std::string notice_;
  Hint hint_;
  std::string recording_;
  bool started_ = false;
  bool stopped_ = false;  // runs single ticks only
  bool won_ = false;      // and the results were shown
  bool assisted_ = false;
  int slowed_ = 1;  // the factor of slow motion
  bool restart_wanted_ = false;
  bool recording_failed_ = false;
};

}  // namespace game
