#pragma once

#include <cstdint>

#include "engine/replay/flight_recorder.h"
#include "engine/window/sdl_window.h"
#include "game/program/film.h"
#include "game/screens/menu_input.h"
#include "game/screens/screen.h"
#include "game/screens/session.h"
#include "game/simulation/run.h"

namespace game {

class PlayScreen;

/// The program in a window: settings, window, and the screens in it. Its loop is callable a frame at a time.
class App {
 public:
  /// Goes straight into play if the options ask for anything, else to the title. Throws as run_in_window does.
  explicit App(const RunOptions& options);
  App(const App&) = delete;
  App& operator=(const App&) = delete;
  ~App();

  /// What happened since the last frame, so long ago, is obeyed, drawn and shown. False at the end of the game.
  bool frame(std::int64_t elapsed_ns);
  /// The parts of a frame: input may come from elsewhere.
  bool update(const engine::WindowInput& input, std::int64_t elapsed_ns);
  void draw();

  /// Completes the recordings of runs that cannot go on.
  void save_recordings() { screens_.leave(); }
  /// Says how it ended; the exit status.
  int finish();

  engine::Window& window() { return window_; }
  Session& session() { return session_; }
  const ScreenStack& screens() const { return screens_; }

 private:
  double text_scale() const;
  void follow_settings();
  void obey_keys(const engine::WindowInput& input);
  void notice_pads(const engine::WindowInput& input);
  void tell_of_sounds();
  void take_picture();
  void take_film();

  RunOptions options_;
  std::unique_ptr<engine::FlightRecorder> bad_ticks_;  // if they are asked for
  Session session_;
  std::unique_ptr<PlayScreen> first_run_;  // until there is a window to open it in
  PlayScreen* direct_;                     // the run that the command line asked for, if it did
  engine::Window window_;
  ScreenStack screens_;
  MenuReader menu_reader_;
  bool is_fullscreen_ = false;
  std::string title_;
  bool wants_picture_ = false;
  Film film_;
  bool wants_film_ = false;    // to begin or end
  std::int64_t drawn_ns_ = 0;  // since the frame drawn before
};

}  // namespace game
