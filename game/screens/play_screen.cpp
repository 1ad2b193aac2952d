#include "game/screens/play_screen.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "engine/window/sdl_window.h"
#include "game/screens/help.h"
#include "game/screens/last_seconds_screen.h"
#include "game/screens/pause_screen.h"
#include "game/screens/results_screen.h"
#include "game/screens/yard_screen.h"
#include "game/settings/two_players.h"
#include "game/simulation/buttons.h"
#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr int results_delay = 45;   // ticks, from the goal to the results
constexpr double min_beside = 0.4;  // of the width, for a run beside the panel

/// Returns the larger part of the canvas beside a panel; the whole canvas if both are narrow.
Rectangle beside(const Rectangle& panel, const engine::Canvas& canvas) {
  const double left = panel.corner.x;
  const double right = canvas.width() - panel.corner.x - panel.size.x;
  if (std::max(left, right) < min_beside * canvas.width()) return {};
  const double start = left >= right ? 0.0 : panel.corner.x + panel.size.x;
  return {{start, 0.0}, {std::max(left, right), 1.0 * canvas.height()}};
}

/// Returns whether a player holds a rope or its line.
bool holds_a_cord(const Simulation& simulation) {
  for (int k = 0; k < simulation.players(); ++k) {
    if (simulation.player(k).held_place(simulation.scene().coupling())) return true;
  }
  return false;
}

}  // namespace

PlayScreen::PlayScreen(Session& session, const RunOptions& options, bool direct)
    : session_(&session),
      options_(options),
      direct_(direct),
      run_(options),
      view_(run_.simulation()),
      race_(session, options.ghost) {
  race_.check(run_.level());
  if (options.seek > 0) run_.seek(options.seek);
  view_options_.meter = &meter_;
  if (!run_.has_replay()) level_file_.emplace(run_.level().map.file);
}

std::string PlayScreen::title() const {
  const std::string& name = run_.level().name;
  return run_.has_replay() ? words::filled(words::screen_replay, {{"level", name}}) : name;
}

void PlayScreen::shown() {
  controls_.discard();
  second_controls_.discard();
  if (std::exchange(started_, true)) return;
  run_.watch(session_->watcher);
  run_.use(session_->workers.parallel_for());
  hint_.begin(run_.level().hint);
  if (records_runs()) {
    session_->last_level = run_.level().name;
    begin_run();
  } else {
    run_.start_recording();
    if (!is_plain() || !options_.ghost.empty()) race_.begin(run_.level());
  }
}

/// Starts a new run with a recording of its own and the ghost of the best run.
void PlayScreen::begin_run() {
  finish_recording();
  assisted_ = won_ = false;
  recording_ = session_->runs.next_path(run_.level().name);
  if (run_.level_is_tuned()) {
    recording_.clear();
  } else if (recording_.empty()) {
    session_->report_no_recordings();
  }
  try {
    run_.begin(recording_);
  } catch (const engine::ReplayError& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->report_no_recordings();
    recording_.clear();
  }
  assisted_ = run_.is_tuned();
  race_.begin(run_.level());
}

bool PlayScreen::is_over() const {
  return run_.is_over() || (options_.ticks && run_.simulation().ticks() >= *options_.ticks);
}

bool PlayScreen::is_won() const {
  const auto goal = simulation().goal_ticks();
  return !is_plain() && goal && simulation().run_ticks() >= *goal + results_delay;
}

Next PlayScreen::update(const Frame& frame) {
  const engine::WindowInput input =
      panel_.update(frame.input, frame.canvas, frame.text_scale, 1e-9 * static_cast<double>(frame.elapsed_ns), run_,
                    meter_, session_->frame_times);
  if (run_.is_tuned()) {
    assisted_ = true;
    recording_.clear();  // it ended when the tuning began
  }
  reload_if_changed(frame.elapsed_ns);
  if (panel_.takes_restart()) restart();
  if (const Preset* const preset = panel_.takes_comparison()) {
    return Next::open(std::make_unique<LastSecondsScreen>(*session_, run_.level(), run_.inputs(), *preset));
  }
  return play({input, frame.menu, frame.canvas, frame.elapsed_ns, frame.text_scale});
}

/// Restarts with the new level when its file has changed. If that is invalid, reports it and continues.
void PlayScreen::reload_if_changed(std::int64_t elapsed_ns) {
  if (!level_file_ || !level_file_->poll(elapsed_ns)) return;
  try {
    Level level = load_level(level_file_->path());
    if (level.map.content_hash == run_.level().map.content_hash) return;  // written by the panel
    level.assists = run_.level().assists;
    set_yard(level, yard_of(yard_text(run_.level().yard), level).value_or(Yard{}));
    run_.set_level(std::move(level), false);
    session_->notice.show(words::level_reloaded);
    restart();
  } catch (const engine::ReplayError& error) {
    report_recording_failure(error);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->notice.show(error.what());
  }
}

Next PlayScreen::play(const Frame& frame) {
  if (is_plain() && (frame.input.pressed(engine::Key::escape) || frame.input.pressed(engine::PadButton::b))) {
    return direct_ ? Next::quit() : Next::back();
  }
  if (wants_pause(frame)) return Next::open(std::make_unique<PauseScreen>(*session_, *this));
  if (can_build() && session_->settings.bindings.pressed(Action::palette, frame.input))
    return Next::open(std::make_unique<YardScreen>(*session_, *this));
  handle_keys(frame);
  const ribbon::Vec2 mouse = frame.canvas.to_world(frame.input.mouse);
  take_controls(frame.input, mouse);
  const int ticks = ticks_to_run(frame);
  for (int k = 0; k < ticks && !is_over(); ++k) tick();
  if (frame.elapsed_ns > 0) race_.advance(ticks, simulation().run_ticks());  // once a frame
  if (!is_won()) {
    won_ = false;  // restarted
  } else if (!std::exchange(won_, true)) {
    if (records_runs()) finish_recording();
    return Next::open(std::make_unique<ResultsScreen>(*session_, *this));
  }
  return Next::stay();
}

bool PlayScreen::wants_pause(const Frame& frame) const {
  if (is_plain()) return false;
  const bool lost = frame.input.pad_lost && session_->uses_pad;
  const bool fixed = frame.input.pressed(engine::Key::escape);  // with any bindings
  if (frame.input.focus_lost && !stopped_) return true;
  return lost || fixed || (!stopped_ && session_->settings.bindings.pressed(Action::pause, frame.input));
}

/// Reads the controls of the player, or of both, each with its half of the keyboard and its gamepad.
void PlayScreen::take_controls(const engine::WindowInput& input, ribbon::Vec2 mouse) {
  const Settings& settings = session_->settings;
  const bool dragging = view_options_.debug || run_.level().sandbox;
  if (simulation().players() == 1) return controls_.take(input, settings, mouse, dragging);
  controls_.take(input_of(0, input), bindings_of(0, settings), settings.toggle_grab, mouse, dragging);
  second_controls_.take(input_of(1, input), bindings_of(1, settings), settings.toggle_grab, std::nullopt, false);
}

engine::TickInput PlayScreen::next_input() {
  engine::TickInput input = controls_.next(simulation().player().hand());
  if (simulation().players() == 2) {
    const ribbon::Vec2 hand = simulation().player(1).hand();
    input.second_buttons = second_controls_.next(hand).buttons;
    if (const auto at = second_controls_.pointer(hand)) engine::set_second_pointer(input, *at);
  }
  input.buttons &= static_cast<std::uint16_t>(~button_restart);
  input.second_buttons &= static_cast<std::uint16_t>(~button_restart);
  return input;
}

void PlayScreen::handle_keys(const Frame& frame) {
  Settings& settings = session_->settings;
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, frame.input); };
  if (pressed(Action::pause)) stopped_ = is_plain() && !stopped_;
  if (pressed(Action::step)) stopped_ = true;
  if (pressed(Action::slow_motion)) slowed_ = slowed_ == 4 ? 1 : 2 * slowed_;
  if (pressed(Action::help)) settings.help = !settings.help;
  if (pressed(Action::debug_view)) view_options_.debug = !view_options_.debug;
  if (pressed(Action::panel)) panel_.toggle();
  if (pressed(Action::restart) && !run_.has_replay()) restart();
}

int PlayScreen::ticks_to_run(const Frame& frame) {
  const Settings& settings = session_->settings;
  const int speed = run_.has_replay() ? 100 : settings.speed;
  const int due = clock_.advance(frame.elapsed_ns * speed / (100 * slowed_));
  if (!stopped_) return due;
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, frame.input); };
  if (pressed(Action::step) || pressed(Action::restart)) return 1;  // a restart needs a tick to be visible
  second_controls_.discard_presses();
  controls_.discard_presses();  // presses while the run is stopped do not count later
  return 0;
}

void PlayScreen::step() {
  stopped_ = true;
  if (!is_over()) tick();
}

void PlayScreen::begin_building() {
  if (!records_runs() && std::exchange(options_.record, "") != "")
    session_->notice.show(words::recording_ended_by_building);
  build(with_start_at(run_.level().yard, simulation()));
}

void PlayScreen::build(const Yard& yard) {
  Level level = run_.level();
  set_yard(level, yard);
  try {
    run_.set_level(std::move(level), run_.level_is_tuned());
  } catch (const engine::ReplayError& error) {
    report_recording_failure(error);
  }
  run_.begin("");
}

void PlayScreen::end_building() {
  controls_.discard();
  second_controls_.discard();
  begin_run();
}

/// Goes back to the start of the level, also after building elsewhere.
void PlayScreen::restart() {
  if (Yard yard = run_.level().yard; yard.start && can_build()) {
    yard.start.reset();
    build(yard);
  }
  controls_.discard();
  second_controls_.discard();
  hint_.begin(run_.level().hint);
  if (records_runs()) {
    begin_run();
  } else {
    restart_wanted_ = true;
  }
}

void PlayScreen::tick() {
  engine::TickInput input = next_input();
  if (std::exchange(restart_wanted_, false)) {
    input.buttons |= button_restart;
    assisted_ = false;
  }
  const bool helped = slowed_ > 1 || stopped_ || session_->settings.speed < 100 || options_.assists.any();
  if (helped || (input.buttons & button_drag) != 0) assisted_ = true;
  run_.estimate_errors(view_options_.debug && meter_.wants_estimate());
  const std::int64_t start = engine::now_ns();
  const int falls = simulation().falls();
  try {
    run_.tick(input);
  } catch (const engine::ReplayError& error) {  // thrown once; the run continues without a recording
    report_recording_failure(error);
  }
  const std::int64_t took = engine::now_ns() - start;
  meter_.add(run_.simulation(), took);
  session_->frame_times.add(FrameTimes::Part::physics, took);
  if (simulation().falls() > falls) {
    controls_.ignore_held();
    second_controls_.ignore_held();
  }
  race_.tick(run_.simulation());
  hint_.tick(static_cast<std::uint16_t>(input.buttons | input.second_buttons), holds_a_cord(run_.simulation()));
  session_->sounds.tick(run_.simulation());
}

void PlayScreen::report_recording_failure(const engine::ReplayError& error) {
  std::fprintf(stderr, "ropeswing: %s\n", error.what());
  recording_.clear();  // it is incomplete
  if (records_runs()) return session_->report_no_recordings();
  recording_failed_ = true;
}

void PlayScreen::choose_message() {
  const auto set = [this](std::string headline, std::string below) {
    view_options_.headline = std::move(headline);
    view_options_.below = std::move(below);
  };
  const auto key = [this](Action action) {
    return codes_in_words(session_->settings.bindings, action, session_->uses_pad, 1);
  };
  const std::string leave = session_->uses_pad ? words::leave_button : words::leave_key;
  if (is_over() && options_.verify) {
    const bool same = run_.exit_status() == 0;
    return set(same ? words::verified : words::differs,
               words::filled(words::two_parts, {{"first", run_.closing_line()}, {"second", leave}}));
  }
  if (is_over()) return set(words::end_of_recording, leave);
  const auto goal = simulation().goal_ticks();
  if (stopped_) {
    return set(words::stopped,
               words::filled(words::stopped_keys, {{"pause", key(Action::pause)}, {"step", key(Action::step)}}));
  }
  if (goal && !won_) return set(words::made_it, words::filled(words::made_it_in, {{"time", seconds_in_words(*goal)}}));
  if (run_.has_replay()) return set("", "");
  if (simulation().players() == 2 && !goal && simulation().is_at_flag(0) != simulation().is_at_flag(1))
    return set("", words::one_at_flag);
  const std::string hint = hint_in_words(run_.level().hint, session_->settings, session_->uses_pad);
  if (slowed_ == 1 && hint_.is_shown() && !goal) return set("", hint);
  set("", slowed_ == 1 ? "" : words::filled(words::slow_motion, {{"factor", std::to_string(slowed_)}}));
}

void PlayScreen::draw(engine::Canvas& canvas, double text_scale) { draw_run(canvas, text_scale, true); }

/// Draws the run without texts over it.
void PlayScreen::draw_below(engine::Canvas& canvas, double text_scale) { draw_run(canvas, text_scale, false); }

/// Chooses what the HUD says, and where it may be: beside the panel, if that is shown at an edge.
void PlayScreen::fill_hud(const engine::Canvas& canvas, double text_scale) {
  const Settings& settings = session_->settings;
  const bool for_two = simulation().players() == 2;
  const bool pad = session_->uses_pad;
  keys_ = run_.has_replay()          ? std::vector<std::string>{words::replay_controls}
          : settings.help && for_two ? help_lines_for_two(settings, pad)
          : settings.help            ? help_lines(settings, pad)
                                     : help_line(settings, pad);
  if (can_build() && !settings.help && !pad)
    keys_.push_back(
        words::filled(words::build_key, {{"key", codes_in_words(settings.bindings, Action::palette, false, 1)}}));
  choose_message();
  view_options_.keys = &keys_;
  notice_ = recording_failed_ ? words::recording_stopped : session_->notice.text();
  view_options_.notice = notice_.c_str();
  view_options_.text_scale = text_scale;
  view_options_.panel = view_options_.free = {};
  const auto panel = panel_.place();
  if (!panel) return;
  view_options_.panel = {panel->corner, panel->size};
  view_options_.free = beside(view_options_.panel, canvas);
}

void PlayScreen::draw_run(engine::Canvas& canvas, double text_scale, bool with_hud) {
  const std::int64_t start = engine::now_ns();
  const Settings& settings = session_->settings;
  view_options_.hud = with_hud;
  fill_hud(canvas, text_scale);
  view_options_.signs = signs_in_words(run_.level(), settings, session_->uses_pad);
  view_options_.reduced_motion = settings.reduced_motion;
  view_options_.colour_safe = settings.colour_safe;
  view_options_.strain_tint = settings.strain_tint;
  view_options_.ghost = race_.ghost_at(simulation().run_ticks());
  view_options_.second_ghost = race_.ghost_at(simulation().run_ticks(), 1);
  view_options_.split = race_.message();
  view_.draw(canvas, stopped_ || is_over() ? 1.0 : clock_.alpha(), view_options_);
  if (with_hud) panel_.draw(canvas);
  session_->frame_times.add(FrameTimes::Part::drawing, engine::now_ns() - start);
}

double PlayScreen::free_side(const engine::Canvas& canvas) const {
  return canvas.to_pixels(simulation().player().position()).x < 0.5 * canvas.width() ? 1.0 : -1.0;
}

void PlayScreen::finish_recording() {
  try {
    run_.finish();
  } catch (const engine::ReplayError& error) {
    report_recording_failure(error);
  }
}

void PlayScreen::leave() { finish_recording(); }

}  // namespace game
