#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>

#include "game/program/app.h"
#include "game/screens/level_facts.h"
#include "game/screens/play_screen.h"
#include "game/simulation/buttons.h"
#include "tests/game/process.h"
#include "tests/game/program.h"
#include "tests/game/program/journey.h"
#include "tests/support/sdl_events.h"

namespace game {
namespace {

using test_support::golden;

/// Checks that the saved recording and the golden run have the same bits up to the end of the shorter one.
void expect_same_run(const std::string& path, std::size_t at_least) {
  const engine::Replay kept = engine::load_replay(path);
  const engine::Replay wanted = engine::load_replay(golden());
  ASSERT_GE(kept.ticks.size(), at_least);
  for (std::size_t k = 0; k < std::min(kept.ticks.size(), wanted.ticks.size()); ++k) {
    ASSERT_EQ(kept.ticks[k].input.buttons, wanted.ticks[k].input.buttons) << "tick " << k + 1;
    ASSERT_TRUE(kept.ticks[k].state == wanted.ticks[k].state) << "tick " << k + 1;
  }
}

TEST_F(Journey, KeysFromTheTitleToTheGoalAndBack) {
  open();
  EXPECT_EQ(screen(), "title");
  const auto press = [this](Key key) {
    test_support::push_key(key, true);
    test_support::push_key(key, false);
    frame();
  };
  start_first_swing([&] { press(Key::right); }, [&] { press(Key::enter); });
  const engine::Replay wanted = engine::load_replay(golden());
  std::uint16_t before = 0;
  std::size_t ticks = 0;
  for (; screen() == "first_swing" && ticks < wanted.ticks.size(); ++ticks) {
    const std::uint16_t buttons = wanted.ticks[ticks].input.buttons;
    change_buttons(before, buttons, [](const KeyOf& key, bool down) { test_support::push_key(key.key, down); });
    before = buttons;
    frame();
  }
  change_buttons(before, 0, [](const KeyOf& key, bool down) { test_support::push_key(key.key, down); });
  for (int k = 0; k < 60 && screen() == "first_swing"; ++k) frame();
  ASSERT_EQ(screen(), "results");
  app->draw();
  const std::string recording = data() + "/ropeswing/runs/000001-first_swing.replay";
  expect_same_run(recording, 300);
  EXPECT_TRUE(engine::load_replay(recording).complete);
  const Level level = load_level("first_swing");
  const LevelKey key{level.name, level.map.content_hash};
  ASSERT_TRUE(app->session().records.best(key));
  EXPECT_TRUE(std::filesystem::exists(app->session().records.replay_path(key)));

  press(Key::r);  // once more: beside the ghost
  EXPECT_EQ(screen(), "first_swing");
  EXPECT_EQ(play().simulation().ticks(), 0);
  press(Key::escape);
  EXPECT_EQ(screen(), "paused");
  app->draw();
  press(Key::up);
  press(Key::up);
  press(Key::enter);
  EXPECT_EQ(screen(), "levels");
  press(Key::escape);
  EXPECT_EQ(screen(), "title");
  test_support::push_quit();
  EXPECT_FALSE(frame());
  EXPECT_EQ(app->finish(), 0);
}

TEST_F(Journey, AFinishedRunIsWatchedAndVerified) {
  RunOptions options;
  options.level = "first_swing";
  open(options);
  const engine::Replay wanted = engine::load_replay(golden());
  std::uint16_t before = 0;
  for (std::size_t k = 0; k <= wanted.ticks.size() + 60 && screen() == "first_swing"; ++k) {
    const std::uint16_t buttons = k < wanted.ticks.size() ? wanted.ticks[k].input.buttons : std::uint16_t{0};
    change_buttons(before, buttons, [](const KeyOf& key, bool down) { test_support::push_key(key.key, down); });
    before = buttons;
    frame();
  }
  ASSERT_EQ(screen(), "results");
  change_buttons(before, 0, [](const KeyOf& key, bool down) { test_support::push_key(key.key, down); });
  tap(Key::down);  // Once more, Watch this run
  tap(Key::enter);
  ASSERT_EQ(screen(), "first_swing, a replay");
  const PlayScreen& watched = play();
  for (int k = 0; k < 5000 && !watched.is_over(); ++k) frame();
  EXPECT_EQ(watched.run().closing_line().rfind("verified ", 0), 0U) << watched.run().closing_line();
  app->draw();
  tap(Key::escape);
  EXPECT_EQ(screen(), "results");
}

}  // namespace

/// Plays from the title to the goal and back to the levels by a gamepad, which is unplugged four times.
void Journey::play_by_gamepad() {
  open();
  auto pad = std::make_unique<VirtualPad>();
  frame();
  EXPECT_EQ(app->session().notice.text(), "A gamepad is plugged in");
  const auto press = [&](PadButton button) {
    pad->press(button, true);
    frame();
    pad->press(button, false);  // takes effect in the next frame, on any screen
  };
  start_first_swing([&] { press(PadButton::dpad_right), frame(); }, [&] { press(PadButton::a); });
  EXPECT_TRUE(app->session().uses_pad);
  const engine::Replay wanted = engine::load_replay(golden());
  const auto to_pad = [&](const KeyOf& key, bool down) { pad->press(key.pad, down); };
  constexpr std::array<std::size_t, 4> unplugged_after = {60, 131, 200, 302};
  std::uint16_t before = 0;
  for (std::size_t k = 0; screen() == "first_swing" && k < wanted.ticks.size(); ++k) {
    if (std::count(unplugged_after.begin(), unplugged_after.end(), k) != 0) {
      const int ticks = play().simulation().ticks();
      pad.reset();
      frame();
      EXPECT_EQ(screen(), "paused");
      EXPECT_EQ(app->session().notice.text(), "The gamepad was unplugged");
      for (int idle = 0; idle < 10; ++idle) frame();
      pad = std::make_unique<VirtualPad>();
      frame();
      press(PadButton::a);  // Resume
      ASSERT_EQ(screen(), "first_swing");
      EXPECT_EQ(play().simulation().ticks(), ticks) << "it stood still";
      before = 0;
    }
    const std::uint16_t buttons = wanted.ticks[k].input.buttons;
    change_buttons(before, buttons, to_pad);
    before = buttons;
    frame();
  }
  change_buttons(before, 0, to_pad);
  for (int k = 0; k < 60 && screen() == "first_swing"; ++k) frame();
  ASSERT_EQ(screen(), "results");
  expect_same_run(data() + "/ropeswing/runs/000001-first_swing.replay", 300);
  app->draw();
  press(PadButton::b);
  EXPECT_EQ(screen(), "levels");
}

namespace {

TEST_F(Journey, AGamepadPlaysIsUnpluggedAndPluggedInAgain) { play_by_gamepad(); }

/// In a level for two, the halves of the keyboard and two gamepads move one player each.
TEST_F(Journey, TwoPlayByHalvesOfTheKeyboardAndByTwoGamepads) {
  RunOptions options;
  options.level = "pull_me_up";
  open(options);
  const auto walked = [&](int player) {
    return play().simulation().player(player).position().x - (player == 0 ? 16.6 : 12.0);
  };
  test_support::push_key(Key::d, true);
  test_support::push_key(Key::left, true);
  for (int k = 0; k < 15; ++k) frame();
  EXPECT_GT(walked(0), 0.3);
  EXPECT_LT(walked(1), -0.3);
  test_support::push_key(Key::d, false);
  test_support::push_key(Key::left, false);
  tap(Key::r);
  VirtualPad first;
  VirtualPad second;
  frame();
  first.press(PadButton::dpad_right, true);
  second.press(PadButton::dpad_left, true);
  for (int k = 0; k < 15; ++k) frame();
  EXPECT_GT(walked(0), 0.3);
  EXPECT_LT(walked(1), -0.3);
  app->draw();
}

/// The same in a window of an X server.
class RealWindowJourney : public Journey {
 protected:
  void SetUp() override {
    if (std::system("command -v Xvfb >/dev/null") != 0) GTEST_SKIP() << "Xvfb is not installed";
    ASSERT_TRUE(server_.starts());
    setenv("DISPLAY", server_.display().c_str(), 1);
    setenv("SDL_VIDEODRIVER", "x11", 1);
    setenv("SDL_RENDER_DRIVER", "software", 1);
    setenv("SDL_FRAMEBUFFER_ACCELERATION", "0", 1);  // nor by OpenGL from there on: Mesa's library leaks
    // SDL asks for the session's bus, and libdbus leaks memory then.
    setenv("DBUS_SESSION_BUS_ADDRESS", "unix:path=/nowhere", 1);
  }
  void TearDown() override {
    app.reset();  // before its display ends
    unsetenv("SDL_RENDER_DRIVER");
    unsetenv("SDL_FRAMEBUFFER_ACCELERATION");
    unsetenv("DBUS_SESSION_BUS_ADDRESS");
  }

 private:
  test_support::XServer server_{"1280x720x24"};
};

TEST_F(RealWindowJourney, AGamepadPlaysIsUnpluggedAndPluggedInAgain) { play_by_gamepad(); }

TEST_F(Journey, AWindowThatLosesTheFocusPausesAndReleasesAllButtons) {
  RunOptions options;
  options.level = "first_swing";
  open(options);
  test_support::push_key(Key::d, true);
  for (int k = 0; k < 20; ++k) frame();
  const int ticks = play().simulation().ticks();
  test_support::push_focus_lost();
  frame();
  EXPECT_EQ(screen(), "paused");
  for (int k = 0; k < 10; ++k) frame();
  tap(Key::escape);
  ASSERT_EQ(screen(), "first_swing");
  EXPECT_LE(play().simulation().ticks(), ticks + 1) << "it stood still";
  for (int k = 0; k < 30; ++k) frame();
  EXPECT_NEAR(static_cast<double>(play().simulation().player().body().GetLinearVelocity().x), 0.0, 0.01)
      << "the key went up unseen";
  EXPECT_FALSE(play().played().is_assisted()) << "a pause is no help";
}

TEST_F(Journey, AReboundKeyIsSavedAndWorks) {
  open();
  tap(Key::down);
  tap(Key::down);
  tap(Key::enter);
  ASSERT_EQ(screen(), "options");
  tap(Key::enter);
  ASSERT_EQ(screen(), "keys and buttons");
  for (int k = 0; k < static_cast<int>(Action::jump); ++k) tap(Key::down);
  tap(Key::enter);
  app->draw();
  tap(Key::j);
  EXPECT_EQ(app->session().settings.bindings.action_of(Key::j), Action::jump);
  app->finish();
  app.reset();

  RunOptions options;
  options.level = "first_swing";
  open(options);
  EXPECT_EQ(app->session().settings.bindings.action_of(Key::j), Action::jump) << "in the next game";
  for (int k = 0; k < 30; ++k) frame();
  test_support::push_key(Key::j, true);
  frame();
  EXPECT_GT(play().simulation().player().body().GetLinearVelocity().y, 1.0F);
}

TEST_F(Journey, SlowMotionAndSingleStepsRunFewerTicksAndTheRunIsAssisted) {
  RunOptions options;
  options.level = "first_swing";
  open(options);
  const auto ticks_in = [this](int frames) {
    const int before = play().simulation().ticks();
    for (int k = 0; k < frames; ++k) frame();
    return play().simulation().ticks() - before;
  };
  EXPECT_EQ(ticks_in(40), 40);
  EXPECT_FALSE(play().played().is_assisted());
  tap(Key::x);
  EXPECT_EQ(ticks_in(40), 20);
  EXPECT_TRUE(play().played().is_assisted());
  tap(Key::x);
  EXPECT_EQ(ticks_in(40), 10);
  tap(Key::x);
  EXPECT_EQ(ticks_in(40), 40);
  tap(Key::n);
  EXPECT_EQ(ticks_in(40), 0);
  const int before = play().simulation().ticks();
  tap(Key::n);
  EXPECT_EQ(play().simulation().ticks(), before + 1);
  tap(Key::p);
  EXPECT_EQ(ticks_in(10), 10);
  app->session().settings.speed = 50;
  EXPECT_EQ(ticks_in(40), 20);
}

TEST_F(Journey, LongerArmsAndNoFallsAreDeclaredInTheRecordingWhichVerifies) {
  open();
  app->session().settings.long_reach = app->session().settings.no_fall = true;
  start_first_swing([this] { tap(Key::right); },
                    [this] {
                      test_support::push_key(Key::enter, true);
                      test_support::push_key(Key::enter, false);
                      frame();
                    });
  test_support::push_key(Key::e, true);
  test_support::push_key(Key::d, true);
  for (int k = 0; k < 120; ++k) frame();
  test_support::push_key(Key::e, false);
  for (int k = 0; k < 240; ++k) frame();
  EXPECT_TRUE(play().played().is_assisted());
  EXPECT_TRUE(play().run().level().assists.no_fall);
  EXPECT_EQ(play().simulation().player().tuning().grab_range, Assists::long_grab_range);
  test_support::push_quit();
  frame();
  app->finish();
  const std::string recording = data() + "/ropeswing/runs/000001-first_swing.replay";
  const test_support::Ended ended = test_support::ropeswing("--headless --verify --replay " + recording);
  EXPECT_EQ(ended.status, 0) << ended.output;
}

TEST_F(Journey, WithoutAWritableFolderTheGameReportsItAndRuns) {
  setenv("XDG_CONFIG_HOME", "/proc/nowhere", 1);
  setenv("XDG_DATA_HOME", "/proc/nowhere", 1);
  RunOptions options;
  options.level = "first_swing";
  open(options);
  EXPECT_NE(app->session().notice.text().find("not recorded"), std::string::npos);
  for (int k = 0; k < 60; ++k) frame();
  EXPECT_GE(play().simulation().ticks(), 60);
  app->session().settings.speed = 90;
  frame();
  EXPECT_NE(app->session().notice.text().find("settings cannot be written"), std::string::npos);
  EXPECT_EQ(app->finish(), 0);
}

}  // namespace
}  // namespace game
