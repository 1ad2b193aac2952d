#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "engine/sdl_window.h"
#include "engine/tick.h"
#include "game/buttons.h"
#include "game/recorded_run.h"
#include "game/run.h"
#include "game/sounds.h"
#include "game/view.h"

namespace game {
namespace {

using engine::Key;
using engine::MouseButton;
using engine::WindowInput;

constexpr int status_recording_failed = 2;
constexpr int window_width = 1280;
constexpr int window_height = 720;

/// One key state as buttons: `is_down(key)` and `is_down(button)` tell which count as down.
template <typename IsDown>
std::uint16_t buttons_from(IsDown is_down) {
  unsigned buttons = 0;
  if (is_down(Key::left) || is_down(Key::a)) buttons |= button_left;
  if (is_down(Key::right) || is_down(Key::d)) buttons |= button_right;
  if (is_down(Key::space) || is_down(Key::up) || is_down(Key::w)) buttons |= button_jump;
  if (is_down(Key::e) || is_down(Key::shift)) buttons |= button_grab;
  if (is_down(Key::r)) buttons |= button_restart;
  if (is_down(MouseButton::left)) buttons |= button_drag;
  return static_cast<std::uint16_t>(buttons);
}

/// A free name for a picture: ropeswing-1.png, -2.png, …
std::string screenshot_name() {
  for (int number = 1;; ++number) {
    std::string name = "ropeswing-" + std::to_string(number) + ".png";
    if (!std::filesystem::exists(name)) return name;
  }
}

/// The window's loop, callable a frame at a time.
class WindowGame {
 public:
  explicit WindowGame(const RunOptions& options)
      : options_(options), run_(options), view_(run_.simulation()), window_("Rope swing", window_width, window_height) {
    if (options.seek > 0) run_.seek(options.seek);
    view_options_.watching = run_.has_replay();
    view_options_.meter = &meter_;
    if (!sounds_.why_silent().empty()) std::fprintf(stderr, "ropeswing: %s\n", sounds_.why_silent().c_str());
    if (!sounds_.trouble().empty()) view_options_.notice = sounds_.trouble().c_str();
    run_.start_recording();
    last_frame_ns_ = engine::now_ns();
  }

  /// False when the player has left or there is no more to show.
  bool frame() {
    const WindowInput input = window_.poll();
    if (input.quit || input.pressed(Key::escape)) return false;
    obey_keys(input);
    gather_buttons(input);
    const int ticks = ticks_to_run(input);
    for (int k = 0; k < ticks && !is_over(); ++k) tick();
    draw(input);
    window_.present();
    view_options_.over = is_over();
    return !(is_over() && (options_.ticks || options_.verify));
  }

  /// Completes the recording of a run that cannot go on.
  void save_recording() {
    try {
      run_.finish();
    } catch (const engine::ReplayError& error) {
      tell(error);
    }
  }

  int finish() {
    run_.finish();
    if (!options_.screenshot.empty()) {
      window_.save_png(options_.screenshot);
      std::printf("picture of the last moment: %s\n", options_.screenshot.c_str());
    }
    std::puts(run_.closing_line().c_str());
    return recording_failed_ ? status_recording_failed : run_.exit_status();
  }

 private:
  bool is_over() const { return run_.is_over() || (options_.ticks && run_.simulation().ticks() >= *options_.ticks); }

  void obey_keys(const WindowInput& input) {
    if (input.pressed(Key::p)) view_options_.paused = !view_options_.paused;
    if (input.pressed(Key::h)) view_options_.help = !view_options_.help;
    if (input.pressed(Key::f1)) view_options_.debug = !view_options_.debug;
  }

  /// A key tapped between two ticks counts in the next one.
  void gather_buttons(const WindowInput& input) {
    held_ = buttons_from([&](auto key) { return input.held(key); });
    tapped_ = static_cast<std::uint16_t>(tapped_ | buttons_from([&](auto key) { return input.pressed(key); }));
    if (!view_options_.debug) {  // the mouse drags cords in the debug view only
      held_ = static_cast<std::uint16_t>(held_ & ~button_drag);
      tapped_ = static_cast<std::uint16_t>(tapped_ & ~button_drag);
    }
    engine::set_pointer(next_, window_.canvas().to_world(input.mouse));
  }

  int ticks_to_run(const WindowInput& input) {
    const std::int64_t now = engine::now_ns();
    const int due = clock_.advance(now - std::exchange(last_frame_ns_, now));
    if (!view_options_.paused) return due;
    if (input.pressed(Key::n) || input.pressed(Key::r)) return 1;  // a restart shows at once
    tapped_ = 0;  // what was tapped in a pause is not meant for after it
    return 0;
  }

  void tick() {
    next_.buttons = static_cast<std::uint16_t>(held_ | tapped_);
    tapped_ = 0;
    run_.estimate_errors(view_options_.debug && meter_.wants_estimate());
    const std::int64_t begun = engine::now_ns();
    try {
      run_.tick(next_);
    } catch (const engine::ReplayError& error) {  // of the recording, once: play on without it
      tell(error);
      recording_failed_ = true;
      view_options_.notice = "The recording has ended: the file cannot be written";
    }
    meter_.add(run_.simulation(), engine::now_ns() - begun);
    sounds_.hear(run_.simulation());
  }

  void draw(const WindowInput& input) {
    const bool still = view_options_.paused || is_over();
    if (still) sounds_.rest();
    sounds_.keep_open(last_frame_ns_);
    const engine::Canvas& canvas = window_.canvas();
    const double size = std::min(canvas.width() / (1.0 * window_width), canvas.height() / (1.0 * window_height));
    view_options_.text_scale = window_.pixel_scale() * std::clamp(size / window_.pixel_scale(), 0.5, 1.5);
    view_.draw(window_.canvas(), still ? 1.0 : clock_.alpha(), view_options_);
    if (input.pressed(Key::f12)) take_picture();
  }

  void take_picture() {
    try {
      const std::string name = screenshot_name();
      window_.save_png(name);
      std::printf("picture: %s\n", name.c_str());
    } catch (const std::runtime_error& error) {  // no reason to stop playing
      tell(error);
    }
  }

  static void tell(const std::exception& error) { std::fprintf(stderr, "ropeswing: %s\n", error.what()); }

  RunOptions options_;
  RecordedRun run_;
  View view_;
  engine::Window window_;
  Meter meter_;
  Sounds sounds_;
  ViewOptions view_options_;
  engine::FixedTick clock_{ticks_per_second};
  std::int64_t last_frame_ns_ = 0;
  std::uint16_t held_ = 0;
  std::uint16_t tapped_ = 0;
  engine::TickInput next_;
  bool recording_failed_ = false;
};

}  // namespace

int run_in_window(const RunOptions& options) {
  WindowGame game(options);
  try {
    while (game.frame()) {
    }
  } catch (...) {
    game.save_recording();
    throw;
  }
  return game.finish();
}

}  // namespace game
