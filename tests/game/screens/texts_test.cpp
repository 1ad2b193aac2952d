// No text of any screen is cut, hidden by a panel or overlapped by another text.

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <sstream>
#include <string>

#include "game/screens/controls_screen.h"
#include "game/screens/help.h"
#include "game/screens/last_seconds_screen.h"
#include "game/screens/level_facts.h"
#include "game/screens/level_screen.h"
#include "game/screens/options_screen.h"
#include "game/screens/pause_screen.h"
#include "game/screens/play_screen.h"
#include "game/screens/results_screen.h"
#include "game/screens/title_screen.h"
#include "game/view/hud.h"
#include "tests/game/program.h"
#include "tests/game/screens/text_canvas.h"

namespace game {
namespace {

using engine::Key;

class Texts : public testing::TestWithParam<CanvasSize> {
 protected:
  Texts() : canvas(GetParam().width, GetParam().height), scale(text_scale_of(canvas, 1.0)) {}

  void press(Screen& screen, std::initializer_list<Key> keys) const {
    for (const Key key : keys) {
      engine::WindowInput input;
      input.keys_pressed.set(static_cast<std::size_t>(key));
      const MenuInput menu;
      screen.update({input, menu, canvas, frame_ns, scale});
    }
  }
  void wait(Screen& screen, int frames = 3) const {
    const engine::WindowInput input;
    const MenuInput menu;
    for (int k = 0; k < frames; ++k) screen.update({input, menu, canvas, frame_ns, scale});
  }

  /// Draws a screen and the notice, if there is one, as the program does.
  std::string draw(Screen& screen, Screen* below = nullptr) {
    canvas.forget();
    if (below != nullptr) below->draw_below(canvas, scale);
    screen.draw(canvas, scale);
    const std::string& notice = session.notice.text();
    if (!notice.empty() && !screen.shows_notice()) draw_notice(canvas, notice, scale);
    return canvas.all();
  }
  static std::set<std::string> of_world(const Level& level, const Session& session) {
    std::set<std::string> texts;
    for (const std::string& sign : signs_in_words(level, session.settings, session.uses_pad)) {
      std::istringstream lines(sign);
      for (std::string line; std::getline(lines, line);) texts.insert(line);
    }
    return texts;
  }
  /// Draws a menu with and without a notice.
  void expect_readable(Screen& menu, const std::string& what) {
    for (const char* notice : {"",
                               "/home/a_player/.local/share/ropeswing/best.json: cannot be written: "
                               "no space left on device, so that times of this and of later runs are lost"}) {
      session.notice.show(notice);
      draw(menu);
      EXPECT_EQ(canvas.faults(), "") << what;
    }
    session.notice.show("");
  }

  TextCanvas canvas;
  double scale;
  Session session{"", ""};
};

INSTANTIATE_TEST_SUITE_P(Sizes, Texts,
                         testing::Values(CanvasSize{640, 360}, CanvasSize{1280, 720}, CanvasSize{2560, 1440}),
                         size_name);

TEST_P(Texts, OfMenusAreReadable) {
  TitleScreen title(session);
  wait(title);
  draw(title);
  EXPECT_EQ(canvas.faults(of_world(load_level(default_level), session), true), "");
  OptionsScreen options(session);
  ControlsScreen controls(session);
  ControlsScreen of_second(session);
  const engine::WindowInput none;
  of_second.update({none, {.down = -3}, canvas, frame_ns, scale});
  of_second.update({none, {.right = 1}, canvas, frame_ns, scale});
  EXPECT_NE(draw(of_second).find(words::second_player), std::string::npos);
  expect_readable(of_second, "keys of the second player");
  for (Screen* menu : {static_cast<Screen*>(&options), static_cast<Screen*>(&controls)}) {
    const engine::WindowInput input;
    for (int row = 0; row < 30; ++row) {
      expect_readable(*menu, menu->title() + ", row " + std::to_string(row));
      menu->update({input, {.down = 1}, canvas, frame_ns, scale});
    }
  }
}

/// The run behind the title shows its player beside the menu, all along.
TEST_P(Texts, OfTheTitleDoNotCoverThePlayer) {
  TitleScreen title(session);
  ASSERT_NE(title.run(), nullptr);
  for (int k = 0; k < 80; ++k) {
    wait(title, 10);
    draw(title);
    const double x = canvas.to_pixels(title.run()->simulation().player().position()).x;
    ASSERT_GT(x, canvas.last_panel_at_left()) << k;
    ASSERT_LT(x, canvas.width()) << k;
  }
}

TEST_P(Texts, OfTheChangeOfAKeyAreReadable) {
  ControlsScreen controls(session);
  const engine::WindowInput input;
  for (std::size_t row = 0; row < all_actions().size(); ++row) {
    controls.update({input, {.accept = true}, canvas, frame_ns, scale});
    expect_readable(controls, "waits");
    press(controls, {row == 0 ? Key::z : Key::left});
    expect_readable(controls, "asks");
    press(controls, {Key::escape});
    controls.update({input, {.down = 1}, canvas, frame_ns, scale});
  }
}

TEST_P(Texts, OfTheListOfLevelsAreReadable) {
  std::string ignored;
  const std::vector<Level> levels = levels_in_order();
  for (std::size_t k = 0; k < levels.size(); k += 2) {
    session.records.offer(level_key(levels[k]), {static_cast<int>(400 + 100 * k), k % 4 == 0}, "", ignored);
  }
  LevelScreen screen(session);
  const engine::WindowInput input;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    expect_readable(screen, levels[k].name);
    screen.update({input, {.right = 1}, canvas, frame_ns, scale});
  }
}

/// All tests here rest on it.
TEST(TextCanvas, FindsWhatIsCutHiddenOrOverlaps) {
  const engine::Color white{255, 255, 255};
  TextCanvas canvas(200, 100);
  canvas.text({10.0, 10.0}, "one", 20.0, white);
  EXPECT_EQ(canvas.faults(), "");
  canvas.text({20.0, 15.0}, "two", 20.0, white);
  EXPECT_EQ(canvas.faults(), "overlap: one | two\n");
  canvas.forget();
  canvas.text({-5.0, 10.0}, "left", 20.0, white);
  EXPECT_EQ(canvas.faults(), "cut: left\n");
  canvas.forget();
  canvas.text({10.0, 10.0}, "under", 20.0, white);
  canvas.panel({0.0, 0.0}, {100.0, 60.0}, 0.0, {1, 2, 3});
  EXPECT_EQ(canvas.faults(), "hidden by a panel: under\n");
}

/// Everything that a run can show at once, at the start of every level.
TEST_P(Texts, OfEveryLevelAreReadable) {
  for (const std::string& name : level_names()) {
    RunOptions asked;
    asked.level = name;
    session.settings = {};
    PlayScreen play(session, asked, false);
    play.shown();
    const std::set<std::string> world = of_world(play.run().level(), session);
    const auto expect_fine = [&](const char* what) {
      wait(play);
      draw(play);
      EXPECT_EQ(canvas.faults(world), "") << name << ": " << what;
    };
    expect_fine("hint");
    session.settings.strain_tint = true;
    expect_fine("legend");
    session.notice.show("Screenshot: /home/a_player/Pictures/ropeswing-12.png");
    expect_fine("notice");
    session.settings.help = true;
    expect_fine("help");
    press(play, {Key::f3});
    expect_fine("figures");
    press(play, {Key::f2});
    expect_fine("panel");
    press(play, {Key::f3});
    expect_fine("panel without figures");
    session.settings.help = false;
    session.settings.strain_tint = false;
    expect_fine("panel without help");
    session.notice.show("");
  }
}

TEST_P(Texts, OfARunUnderAMenuAreReadable) {
  RunOptions asked;
  asked.level = "pump_it_up";
  PlayScreen play(session, asked, false);
  play.shown();
  wait(play, 30);
  const std::set<std::string> world = of_world(play.run().level(), session);
  PauseScreen pause(session, play);
  OptionsScreen options(session);
  for (Screen* menu : {static_cast<Screen*>(&pause), static_cast<Screen*>(&options)}) {
    draw(*menu, &play);
    EXPECT_EQ(canvas.faults(world, true), "") << menu->title();
  }
}

TEST_P(Texts, OfResultsAreReadable) {
  RunOptions asked;
  asked.replay = test_support::golden();
  PlayScreen play(session, asked, false);
  play.shown();
  while (!play.is_over()) wait(play, 1);
  ASSERT_TRUE(play.simulation().goal_ticks());
  draw(play);
  EXPECT_EQ(canvas.faults(of_world(play.run().level(), session)), "");
  for (const bool assisted : {false, true}) {
    if (assisted) play.played().mark_assisted();
    ResultsScreen results(session, play);
    draw(results, &play);
    EXPECT_EQ(canvas.faults(of_world(play.run().level(), session), true), "");
  }
}

/// Before they begin, in motion, at their end, and with another preset.
TEST_P(Texts, OfTheLastSecondsAreReadable) {
  RunOptions asked;
  asked.replay = std::string(TEST_ASSETS "/replays/up_the_shaft.replay");
  RecordedRun run(asked);
  run.seek(900);
  LastSecondsScreen screen(session, run.level(), run.inputs(), presets().front());
  const std::set<std::string> world = of_world(run.level(), session);
  EXPECT_NE(draw(screen).find("repeating the run: 0 %"), std::string::npos);
  EXPECT_EQ(canvas.faults(world), "");
  while (!screen.is_ready()) wait(screen, 1);
  while (!screen.runs().is_over()) {
    wait(screen, 40);
    EXPECT_NE(draw(screen).find("apart now"), std::string::npos);
    ASSERT_EQ(canvas.faults(world), "");
  }
  wait(screen, 70);
  EXPECT_FALSE(screen.runs().is_over()) << "they begin again";

  const engine::WindowInput input;
  const auto turn = [&](int right) { return screen.update({input, {.right = right}, canvas, frame_ns, scale}).what; };
  EXPECT_EQ(turn(1), Next::What::stay);
  EXPECT_STREQ(screen.preset().name, "balanced");
  EXPECT_EQ(screen.runs().other().ticks(), screen.runs().played().ticks());
  turn(5);
  EXPECT_STREQ(screen.preset().name, "accurate");
  EXPECT_EQ(screen.update({input, {.back = true}, canvas, frame_ns, scale}).what, Next::What::back);
}

/// A medal stands beside the time, whatever its name is.
TEST_P(Texts, OfResultsAreBesideTheMedal) {
  RunOptions asked;
  asked.replay = test_support::golden();
  PlayScreen play(session, asked, false);
  play.shown();
  while (!play.is_over()) wait(play, 1);
  for (const Medals& medals : {Medals{900.0, 950.0, 990.0}, Medals{1.0, 900.0, 950.0}, Medals{1.0, 2.0, 900.0}}) {
    const_cast<Level&>(play.run().level()).medals = medals;
    ResultsScreen results(session, play);
    const std::string texts = draw(results, &play);
    EXPECT_NE(texts.find("!\n"), std::string::npos) << texts;
    EXPECT_EQ(canvas.faults(of_world(play.run().level(), session), true), "");
  }
}

/// A run moves the signs of its level below the boxes of the HUD, which make way.
TEST_P(Texts, OfRunsInMotionAreReadable) {
  for (const char* level : {"rolling_bridge", "curtains", "heavy_load", "long_line"}) {
    RunOptions asked;
    asked.replay = std::string(TEST_ASSETS "/replays/") + level + ".replay";
    session.settings.help = true;
    session.notice.show("A gamepad is plugged in");
    PlayScreen play(session, asked, false);
    play.shown();
    const std::set<std::string> world = of_world(play.run().level(), session);
    while (!play.is_over()) {
      wait(play, 20);
      draw(play);
      ASSERT_EQ(canvas.faults(world), "") << level << ", tick " << play.simulation().ticks();
    }
  }
}

/// The player stands beside a sign or below its board at the start of a level.
TEST_P(Texts, OfSignsAreNotBehindThePlayerAtTheStart) {
  for (const std::string& name : level_names()) {
    RunOptions asked;
    asked.level = name;
    PlayScreen play(session, asked, false);
    play.shown();
    wait(play);
    draw(play);
    const Player& player = play.simulation().player();
    const ribbon::Vec2 half{player.tuning().radius, 0.5 * player.tuning().height};
    const ribbon::Vec2 low = canvas.to_pixels(player.position() - half);
    const ribbon::Vec2 high = canvas.to_pixels(player.position() + half);
    EXPECT_EQ(canvas.texts_in({{low.x, high.y}, {high.x - low.x, low.y - high.y}}), "") << name;
  }
}

}  // namespace
}  // namespace game
