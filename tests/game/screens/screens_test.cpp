// The look of the screens, as far as a test can check it.

#include <gtest/gtest.h>

#include <string>

#include "engine/window/sdl_canvas.h"
#include "game/screens/controls_screen.h"
#include "game/screens/level_screen.h"
#include "game/screens/options_screen.h"
#include "game/screens/pause_screen.h"
#include "game/screens/play_screen.h"
#include "game/screens/results_screen.h"
#include "game/screens/title_screen.h"
#include "tests/game/program.h"

namespace game {
namespace {

/// Records the texts, and those that exceed the picture.
class MeasuringCanvas : public engine::HeadlessCanvas {
 public:
  using HeadlessCanvas::HeadlessCanvas;

  std::string all, cut;

 protected:
  void paint_text(ribbon::Vec2 at, std::string_view utf8, double size, engine::Color color) override {
    HeadlessCanvas::paint_text(at, utf8, size, color);
    (all += utf8) += '\n';
    const bool inside =
        at.x >= 0.0 && at.y >= 0.0 && at.x + text_width(utf8, size) <= width() && at.y + line_height(size) <= height();
    if (!inside) (cut += utf8) += '\n';
  }
};

struct Picture {
  int width, height;
  double scale;
};

class Screens : public testing::TestWithParam<Picture> {
 protected:
  void SetUp() override { session.settings = {}; }

  /// Draws the screen after a few frames, in which levels are read and cards are laid out.
  std::string texts_of(Screen& screen) {
    MeasuringCanvas canvas(GetParam().width, GetParam().height);
    for (int k = 0; k < 3; ++k) screen.update({{}, {}, canvas, 16'666'667, GetParam().scale});
    canvas.all.clear();
    screen.draw(canvas, GetParam().scale);
    EXPECT_EQ(canvas.cut, "");
    return canvas.all;
  }

  Session session{"", ""};
};

INSTANTIATE_TEST_SUITE_P(Sizes, Screens,
                         testing::Values(Picture{1280, 720, 1.0}, Picture{960, 540, 0.75}, Picture{1920, 1080, 1.5},
                                         Picture{640, 480, 0.65}));

TEST_P(Screens, NoTextOfMenusIsCutOff) {
  TitleScreen title(session);
  EXPECT_NE(texts_of(title).find("Quit"), std::string::npos);
  LevelScreen levels(session);
  EXPECT_NE(texts_of(levels).find("First swing"), std::string::npos);
  OptionsScreen options(session);
  EXPECT_NE(texts_of(options).find("Back"), std::string::npos) << "all lines fit";
  ControlsScreen controls(session);
  const std::string keys = texts_of(controls);
  EXPECT_NE(keys.find("Space"), std::string::npos);
  session.uses_pad = true;
  texts_of(title);
}

/// The lines at the end are the player, the defaults and Back.
TEST_P(Screens, TheKeysOfTheSecondPlayerCanBeChanged) {
  ControlsScreen controls(session);
  MeasuringCanvas canvas(GetParam().width, GetParam().height);
  const auto move = [&](const MenuInput& menu, const engine::WindowInput& input = {}) {
    controls.update({input, menu, canvas, 16'666'667, 1.0});
  };
  move({.down = -3});
  move({.right = 1});
  const std::string texts = texts_of(controls);
  EXPECT_NE(texts.find("the second player"), std::string::npos) << texts;
  EXPECT_EQ(texts.find("Take a screenshot"), std::string::npos) << "it has the actions of a run only";
  move({.down = 3});
  move({.accept = true});
  engine::WindowInput key;
  key.keys_pressed.set(static_cast<std::size_t>(engine::Key::j));
  move({}, key);
  EXPECT_EQ(session.settings.second_bindings.action_of(engine::Key::j), Action::left);
  EXPECT_FALSE(session.settings.bindings.action_of(engine::Key::j));
  move({.down = -2});  // from the first line to the defaults
  move({.accept = true});
  EXPECT_TRUE(session.settings.second_bindings == Bindings::second_defaults());
}

TEST_P(Screens, NoTextOfRunsIsCutOff) {
  RunOptions asked;
  asked.level = "first_swing";
  PlayScreen play(session, asked, false);
  play.shown();
  EXPECT_NE(texts_of(play).find("F1: help"), std::string::npos);
  EXPECT_EQ(texts_of(play).find("Space: Jump, let go"), std::string::npos);
  session.settings.help = true;
  const std::string playing = texts_of(play);
  EXPECT_NE(playing.find("Space: Jump, let go"), std::string::npos) << playing;
  session.uses_pad = true;
  EXPECT_NE(texts_of(play).find("A: Jump, let go"), std::string::npos) << "of the device that is used";
  PauseScreen pause(session, play);
  EXPECT_NE(texts_of(pause).find("Options"), std::string::npos);
}

TEST_P(Screens, NoTextOfARunOfTwoIsCutOff) {
  RunOptions asked;
  asked.level = "pull_me_up";
  PlayScreen play(session, asked, false);
  play.shown();
  EXPECT_NE(texts_of(play).find("hold Q to pull up ←"), std::string::npos) << "keys of both halves";
  session.settings.help = true;
  const std::string playing = texts_of(play);
  EXPECT_NE(playing.find("A | ←: Run or swing left"), std::string::npos) << playing;
  EXPECT_NE(playing.find("Space | Enter: Jump, let go"), std::string::npos) << playing;
  LevelScreen levels(session);
  EXPECT_NE(texts_of(levels).find("Pull me up, for two"), std::string::npos);
}

TEST_P(Screens, ResultsShowTimeAndBest) {
  const engine::Replay golden = engine::load_replay(test_support::golden());
  RunOptions asked;
  asked.replay = test_support::golden();
  PlayScreen play(session, asked, false);
  play.shown();
  MeasuringCanvas canvas(GetParam().width, GetParam().height);
  while (!play.is_over()) play.update({{}, {}, canvas, 16'666'667, 1.0});
  ASSERT_TRUE(play.simulation().goal_ticks());
  ResultsScreen first(session, play);
  EXPECT_NE(texts_of(first).find("First completion!"), std::string::npos);
  ResultsScreen again(session, play);
  const std::string same = texts_of(again);
  EXPECT_NE(same.find("Your best: "), std::string::npos) << same;
  play.played().mark_assisted();
  ResultsScreen helped(session, play);
  EXPECT_NE(texts_of(helped).find("With assists"), std::string::npos);
}

}  // namespace
}  // namespace game
