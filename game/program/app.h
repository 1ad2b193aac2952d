#pragma once

#include <cstdint>

#include "engine/replay/flight_recorder.h"
#include "engine/window/sdl_window.h"
#include "game/program/film.h"
#include "game/program/saved_files.h"
#include "game/screens/menu_input.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/run.h"

namespace game {

class PlayScreen;

/// The program in a window: settings, window and screens. The caller runs its frames one at a time.
class App {
 public:
  /// Opens the run that the options ask for, or the title screen. Throws like run_in_window.
  explicit App(const RunOptions& options);
  App(const App&) = delete;
  App& operator=(const App&) = delete;
  ~App();

  /// Runs one frame: polls, updates, draws and presents. `elapsed_ns`: the time since the last frame. Returns false at
  /// the end of the game.
  bool frame(std::int64_t elapsed_ns);
  /// The parts of a frame, for input from elsewhere. update() returns false at the end of the game.
  bool update(const engine::WindowInput& input, std::int64_t elapsed_ns);
  void draw();

  /// Completes all recordings, before an end by an error.
  void save_recordings() { screens_.leave(); }
  /// Prints the result and returns the exit status.
  int finish();

  engine::Window& window() { return window_; }
  Session& session() { return session_; }
  const ScreenStack& screens() const { return screens_; }

 private:
  bool update_part(const engine::WindowInput& input, std::int64_t elapsed_ns);
  double text_scale() const;
  void apply_settings();
  void handle_keys(const engine::WindowInput& input);
  void report_gamepads(const engine::WindowInput& input);
  void report_sound_errors();
  void save_screenshot();
  void record_frame();

  RunOptions options_;
  std::unique_ptr<engine::FlightRecorder> bad_ticks_;  // null unless requested
  Session session_;
  std::unique_ptr<PlayScreen> first_run_;  // until the window is open
  std::unique_ptr<Screen> first_lab_;      // the same
  PlayScreen* direct_;                     // the run that the command line requested, or null
  engine::Window window_;
  ScreenStack screens_;
  MenuReader menu_reader_;
  bool is_fullscreen_ = false;
  std::string title_;
  bool wants_screenshot_ = false;
  SavedFiles screenshots_;
  Film film_;
  bool wants_film_ = false;    // to start or stop
  std::int64_t drawn_ns_ = 0;  // since the last frame that was drawn
};

}  // namespace game
