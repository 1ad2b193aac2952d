#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/files/file_watch.h"
#include "engine/tick/tick.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/settings/controls.h"
#include "game/simulation/ghost.h"
#include "game/simulation/meter.h"
#include "game/simulation/recorded_run.h"
#include "game/tuning/tuning_panel.h"
#include "game/view/view.h"

namespace game {

/// A run that is played or watched.
class PlayScreen : public Screen {
 public:
  static constexpr int status_recording_failed = 2;

  /// `direct`: the command line asked for this run, and the program ends with it. Throws as RecordedRun does.
  PlayScreen(Session& session, const RunOptions& options, bool direct);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  void draw_below(engine::Canvas& canvas, double text_scale) override;
  void leave() override;
  std::string title() const override;

  /// Stops, and runs one tick.
  void step();
  /// The level begins anew, at once.
  void restart();
  /// This run is not one for medals: something besides the player's keys moves what is in it.
  void mark_assisted() { assisted_ = true; }

  const Simulation& simulation() const { return run_.simulation(); }
  const RunOptions& options() const { return options_; }
  const RecordedRun& run() const { return run_; }
  bool is_direct() const { return direct_; }
  bool is_assisted() const { return assisted_; }
  /// The recording of the present run; empty: there is none of it alone.
  const std::string& own_recording() const { return recording_; }
  /// True when there is no more to run: the end of a replay, or of the ticks that were asked for.
  bool is_over() const;
  /// True when the program was asked to end by then.
  bool ends_program() const { return direct_ && is_over() && (options_.ticks || options_.verify); }
  int exit_status() const { return recording_failed_ ? status_recording_failed : run_.exit_status(); }

 private:
  /// A replay or a number of ticks: it has no menus.
  bool is_plain() const { return run_.has_replay() || options_.ticks; }
  /// Each run has a recording of its own, in the player's folder.
  bool keeps_runs() const { return !is_plain() && options_.record.empty(); }
  void begin_run();
  Next play(const Frame& frame);
  void obey_keys(const Frame& frame);
  void follow_file(std::int64_t elapsed_ns);
  bool wants_pause(const Frame& frame) const;
  int ticks_to_run(const Frame& frame);
  void tick();
  bool is_won() const;
  void advance_ghost(int ticks);
  void finish_recording();
  void say_that_recording_failed(const engine::ReplayError& error);
  void choose_message();
  void draw_run(engine::Canvas& canvas, double text_scale, bool help);

  Session* session_;
  RunOptions options_;
  bool direct_;
  RecordedRun run_;
  View view_;
  Meter meter_;
  TuningPanel panel_;
  std::optional<engine::FileWatch> level_file_;  // none: of a replay
  ViewOptions view_options_;
  Controls controls_;
  engine::FixedTick clock_{ticks_per_second};
  std::unique_ptr<Ghost> ghost_;
  std::vector<std::string> keys_;
  std::string recording_;
  bool started_ = false;
  bool stopped_ = false;  // goes on by single ticks
  bool won_ = false;      // and the player was told
  bool assisted_ = false;
  int slowed_ = 1;  // times
  bool restart_wanted_ = false;
  bool recording_failed_ = false;
};

}  // namespace game
