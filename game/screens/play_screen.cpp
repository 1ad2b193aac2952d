#include "game/screens/play_screen.h"

#include <cstdio>
#include <utility>

#include "engine/sdl_window.h"
#include "game/buttons.h"
#include "game/screens/pause_screen.h"

namespace game {

using engine::WindowInput;

PlayScreen::PlayScreen(Session& session, const RunOptions& options, bool direct)
    : session_(&session), options_(options), direct_(direct), run_(options), view_(run_.simulation()) {
  if (options.seek > 0) run_.seek(options.seek);
  view_options_.watching = run_.has_replay();
  view_options_.meter = &meter_;
}

void PlayScreen::shown() {
  controls_.forget();
  if (started_) return;
  run_.start_recording();
  started_ = true;
}

bool PlayScreen::is_over() const {
  return run_.is_over() || (options_.ticks && run_.simulation().ticks() >= *options_.ticks);
}

Next PlayScreen::update(const Frame& frame) {
  if (is_plain() && (frame.input.pressed(engine::Key::escape) || frame.input.pressed(engine::PadButton::b))) {
    return direct_ ? Next::quit() : Next::back();
  }
  if (wants_pause(frame)) return Next::open(std::make_unique<PauseScreen>(*session_, *this));
  obey_keys(frame);
  const ribbon::Vec2 mouse = frame.canvas.to_world(frame.input.mouse);
  controls_.take(frame.input, session_->settings, mouse, view_options_.debug);
  const int ticks = ticks_to_run(frame);
  for (int k = 0; k < ticks && !is_over(); ++k) tick();
  return Next::stay();
}

bool PlayScreen::wants_pause(const Frame& frame) const {
  if (is_plain()) return false;
  const bool lost = frame.input.pad_lost && session_->uses_pad;
  return lost || (!stopped_ && session_->settings.bindings.pressed(Action::pause, frame.input));
}

void PlayScreen::obey_keys(const Frame& frame) {
  const Bindings& bindings = session_->settings.bindings;
  const auto pressed = [&](Action action) { return bindings.pressed(action, frame.input); };
  if (pressed(Action::pause)) stopped_ = is_plain() && !stopped_;
  if (pressed(Action::step)) stopped_ = true;
  if (pressed(Action::slow_motion)) slowed_ = slowed_ == 4 ? 1 : 2 * slowed_;
  if (pressed(Action::help)) session_->settings.help = !session_->settings.help;
  if (pressed(Action::debug_view)) view_options_.debug = !view_options_.debug;
}

int PlayScreen::ticks_to_run(const Frame& frame) {
  const Settings& settings = session_->settings;
  const int due = clock_.advance(frame.elapsed_ns * settings.speed / (100 * slowed_));
  if (!stopped_) return due;
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, frame.input); };
  if (pressed(Action::step) || pressed(Action::restart)) return 1;  // a restart shows at once
  controls_.forget();  // what was tapped while it stood still is not meant for after it
  return 0;
}

void PlayScreen::step() {
  stopped_ = true;
  if (!is_over()) tick();
}

void PlayScreen::restart() {
  controls_.forget();
  restart_wanted_ = true;
}

void PlayScreen::tick() {
  run_.estimate_errors(view_options_.debug && meter_.wants_estimate());
  const std::int64_t begun = engine::now_ns();
  engine::TickInput input = controls_.next(simulation().player().hand());
  if (std::exchange(restart_wanted_, false)) input.buttons |= button_restart;
  try {
    run_.tick(input);
  } catch (const engine::ReplayError& error) {  // of the recording, once: play on without it
    say_that_recording_failed(error);
  }
  meter_.add(run_.simulation(), engine::now_ns() - begun);
}

void PlayScreen::say_that_recording_failed(const engine::ReplayError& error) {
  std::fprintf(stderr, "ropeswing: %s\n", error.what());
  recording_failed_ = true;
  view_options_.notice = "The recording has ended: the file cannot be written";
}

void PlayScreen::draw(engine::Canvas& canvas, double text_scale) {
  const Settings& settings = session_->settings;
  view_options_.text_scale = text_scale;
  view_options_.paused = stopped_;
  view_options_.over = is_over();
  view_options_.help = settings.help;
  view_.draw(canvas, stopped_ || is_over() ? 1.0 : clock_.alpha(), view_options_);
}

void PlayScreen::leave() {
  try {
    run_.finish();
  } catch (const engine::ReplayError& error) {
    say_that_recording_failed(error);
  }
}

}  // namespace game
