#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/files/file_watch.h"
#include "game/screens/hint.h"
#include "game/screens/pace.h"
#include "game/screens/played_run.h"
#include "game/screens/race.h"
#include "game/screens/run_input.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/meter.h"
#include "game/tuning/tuning_panel.h"
#include "game/view/view.h"

namespace game {

/// The screen of a run that is played, or of a replay.
class PlayScreen : public Screen {
 public:
  /// `direct`: the command line requested this run, and the program ends with it. Throws like RecordedRun.
  PlayScreen(Session& session, const RunOptions& options, bool direct);

  void shown() override;
  Next update(const Frame& frame) override;
  void draw(engine::Canvas& canvas, double text_scale) override;
  void draw_below(engine::Canvas& canvas, double text_scale) override;
  void leave() override;
  bool shows_notice() const override { return true; }
  std::string title() const override;
  Tune tune() const override { return pace_.is_stopped() ? Tune::none : tune_of(run().level()); }

  /// Stops the run and runs one tick.
  void step();
  /// Restarts the level.
  void restart();
  /// Begins the run that is played, and recorded, with the yard that was built.
  void end_building();

  /// The side of the canvas, −1 left or 1 right, at which a card does not cover the player.
  double free_side(const engine::Canvas& canvas) const;

  const PlayedRun& played() const { return played_; }
  PlayedRun& played() { return played_; }
  const RecordedRun& run() const { return played_.run(); }
  const Simulation& simulation() const { return run().simulation(); }
  const Race& race() const { return race_; }
  bool is_over() const { return played_.is_over(); }

 private:
  void begin_run();
  Next play(const Frame& frame);
  void handle_keys(const Frame& frame);
  void reload_if_changed(std::int64_t elapsed_ns);
  bool wants_pause(const Frame& frame) const;
  int ticks_to_run(const Frame& frame);
  void tick();
  bool is_won() const;
  void choose_keys();
  void fill_hud(const engine::Canvas& canvas, double text_scale);
  void draw_run(engine::Canvas& canvas, double text_scale, bool with_hud);

  Session* session_;
  PlayedRun played_;
  View view_;
  Meter meter_;
  TuningPanel panel_;
  std::optional<engine::FileWatch> level_file_;  // not for replays
  ViewOptions view_options_;
  RunInput input_;
  Pace pace_;
  Race race_;
  std::vector<std::string> keys_;
  std::string notice_;
  Hint hint_;
  bool started_ = false;
  bool won_ = false;  // and the results were shown
  bool restart_wanted_ = false;
};

}  // namespace game
