// Blades and knives cut the lines of players too.

#include <gtest/gtest.h>

#include "tests/game/simulation/small_level.h"
#include "tests/support/level_for_two.h"

namespace game {
namespace {

/// A level with a knife, rings at these places and a blade.
Level level_with(std::vector<Vec2> hooks, std::vector<Vec2> edge, Vec2 feet = {8.0, 2.0}) {
  std::vector<MapObject> objects;
  for (const Vec2 hook : hooks) objects.push_back(point_of(0, "hook", hook));
  objects.push_back(line_of(0, "blade", std::move(edge)));
  engine::TiledMap map = small_map(std::move(objects), feet);
  map.properties.insert("knife", true);
  return level_of(std::move(map));
}

/// Throws the line, or lets go of it, with the pointer at a place.
void press_throw(Simulation& simulation, Vec2 pointer) {
  engine::TickInput input = press(button_throw);
  engine::set_pointer(input, pointer);
  simulation.tick(input);
  engine::TickInput wait = press(0);
  engine::set_pointer(wait, pointer);
  for (int k = 0; k < 30; ++k) simulation.tick(wait);
}

const Line& line(const Simulation& simulation) { return simulation.player().line(); }
int cords(const Simulation& simulation) { return simulation.scene().coupling().size(); }

TEST(CutLines, ABladeCutsTheLineThatIsHeld) {
  const Level level = level_with({{8.0, 9.0}}, {{3.5, 6.0}, {6.5, 6.0}});
  Simulation simulation(level);
  press_throw(simulation, {8.0, 9.0});
  ASSERT_TRUE(line(simulation).is_held());
  run(simulation, 60, button_left);
  EXPECT_EQ(line(simulation).state(), Line::State::stowed);
  EXPECT_FALSE(line(simulation).cord());
  ASSERT_EQ(cords(simulation), 2) << "the pieces stay";
  const auto ids = simulation.scene().coupling().cords();
  EXPECT_EQ(simulation.scene().coupling().cord(ids[0]).positions().front(), (Vec2{8.0, 9.0}));
  EXPECT_FALSE(simulation.player().held_place(simulation.scene().coupling()));
  run(simulation, 60, button_right);
  press_throw(simulation, {8.0, 9.0});
  EXPECT_TRUE(line(simulation).is_held()) << "a new one";
  run(simulation, 1, button_retry);
  EXPECT_EQ(cords(simulation), 0) << "after a fall all is as at the start";
}

TEST(CutLines, GoBack) {
  const Level level = level_with({{8.0, 9.0}}, {{3.5, 6.0}, {6.5, 6.0}});
  std::vector<int> buttons(20, 0);
  buttons.insert(buttons.end(), 100, button_left);
  buttons[0] = button_throw;
  expect_goes_back(level, 120, buttons);
}

/// Between the two rings is a blade, through which neither line goes.
TEST(CutLines, ABladeDoesNotCutALineThatIsThrownAgainElsewhere) {
  const Level level = level_with({{4.0, 9.0}, {12.0, 9.0}}, {{8.0, 5.5}, {8.0, 8.5}});
  Simulation simulation(level);
  press_throw(simulation, {4.0, 9.0});
  ASSERT_TRUE(line(simulation).is_held());
  press_throw(simulation, {4.0, 9.0});
  ASSERT_EQ(line(simulation).state(), Line::State::released);
  press_throw(simulation, {12.0, 9.0});
  EXPECT_TRUE(line(simulation).is_held());
  EXPECT_EQ(cords(simulation), 1);
}

TEST(CutLines, TheKnifeSparesTheLineInTheHandAndCutsTheReleasedOne) {
  const Level level = level_with({{8.5, 6.0}}, {{20.0, 5.0}, {21.0, 5.0}});
  Simulation simulation(level);
  press_throw(simulation, {8.5, 6.0});
  ASSERT_TRUE(line(simulation).is_held());
  run(simulation, 2, button_cut);
  EXPECT_TRUE(line(simulation).is_held());
  EXPECT_EQ(cords(simulation), 1);
  press_throw(simulation, {8.5, 6.0});
  ASSERT_EQ(line(simulation).state(), Line::State::released);
  run(simulation, 2, button_cut);
  EXPECT_EQ(line(simulation).state(), Line::State::stowed);
  EXPECT_EQ(cords(simulation), 2);
}

/// The player hangs on one of two lines. The other hand holds the other one.
TEST(CutLines, TheKnifeSparesTheLinesInBothHands) {
  engine::TiledMap map = small_map({point_of(0, "hook", {7.0, 8.0}), point_of(0, "hook", {9.0, 8.0})}, {8.0, 2.0});
  map.properties.insert("knife", true);
  map.properties.insert("lines", std::int64_t{2});
  const Level level = level_of(std::move(map));
  Simulation simulation(level);
  run(simulation, 1, button_throw | button_throw_second);
  run(simulation, 30);
  run(simulation, 1, button_cut);
  for (const Line& each : simulation.player().lines().all()) EXPECT_TRUE(each.is_held());
  EXPECT_EQ(cords(simulation), 2);
}

TEST(CutLines, TheKnifeCutsAKnot) {
  const Level level = level_with({{8.5, 6.0}, {8.5, 4.5}}, {{20.0, 5.0}, {21.0, 5.0}});
  Simulation simulation(level);
  press_throw(simulation, {8.5, 6.0});
  ASSERT_TRUE(line(simulation).is_held());
  run(simulation, 1, button_tie);
  run(simulation, 60);
  ASSERT_EQ(line(simulation).state(), Line::State::stowed) << "it is tied to the lower ring";
  ASSERT_EQ(cords(simulation), 1);
  run(simulation, 1, button_cut);
  EXPECT_EQ(cords(simulation), 2);
}

/// However often it cuts, there are never more pieces than knots.
TEST(CutLines, LeaveNoMorePiecesThanThereCanBeKnots) {
  const Level level = level_with({{8.5, 6.0}}, {{20.0, 5.0}, {21.0, 5.0}});
  Simulation simulation(level);
  for (int k = 0; k < 8; ++k) {
    press_throw(simulation, {8.5, 6.0});
    press_throw(simulation, {8.5, 6.0});
    run(simulation, 2, button_cut);
    run(simulation, 2);
    EXPECT_LE(cords(simulation), static_cast<int>(Lines::most_knots) + 1);
  }
  EXPECT_GE(cords(simulation), static_cast<int>(Lines::most_knots));
}

TEST(CutLines, TheKnifeOfOnePlayerCutsTheLineOfTheOther) {
  Level level = test_support::level_for_two({.tied = false});
  level.hooks = {{11.0, 11.0}};
  level.rules.knife = true;
  Simulation simulation(level);
  run(simulation, 10);
  run(simulation, 1, 0, button_throw);
  run(simulation, 30);
  ASSERT_TRUE(simulation.player(1).line().is_held());
  while (simulation.player().position().x < 12.5) {
    ASSERT_LT(simulation.ticks(), 200);
    run(simulation, 1, button_right);
  }
  const int before = cords(simulation);
  run(simulation, 1, button_cut);
  EXPECT_EQ(simulation.player(1).line().state(), Line::State::stowed);
  EXPECT_EQ(cords(simulation), before + 1);
}

}  // namespace
}  // namespace game
