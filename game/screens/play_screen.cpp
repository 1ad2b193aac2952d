#include "game/screens/play_screen.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "engine/window/sdl_window.h"
#include "game/screens/help.h"
#include "game/screens/last_seconds_screen.h"
#include "game/screens/pause_screen.h"
#include "game/screens/results_screen.h"
#include "game/screens/run_message.h"
#include "game/screens/yard_screen.h"
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
      played_(session, options, direct),
      view_(played_.run().simulation()),
      race_(session, options.ghost) {
  race_.check(run().level());
  if (options.seek > 0) played_.run().seek(options.seek);
  view_options_.meter = &meter_;
  if (!run().has_replay()) level_file_.emplace(run().level().map.file);
}

std::string PlayScreen::title() const {
  const std::string& name = run().level().name;
  return run().has_replay() ? words::filled(words::screen_replay, {{"level", name}}) : name;
}

void PlayScreen::shown() {
  input_.discard();
  if (std::exchange(started_, true)) return;
  played_.run().watch(session_->watcher);
  played_.run().use(session_->workers.parallel_for());
  hint_.begin(run().level().hint);
  if (played_.records_runs()) {
    session_->last_level = run().level().name;
    begin_run();
  } else {
    played_.start();
    if (!played_.is_plain() || !played_.options().ghost.empty()) race_.begin(run().level());
  }
}

/// Starts a new run with a recording of its own and the ghost of the best run.
void PlayScreen::begin_run() {
  won_ = false;
  played_.begin();
  race_.begin(run().level());
}

bool PlayScreen::is_won() const {
  const auto goal = simulation().goal_ticks();
  return !played_.is_plain() && goal && simulation().run_ticks() >= *goal + results_delay;
}

Next PlayScreen::update(const Frame& frame) {
  const engine::WindowInput input =
      panel_.update(frame.input, frame.canvas, frame.text_scale, 1e-9 * static_cast<double>(frame.elapsed_ns),
                    played_.run(), meter_, session_->frame_times);
  played_.notice_tuning();
  reload_if_changed(frame.elapsed_ns);
  if (panel_.takes_restart()) restart();
  if (const Preset* const preset = panel_.takes_comparison()) {
    return Next::open(std::make_unique<LastSecondsScreen>(*session_, run().level(), run().inputs(), *preset));
  }
  return play({input, frame.menu, frame.canvas, frame.elapsed_ns, frame.text_scale});
}

/// Restarts with the new level when its file has changed. If that is invalid, reports it and continues.
void PlayScreen::reload_if_changed(std::int64_t elapsed_ns) {
  if (!level_file_ || !level_file_->poll(elapsed_ns)) return;
  try {
    Level level = load_level(level_file_->path());
    if (level.map.content_hash == run().level().map.content_hash) return;  // written by the panel
    level.assists = run().level().assists;
    set_yard(level, yard_of(yard_text(run().level().yard), level).value_or(Yard{}));
    played_.set_level(std::move(level), false);
    session_->notice.show(words::level_reloaded);
    restart();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_->notice.show(error.what());
  }
}

Next PlayScreen::play(const Frame& frame) {
  const engine::WindowInput& input = frame.input;
  if (played_.is_plain() && (input.pressed(engine::Key::escape) || input.pressed(engine::PadButton::b))) {
    return played_.is_direct() ? Next::quit() : Next::back();
  }
  if (wants_pause(frame)) return Next::open(std::make_unique<PauseScreen>(*session_, *this));
  if (played_.can_build() && session_->settings.bindings.pressed(Action::palette, input))
    return Next::open(std::make_unique<YardScreen>(*session_, *this));
  handle_keys(frame);
  const bool dragging = view_options_.debug || run().level().sandbox;
  input_.take(input, session_->settings, frame.canvas.to_world(input.mouse), dragging, simulation().players());
  const int ticks = ticks_to_run(frame);
  for (int k = 0; k < ticks && !is_over(); ++k) tick();
  if (frame.elapsed_ns > 0) race_.advance(ticks, simulation().run_ticks());  // once a frame
  if (!is_won()) {
    won_ = false;  // restarted
  } else if (!std::exchange(won_, true)) {
    if (played_.records_runs()) played_.finish();
    return Next::open(std::make_unique<ResultsScreen>(*session_, *this));
  }
  return Next::stay();
}

bool PlayScreen::wants_pause(const Frame& frame) const {
  if (played_.is_plain()) return false;
  const bool lost = frame.input.pad_lost && session_->uses_pad;
  const bool fixed = frame.input.pressed(engine::Key::escape);  // with any bindings
  const bool runs = !pace_.is_stopped();
  if (frame.input.focus_lost && runs) return true;
  return lost || fixed || (runs && session_->settings.bindings.pressed(Action::pause, frame.input));
}

void PlayScreen::handle_keys(const Frame& frame) {
  Settings& settings = session_->settings;
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, frame.input); };
  pace_.read_keys(frame.input, settings, played_.is_plain());
  if (pressed(Action::help)) settings.help = !settings.help;
  if (pressed(Action::debug_view)) view_options_.debug = !view_options_.debug;
  if (pressed(Action::panel)) panel_.toggle();
  if (pressed(Action::restart) && !run().has_replay()) restart();
}

int PlayScreen::ticks_to_run(const Frame& frame) {
  const Settings& settings = session_->settings;
  const int due = pace_.ticks_in(frame.elapsed_ns, run().has_replay() ? 100 : settings.speed);
  if (!pace_.is_stopped()) return due;
  const auto pressed = [&](Action action) { return settings.bindings.pressed(action, frame.input); };
  if (pressed(Action::step) || pressed(Action::restart)) return 1;  // a restart needs a tick to be visible
  input_.discard_presses();  // presses while the run is stopped do not count later
  return 0;
}

void PlayScreen::step() {
  pace_.stop();
  if (!is_over()) tick();
}

void PlayScreen::end_building() {
  input_.discard();
  begin_run();
}

/// Goes back to the start of the level, also after building elsewhere.
void PlayScreen::restart() {
  if (Yard yard = run().level().yard; yard.start && played_.can_build()) {
    yard.start.reset();
    played_.build(yard);
  }
  input_.discard();
  hint_.begin(run().level().hint);
  if (played_.records_runs()) {
    begin_run();
  } else {
    restart_wanted_ = true;
  }
}

void PlayScreen::tick() {
  engine::TickInput input = input_.next(simulation());
  if (std::exchange(restart_wanted_, false)) {
    input.buttons |= button_restart;
    played_.mark_assisted(false);
  }
  const bool helped = !pace_.is_usual() || session_->settings.speed < 100 || played_.options().assists.any();
  if (helped || (input.buttons & button_drag) != 0) played_.mark_assisted();
  played_.run().estimate_errors(view_options_.debug && meter_.wants_estimate());
  const std::int64_t start = engine::now_ns();
  const int falls = simulation().falls();
  played_.tick(input);
  const std::int64_t took = engine::now_ns() - start;
  meter_.add(simulation(), took);
  session_->frame_times.add(FrameTimes::Part::physics, took);
  if (simulation().falls() > falls) input_.ignore_held();
  race_.tick(simulation());
  hint_.tick(static_cast<std::uint16_t>(input.buttons | input.second_buttons), holds_a_cord(simulation()));
  session_->sounds.tick(simulation());
}

void PlayScreen::draw(engine::Canvas& canvas, double text_scale) { draw_run(canvas, text_scale, true); }

/// Draws the run without texts over it.
void PlayScreen::draw_below(engine::Canvas& canvas, double text_scale) { draw_run(canvas, text_scale, false); }

/// Chooses the lines that explain the keys.
void PlayScreen::choose_keys() {
  const Settings& settings = session_->settings;
  const bool for_two = simulation().players() == 2;
  const bool pad = session_->uses_pad;
  keys_ = run().has_replay()         ? std::vector<std::string>{words::replay_controls}
          : settings.help && for_two ? help_lines_for_two(settings, pad)
          : settings.help            ? help_lines(settings, pad)
                                     : help_line(settings, pad);
  if (!played_.can_build() || settings.help || pad) return;
  const std::string key = codes_in_words(settings.bindings, Action::palette, false, 1);
  keys_.push_back(words::filled(words::build_key, {{"key", key}}));
}

/// Chooses what the HUD says, and where it may be: beside the panel, if that is shown at an edge.
void PlayScreen::fill_hud(const engine::Canvas& canvas, double text_scale) {
  choose_keys();
  RunMessage message = message_of(played_, *session_, pace_, hint_, won_);
  view_options_.headline = std::move(message.headline);
  view_options_.below = std::move(message.below);
  view_options_.keys = &keys_;
  notice_ = played_.recording_failed() ? words::recording_stopped : session_->notice.text();
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
  view_options_.signs = signs_in_words(run().level(), settings, session_->uses_pad);
  view_options_.reduced_motion = settings.reduced_motion;
  view_options_.colour_safe = settings.colour_safe;
  view_options_.strain_tint = settings.strain_tint;
  view_options_.ghost = race_.ghost_at(simulation().run_ticks());
  view_options_.second_ghost = race_.ghost_at(simulation().run_ticks(), 1);
  view_options_.split = race_.message();
  view_.draw(canvas, pace_.is_stopped() || is_over() ? 1.0 : pace_.alpha(), view_options_);
  if (with_hud) panel_.draw(canvas);
  session_->frame_times.add(FrameTimes::Part::drawing, engine::now_ns() - start);
}

double PlayScreen::free_side(const engine::Canvas& canvas) const {
  return canvas.to_pixels(simulation().player().position()).x < 0.5 * canvas.width() ? 1.0 : -1.0;
}

void PlayScreen::leave() { played_.finish(); }

}  // namespace game
