#include "game/program/app.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/replay/replay.h"
#include "game/program/bad_ticks.h"
#include "game/screens/play_screen.h"
#include "game/screens/title_screen.h"
#include "game/settings/user_files.h"
#include "game/view/hud.h"

namespace game {
namespace {

constexpr int window_width = 1280;
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

}  // namespace

App::App(const RunOptions& options)
    : options_(options),
      bad_ticks_(bad_tick_recorder(options)),
      session_(config_folder(), data_folder()),
      first_run_(requested_run(session_, options)),
      direct_(first_run_.get()),
      window_("Rope swing", window_width, window_height) {
  session_.watcher = bad_ticks_.get();
  report_sound_errors();
  if (direct_ != nullptr) {
    screens_.open(std::move(first_run_));
  } else {
    screens_.open(std::make_unique<TitleScreen>(session_));
  }
}

App::~App() = default;

bool App::frame(std::int64_t elapsed_ns) {
  if (!update(window_.poll(), elapsed_ns)) return false;
  draw();
  window_.present();
  return direct_ == nullptr || !direct_->ends_program();
}

bool App::update(const engine::WindowInput& input, std::int64_t elapsed_ns) {
  if (input.quit) return false;
  handle_keys(input);
  report_gamepads(input);
  const MenuInput menu = menu_reader_.read(input, elapsed_ns);
  if (!screens_.update({input, menu, window_.canvas(), elapsed_ns, text_scale()})) return false;
  session_.notice.advance(elapsed_ns);
  drawn_ns_ += elapsed_ns;
  const SoundSettings& sound = session_.settings.sound;
  session_.sounds.frame(elapsed_ns, {sound.volume / 100.0, sound.music / 100.0, sound.muted}, screens_.top().tune());
  apply_settings();
  return true;
}

void App::apply_settings() {
  session_.save_settings();
  if (is_fullscreen_ != session_.settings.fullscreen) {
    is_fullscreen_ = session_.settings.fullscreen;
    window_.set_fullscreen(is_fullscreen_);
  }
  const std::string title = "Rope swing - " + screens_.top().title();
  if (title == title_) return;
  title_ = title;
  window_.set_title(title);
}

void App::draw() {
  screens_.draw(window_.canvas(), text_scale());
  if (!session_.notice.text().empty()) draw_notice(window_.canvas(), session_.notice.text(), text_scale());
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

double App::text_scale() const {
  const engine::Canvas& canvas = window_.canvas();
  const double size = std::min(canvas.width() / (1.0 * window_width), canvas.height() / (1.0 * window_height));
  return window_.pixel_scale() * std::clamp(size / window_.pixel_scale(), 0.5, 1.5);
}

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
  if (input.pad_found) session_.notice.show("A gamepad is plugged in");
  if (input.pad_lost) session_.notice.show("The gamepad was unplugged");
}

void App::report_sound_errors() {
  const Sounds& sounds = session_.sounds;
  for (const std::string& error : {sounds.why_silent(), sounds.load_error()}) {
    if (!error.empty()) std::fprintf(stderr, "ropeswing: %s\n", error.c_str());
  }
  if (!sounds.load_error().empty()) session_.notice.show("A sound is missing: " + sounds.load_error());
}

void App::save_screenshot() {
  try {
    const std::string name = free_name(".png");
    window_.save_png(name);
    std::printf("picture: %s\n", name.c_str());
    session_.notice.show("Screenshot: " + name);
  } catch (const std::runtime_error& error) {  // the game continues
    std::fprintf(stderr, "ropeswing: %s\n", error.what());
    session_.notice.show("The screenshot cannot be written");
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
  return direct_->exit_status();
}

}  // namespace game
