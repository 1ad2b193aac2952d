// The player holds on to a ledge.

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

/// Returns a level whose ground is up to y = 1 m.
Level level_with(std::vector<MapObject> objects) { return level_of(small_map(std::move(objects), {10.0, 1.0}, 1.0)); }

constexpr double top = 4.4;  // m, of the wall: too high for a jump

/// Jumps at the wall, with these buttons on the way down.
Simulation jump_at_wall(const Level& level, int buttons_of_fall) {
  Simulation simulation(level);
  for (int k = 0; k < 30; ++k) simulation.tick(press(button_right));
  for (int k = 0; k < 40; ++k) simulation.tick(press(button_right | button_jump));
  for (int k = 0; k < 30; ++k) simulation.tick(press(buttons_of_fall));
  return simulation;
}

Level wall() { return level_with({ground({14.0, 1.0}, {20.0, top})}); }

TEST(Ledge, IsHeldByAHandAtItsEdge) {
  const Level level = wall();
  Simulation simulation = jump_at_wall(level, button_right | button_grab);
  ASSERT_TRUE(simulation.player().ledge());
  for (int k = 0; k < 60; ++k) simulation.tick(press(button_grab));
  const Player& player = simulation.player();
  ASSERT_TRUE(player.ledge());
  EXPECT_NEAR(player.ledge()->edge.x, 14.0, 1e-3);
  EXPECT_NEAR(player.ledge()->edge.y, top, 1e-3);
  EXPECT_NEAR(player.hand().y, top, 1e-3);
  EXPECT_NEAR(player.position().x, 14.0 - player.tuning().radius, 0.02);
}

TEST(Ledge, IsLeftUpwardsByAJump) {
  const Level level = wall();
  Simulation simulation = jump_at_wall(level, button_right | button_grab);
  ASSERT_TRUE(simulation.player().ledge());
  for (int k = 0; k < 90; ++k) simulation.tick(press(button_right | button_jump));
  EXPECT_TRUE(simulation.player().is_on_ground());
  EXPECT_GT(simulation.player().position().y, top);
}

TEST(Ledge, IsNotHeldWithoutTheKeyOrOnTheWayUp) {
  const Level level = wall();
  EXPECT_FALSE(jump_at_wall(level, button_right).player().ledge());
  Simulation simulation = jump_at_wall(level, button_right | button_grab);
  ASSERT_TRUE(simulation.player().ledge());
  for (int k = 0; k < 60; ++k) simulation.tick({});
  EXPECT_FALSE(simulation.player().ledge());
  EXPECT_TRUE(simulation.player().is_on_ground());
  EXPECT_LT(simulation.player().position().y, 2.0);
}

/// A ledge is a level top with room above it.
TEST(Ledge, IsNotUnderARoofOrOnASlope) {
  const Level roofed = level_with({ground({14.0, 1.0}, {20.0, top}), ground({14.0, top + 0.1}, {20.0, top + 2.0})});
  EXPECT_FALSE(jump_at_wall(roofed, button_right | button_grab).player().ledge());
  MapObject slope = engine::thing(0, "ground", MapShape::polygon, {14.0, 1.0});
  slope.points = {{14.0, 1.0}, {20.0, 1.0}, {20.0, top + 4.0}, {14.0, top}};
  const Level sloping = level_with({slope});
  EXPECT_FALSE(jump_at_wall(sloping, button_right | button_grab).player().ledge());
}

TEST(Ledge, IsLeftForALine) {
  const Level level = level_with({ground({14.0, 1.0}, {20.0, top}), point_of(0, "hook", {11.0, 7.0})});
  Simulation simulation = jump_at_wall(level, button_right | button_grab);
  ASSERT_TRUE(simulation.player().ledge());
  run(simulation, 1, button_grab | button_throw);
  for (int k = 0; k < 30 && !simulation.player().line().is_held(); ++k) run(simulation, 1, button_grab);
  ASSERT_TRUE(simulation.player().line().is_held());
  EXPECT_FALSE(simulation.player().ledge());
  run(simulation, 60, button_grab | button_reel_in);
  EXPECT_LT(simulation.player().position().x, 13.0) << "it swings on the line";
}

TEST(Ledge, IsHeldAfterGoingBack) {
  const Level level = wall();
  Simulation simulation = jump_at_wall(level, button_right | button_grab);
  SavedTick saved;
  simulation.save(saved);
  for (int k = 0; k < 30; ++k) simulation.tick({});
  ASSERT_TRUE(simulation.restore(saved, nullptr));
  ASSERT_TRUE(simulation.player().ledge());
  const Vec2 before = simulation.player().position();
  for (int k = 0; k < 30; ++k) simulation.tick(press(button_grab));
  EXPECT_LT(length(simulation.player().position() - before), 0.1);
}

}  // namespace
}  // namespace game
