#include "game/screens/card_grid.h"

#include <gtest/gtest.h>

#include "game/screens/level_screen.h"
#include "tests/game/program.h"
#include "tests/game/screens/text_canvas.h"
#include "tests/support/environment.h"

namespace game {
namespace {

constexpr GridPlace place{{0.0, 0.0}, {700.0, 420.0}, 1.0};  // three columns

CardGrid grid_of(int cards) {
  CardGrid grid;
  grid.set_cards(std::vector<PictureCard>(static_cast<std::size_t>(cards), {"A level"}));
  return grid;
}

TEST(CardGrid, TheFocusMovesInFourDirectionsAndWrapsAround) {
  ASSERT_EQ(place.columns(), 3);
  CardGrid grid = grid_of(8);
  const auto after = [&grid](const MenuInput& input) {
    EXPECT_EQ(grid.update(input, place), std::nullopt);
    return grid.focus();
  };
  EXPECT_EQ(after({.right = 1}), 1);
  EXPECT_EQ(after({.down = 1}), 4);
  EXPECT_EQ(after({.down = 2}), 1) << "over the last row";
  EXPECT_EQ(after({.down = -1}), 7);
  EXPECT_EQ(after({.right = 1}), 0);
  EXPECT_EQ(after({.right = -1}), 7);
  EXPECT_EQ(after({.down = -1}), 4);
  EXPECT_EQ(after({.down = 1, .right = 1}), 7) << "the last row is shorter";
  EXPECT_EQ(grid.update({.accept = true}, place), 7);
  CardGrid empty;
  EXPECT_EQ(empty.update({.down = 1, .right = 1, .accept = true}, place), std::nullopt);
}

TEST(CardGrid, ScrollsToItsFocusAndTheMouseChoosesWhatItShows) {
  CardGrid grid = grid_of(20);
  ASSERT_EQ(place.rows(), 2);
  EXPECT_FALSE(grid.shows(19, place));
  const ribbon::Vec2 first = 0.5 * place.cell();
  EXPECT_EQ(grid.update({.clicked = true, .mouse = first}, place), 0);
  for (int k = 0; k < 3; ++k) grid.update({.down = 1, .mouse = first}, place);
  EXPECT_EQ(grid.focus(), 9) << "a mouse at rest does not hold the focus";
  EXPECT_TRUE(grid.shows(9, place));
  EXPECT_EQ(grid.update({.clicked = true, .mouse = first}, place), 6) << "the third row is the first visible one";
  EXPECT_EQ(grid.update({.clicked = true, .mouse = {-5.0, 20.0}}, place), std::nullopt);
}

TEST(LevelCards, HavePicturesOfTheLevelsSoonAfterTheyAreShown) {
  Session session{"", ""};
  LevelScreen screen(session);
  const engine::HeadlessCanvas canvas(1280, 720);
  const std::vector<std::string> names = level_names();
  for (std::size_t k = 0; k < names.size(); ++k) {
    screen.update({engine::WindowInput{}, MenuInput{}, canvas, 16'666'667, 1.0});
  }
  for (const std::string& name : names) EXPECT_NE(session.level_pictures.of(load_level(name), false), nullptr) << name;
}

TEST(LevelCards, WithoutLevelsTheScreenSaysWhereItLookedAndWhatToDo) {
  const std::string nowhere = test_support::scratch("no_assets");
  const test_support::Environment assets("ROPESWING_ASSETS", nowhere.c_str());
  Session session{"", ""};
  LevelScreen screen(session);
  TextCanvas canvas(640, 360);
  EXPECT_EQ(screen.update({engine::WindowInput{}, {.accept = true}, canvas, 1, 0.65}).what, Next::What::stay);
  screen.draw(canvas, 0.65);
  std::string said = canvas.all();
  std::erase(said, '\n');
  EXPECT_NE(said.find(nowhere + "/levels"), std::string::npos) << said;
  EXPECT_NE(said.find("ROPESWING_ASSETS"), std::string::npos) << said;
  EXPECT_EQ(canvas.faults(), "");
  EXPECT_EQ(screen.update({engine::WindowInput{}, {.back = true}, canvas, 1, 0.65}).what, Next::What::back);
}

}  // namespace
}  // namespace game
