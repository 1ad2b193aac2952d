// A level whose file changes during play. The test sets the time, so it does not wait.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "engine/scene/tiled_edit.h"
#include "game/program/app.h"
#include "game/screens/play_screen.h"
#include "tests/game/program.h"
#include "tests/support/environment.h"

namespace {

using namespace test_support;

constexpr std::int64_t frame_ns = 1'000'000'000 / 60;

/// The program in a dummy window, with a level of this test.
struct Played {
  std::string path = scratch("played.tmj");
  std::string text = bytes_of(TEST_ASSETS "/levels/first_swing.tmj");
  Environment video{"SDL_VIDEODRIVER", "dummy"};
  Environment audio{"SDL_AUDIODRIVER", "none_of_that_name"};
  Environment config{"XDG_CONFIG_HOME", scratch("config").c_str()};
  Environment data{"XDG_DATA_HOME", scratch("data").c_str()};
  int written = 0;

  std::unique_ptr<game::App> app;

  Played() {
    write_bytes(path, text);
    game::RunOptions options;
    options.level = path;
    app = std::make_unique<game::App>(options);
  }

  const game::PlayScreen& screen() const { return dynamic_cast<const game::PlayScreen&>(app->screens().top()); }
  void frames(int count, std::int64_t each = frame_ns, const engine::WindowInput& input = {}) {
    for (int k = 0; k < count; ++k) ASSERT_TRUE(app->update(input, each));
  }
  void press(engine::Key key) {
    engine::WindowInput input;
    input.keys_pressed.set(static_cast<std::size_t>(key));
    frames(1, frame_ns, input);
  }
  /// Saves the file as an editor does, with a new time each time.
  void save(const std::string& changed) {
    write_bytes(path, changed);
    fs::last_write_time(path, fs::last_write_time(path) + std::chrono::seconds(++written));
  }
  void wait_a_second() { frames(4, 300'000'000); }
};

TEST(Reload, ALevelRestartsWhenItsFileHasChanged) {
  Played played;
  played.frames(30);
  EXPECT_GE(played.screen().simulation().run_ticks(), 28);
  played.save(engine::with_property(played.text, engine::map_itself, "gravity_y", -4.0));
  played.wait_a_second();
  EXPECT_EQ(played.app->session().notice.text(), "The level was reloaded");
  EXPECT_EQ(played.screen().simulation().scene().world().GetGravity().y, -4.0F);
  EXPECT_LT(played.screen().simulation().run_ticks(), 30);
  EXPECT_FALSE(played.screen().run().is_tuned()) << "it is the file's";
}

TEST(Reload, ABrokenFileIsReportedAndTheOldLevelContinues) {
  Played played;
  played.frames(30);
  played.save(played.text.substr(0, 500));
  played.wait_a_second();
  EXPECT_NE(played.app->session().notice.text().find("played.tmj"), std::string::npos)
      << played.app->session().notice.text();
  const int ticks = played.screen().simulation().run_ticks();
  EXPECT_GE(ticks, 30);
  played.frames(10);
  EXPECT_GE(played.screen().simulation().run_ticks(), ticks + 9);
  played.save(played.text + "\n");
  played.wait_a_second();
  EXPECT_EQ(played.app->session().notice.text(), "The level was reloaded");
}

TEST(Reload, AFileSavedWithoutAChangeDoesNotEndTheRun) {
  Played played;
  played.frames(30);
  played.save(played.text);
  played.wait_a_second();
  EXPECT_EQ(played.app->session().notice.text(), "");
  EXPECT_GE(played.screen().simulation().run_ticks(), 30);
}

TEST(Panel, F2ShowsAndHidesIt) {
  Played played;
  played.frames(5);
  played.app->draw();
  const auto pixels = [&] { return played.app->window().raster().pixels(); };
  const auto before = pixels();
  played.press(engine::Key::f2);
  played.frames(2);
  played.app->draw();
  const auto after = pixels();
  std::size_t changed = 0;
  for (std::size_t k = 0; k < before.size(); ++k) changed += after[k] != before[k];
  EXPECT_GT(changed, before.size() / 5) << "a panel over a fifth of the picture";
}

}  // namespace
