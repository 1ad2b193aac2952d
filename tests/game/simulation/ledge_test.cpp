// The player holds on to a ledge.

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/press.h"
#include "tests/support/small_level.h"

namespace game {
namespace {

using engine::MapObject;
using ribbon::Vec2;
using test_support::ground;
using test_support::small_level;

constexpr double top = 4.4;  // m, of the wall: too high for a jump

/// Jumps at the wall, with these buttons on the way down.
Simulation jump_at_wall(const Level& level, int buttons_of_fall) {
  Simulation simulation(level);
  for (int k = 0; k < 30; ++k) simulation.tick(press(button_right));
  for (int k = 0; k < 40; ++k) simulation.tick(press(button_right | button_jump));
  for (int k = 0; k < 30; ++k) simulation.tick(press(buttons_of_fall));
  return simulation;
}

Level wall() { return small_level({10.0, 1.0}, {ground({14.0, 1.0}, {20.0, top})}); }

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
  const Level roofed =
      small_level({10.0, 1.0}, {ground({14.0, 1.0}, {20.0, top}), ground({14.0, top + 0.1}, {20.0, top + 2.0})});
  EXPECT_FALSE(jump_at_wall(roofed, button_right | button_grab).player().ledge());
  MapObject slope = test_support::object("ground", engine::MapShape::polygon, {14.0, 1.0});
  slope.points = {{14.0, 1.0}, {20.0, 1.0}, {20.0, top + 4.0}, {14.0, top}};
  const Level sloping = small_level({10.0, 1.0}, {slope});
  EXPECT_FALSE(jump_at_wall(sloping, button_right | button_grab).player().ledge());
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
