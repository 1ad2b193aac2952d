#pragma once

#include <optional>
#include <string>

#include "engine/tick.h"
#include "game/controls.h"
#include "game/meter.h"
#include "game/recorded_run.h"
#include "game/screens/screen.h"
#include "game/session.h"
#include "game/view.h"

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
  void leave() override;

  /// Stops, and runs one tick.
  void step();
  /// The level begins anew, at once.
  void restart();

  const Session& session() const { return *session_; }
  const Simulation& simulation() const { return run_.simulation(); }
  bool is_direct() const { return direct_; }
  /// True when there is no more to run: the end of a replay, or of the ticks that were asked for.
  bool is_over() const;
  /// True when the program was asked to end by then.
  bool ends_program() const { return direct_ && is_over() && (options_.ticks || options_.verify); }
  const RecordedRun& run() const { return run_; }
  int exit_status() const { return recording_failed_ ? status_recording_failed : run_.exit_status(); }

 private:
  void obey_keys(const Frame& frame);
  /// A replay or a number of ticks: it has no menus.
  bool is_plain() const { return run_.has_replay() || options_.ticks; }
  bool wants_pause(const Frame& frame) const;
  int ticks_to_run(const Frame& frame);
  void tick();
  void say_that_recording_failed(const engine::ReplayError& error);

  Session* session_;
  RunOptions options_;
  bool direct_;
  RecordedRun run_;
  View view_;
  Meter meter_;
  ViewOptions view_options_;
  Controls controls_;
  engine::FixedTick clock_{ticks_per_second};
  bool started_ = false;
  bool stopped_ = false;  // goes on by single ticks
  int slowed_ = 1;        // times
  bool restart_wanted_ = false;
  bool recording_failed_ = false;
};

}  // namespace game
