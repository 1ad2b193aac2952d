#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "game/program/app.h"
#include "game/screens/level_facts.h"
#include "game/screens/play_screen.h"
#include "game/simulation/buttons.h"
#include "tests/game/process.h"
#include "tests/game/program.h"
#include "tests/support/sdl_events.h"

namespace game {

using engine::Key;
using engine::PadButton;
using test_support::scratch;
using test_support::VirtualPad;

constexpr std::int64_t tick_ns = 16'666'668;  // slightly more than a tick, and divisible by four

/// The program with folders of this test.
class Journey : public testing::Test {
 protected:
  Journey() {
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1", 1);  // a dummy window never has the focus
    std::filesystem::remove_all(config());
    std::filesystem::remove_all(data());
    setenv("XDG_CONFIG_HOME", config().c_str(), 1);
    setenv("XDG_DATA_HOME", data().c_str(), 1);
  }
  ~Journey() override {
    app.reset();
    unsetenv("SDL_VIDEODRIVER");
    unsetenv("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS");
  }

  static std::string config() { return scratch("journey_config"); }
  static std::string data() { return scratch("journey_data"); }

  void open(const RunOptions& options = {}) {
    app.emplace(options);
    if (!options.level) frame();
  }
  bool frame() { return app->update(app->window().poll(), tick_ns); }
  std::string screen() const { return app->screens().top().title(); }
  const PlayScreen& play() const { return dynamic_cast<const PlayScreen&>(app->screens().top()); }

  /// Presses in one frame, releases in the next. Returns false if the game ended.
  bool tap(Key key) {
    test_support::push_key(key, true);
    const bool goes_on = frame();
    test_support::push_key(key, false);
    return goes_on && frame();
  }
  bool tap(VirtualPad& pad, PadButton button) {
    pad.press(button, true);
    const bool goes_on = frame();
    pad.press(button, false);
    return goes_on && frame();
  }

  /// Goes from the title to first_swing; `next` and `accept` operate the menus.
  void start_first_swing(const std::function<void()>& next, const std::function<void()>& accept) {
    accept();
    ASSERT_EQ(screen(), "levels");
    const std::vector<Level> levels = levels_in_order();
    const auto is_wanted = [](const Level& level) { return level.name == "first_swing"; };
    const auto which = std::find_if(levels.begin(), levels.end(), is_wanted) - levels.begin();
    for (std::ptrdiff_t k = 0; k < which; ++k) next();
    accept();  // in a single frame: the next one is the run's first tick
    ASSERT_EQ(screen(), "first_swing");
  }

  void play_by_gamepad();

  std::optional<App> app;
};

struct KeyOf {
  Button button;
  Key key;
  PadButton pad;
};
constexpr std::array keys = {
    KeyOf{button_left, Key::a, PadButton::dpad_left},
    KeyOf{button_right, Key::right, PadButton::dpad_right},
    KeyOf{button_jump, Key::space, PadButton::a},
    KeyOf{button_grab, Key::shift, PadButton::right_trigger},
    KeyOf{button_up, Key::w, PadButton::dpad_up},
    KeyOf{button_down, Key::down, PadButton::dpad_down},
    KeyOf{button_throw, Key::f, PadButton::y},
    KeyOf{button_reel_in, Key::q, PadButton::right_shoulder},
    KeyOf{button_reel_out, Key::z, PadButton::left_shoulder},
    KeyOf{button_retry, Key::t, PadButton::b},
};

/// Calls `press` for each button that differs between two ticks.
inline void change_buttons(std::uint16_t from, std::uint16_t to, const std::function<void(const KeyOf&, bool)>& press) {
  for (const KeyOf& key : keys) {
    if ((to & key.button) != (from & key.button)) press(key, (to & key.button) != 0);
  }
}

}  // namespace game
