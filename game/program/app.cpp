#include "game/program/app.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/replay/replay.h"
#include "game/program/bad_ticks.h"
#include "game/screens/lab_screen.h"
#include "game/screens/play_screen.h"
#include "game/screens/title_screen.h"
#include "game/settings/user_files.h"
#include "game/view/hud.h"
#include "game/words/words.h"

namespace game {
namespace {

constexpr int window_width = 1280;  // desktop units
constexpr int window_height = 720;

/// Returns the name of the level of a recording to race against.
std::string level_of_recording(const std::string& path) { return engine::load_replay(path).header.level; }

std::unique_ptr<PlayScreen> requested_run(Session& session, const RunOptions& options) {
  if (!options.level && options.replay.empty() && options.record.empty() && !options.ticks && options.ghost.empty()) {
    return nullptr;
  }
  RunOptions requested = options;
  if (!options.ghost.empty() && !options.level) requested.level = level_of_recording(options.ghost);
  const bool by_hand = options.replay.empty() && !options.ticks;
  if (by_hand) requested.assists = session.settings.assists();
  return std::make_unique<PlayScreen>(session, requested, true);
}

std::unique_ptr<Screen> requested_lab(Session& session, const RunOptions& options) {
  if (!options.lab) return nullptr;
  return std::make_unique<LabScreen>(session, *options.lab);
}

}  // namespace

App::App(const RunOptions& options)
    : options_(options),
      bad_ticks_(bad_tick_recorder(options)),
      session_(config_folder(), data_folder()),
      first_run_(requested_run(session_, options)),
      first_lab_(requested_lab(session_, options)),
      direct_(first_run_.get()),
      window_(words::game_title, window_width, window_height),
      screenshots_(pictures_folder()),
      film_(videos_folder()) {
  session_.watcher = bad_ticks_.get();
  report_sound_errors();
  if (direct_ != nullptr) {
    screens_.open(std::move(first_run_));
  } else {
    screens_.open(std::make_unique<TitleScreen>(session_));
    if (first_lab_) screens_.open(std::move(first_lab_));
  }
}

App::~App() = default;

bool App::frame(std::int64_t elapsed_ns) {
  const std::int64_t start = engine::now_ns();
  if (!update(window_.poll(), elapsed_ns)) return false;
  draw();
  session_.frame_times.add(FrameTimes::Part::whole, engine::now_ns() - start);
  session_.frame_times.end_frame(elapsed_ns);
  window_.present();
  return direct_ == nullptr || !direct_->played().ends_program();
}

bool App::update(const engine::WindowInput& input, std::int64_t elapsed_ns) {
  if (input.quit) return false;
  const std::vector<engine::WindowInput> parts = engine::single_presses(input);
  for (const engine::WindowInput& part : parts) {
    if (!update_part(part, &part == &parts.back() ? elapsed_ns : 0)) return false;
  }
  session_.notice.advance(elapsed_ns);
  drawn_ns_ += elapsed_ns;
  const SoundSettings& sound = session_.settings.sound;
  session_.sounds.frame(elapsed_ns, {sound.volume / 100.0, sound.music / 100.0, sound.muted}, screens_.top().tune());
  apply_settings();
  return true;
}

/// Handles a part of the input of a frame, so that every press counts, in order, even on a screen that one before
/// opened.
bool App::update_part(const engine::WindowInput& input, std::int64_t elapsed_ns) {
  handle_keys(input);
  report_gamepads(input);
  const MenuInput menu = menu_reader_.read(input, elapsed_ns);
  return screens_.update({input, menu, window_.canvas(), elapsed_ns, text_scale()});
}

void App::apply_settings() {
  session_.save_settings();
  if (is_fullscreen_ != session_.settings.fullscreen) {
    is_fullscreen_ = session_.settings.fullscreen;
    window_.set_fullscreen(is_fullscreen_);
  }
  const std::string title = words::filled(words::window_title, {{"screen", screens_.top().title()}});
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

void App::draw() {
  screens_.draw(window_.canvas(), text_scale());
  const std::string& notice = session_.notice.text();
  if (!notice.empty() && !screens_.top().shows_notice()) draw_notice(window_.canvas(), notice, text_scale());
  if (std::exchange(wants_screenshot_, false)) save_screenshot();
  record_frame();
}

/// Adds the canvas to the video. What is drawn later is not in it.
void App::record_frame() {
  std::string message = film_.take(window_.raster(), std::exchange(drawn_ns_, 0));
  if (std::exchange(wants_film_, false)) message = film_.toggle(window_.raster());
  if (!message.empty()) {
    std::printf("%s\n", message.c_str());
    session_.notice.show(std::move(message));
  }
  if (film_.is_running()) draw_filming_mark(window_.canvas(), text_scale());
}

double App::text_scale() const { return text_scale_of(window_.canvas(), window_.pixel_scale()); }

void App::handle_keys(const engine::WindowInput& input) {
  Settings& settings = session_.settings;
  if (settings.bindings.pressed(Action::mute, input)) settings.sound.muted = !settings.sound.muted;
  if (settings.bindings.pressed(Action::fullscreen, input)) settings.fullscreen = !settings.fullscreen;
  if (settings.bindings.pressed(Action::screenshot, input)) wants_screenshot_ = true;
  if (settings.bindings.pressed(Action::film, input)) wants_film_ = true;
}

void App::report_gamepads(const engine::WindowInput& input) {
  if (input.pad_pressed.any()) session_.uses_pad = true;
  if (input.keys_pressed.any() || input.buttons_pressed.any()) session_.uses_pad = false;
  if (input.pad_found) session_.notice.show(words::pad_found);
  if (input.pad_lost) session_.notice.show(words::pad_lost);
}

void App::report_sound_errors() {
  const Sounds& sounds = session_.sounds;
  for (const std::string& error : {sounds.why_silent(), sounds.load_error()}) {
    if (!error.empty()) std::fprintf(stderr, "ropeswing: %s\n", error.c_str());
  }
  if (!sounds.load_error().empty())
    session_.notice.show(words::filled(words::sound_missing, {{"reason", sounds.load_error()}}));
}

void App::save_screenshot() {
  try {
    const std::string path = screenshots_.next(".png");
    window_.save_png(path);
    std::printf("picture: %s\n", path.c_str());
    session_.notice.show(words::filled(words::screenshot, {{"file", screenshots_.to_tell(path)}}));
  } catch (const std::runtime_error& error) {  // the game continues
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_.notice.show(words::filled(words::screenshot_failed, {{"reason", error.what()}}));
  }
}

int App::finish() {
  if (const std::string message = film_.finish(); !message.empty()) std::printf("%s\n", message.c_str());
  screens_.leave();
  if (!options_.screenshot.empty()) {
    window_.save_png(options_.screenshot);
    std::printf("picture of the last moment: %s\n", options_.screenshot.c_str());
  }
  if (bad_ticks_) std::printf("%s\n", bad_ticks_line(*bad_ticks_, options_).c_str());
  if (direct_ == nullptr) return 0;
  std::puts(direct_->run().closing_line().c_str());
  return direct_->played().exit_status();
}

}  // namespace game
