// The flag of a level: what touches it, and what happens then.

#include <gtest/gtest.h>

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "ribbon/box2d/convert.h"
#include "tests/game/simulation/press.h"

namespace game {
namespace {

using ribbon::Vec2;

/// Returns whether a player that is at rest in this place has won a tick later.
bool wins_at(const Level& level, Vec2 place) {
  Simulation simulation(level);
  simulation.player().body().SetTransform(ribbon::box2d::to_float(place), 0.0F);
  simulation.tick({});
  return simulation.goal_ticks().has_value();
}

/// The body is 0.6 m wide and 1.5 m high. In a tick it falls by millimetres.
TEST(Flag, IsReachedByAnyOverlapWithPoleOrCloth) {
  const Level level = load_level("pump_it_up");
  const Flag flag = flag_of(*level.goal);
  const double pole = 0.5 * flag.pole.size.x;
  const Vec2 beside = flag.foot + Vec2{0.0, 0.76};
  EXPECT_TRUE(wins_at(level, beside - Vec2{pole + 0.29, 0.0}));
  EXPECT_FALSE(wins_at(level, beside - Vec2{pole + 0.31, 0.0}));
  const Vec2 free_end = flag.cloth.center + Vec2{0.5 * flag.cloth.size.x, 0.0};
  EXPECT_TRUE(wins_at(level, free_end + Vec2{0.29, 0.0}));
  EXPECT_FALSE(wins_at(level, free_end + Vec2{0.31, 0.0}));
  const Vec2 above = flag.cloth.center + Vec2{0.4, 0.5 * flag.cloth.size.y + 0.75};
  EXPECT_TRUE(wins_at(level, above - Vec2{0.0, 0.01}));
  EXPECT_FALSE(wins_at(level, above + Vec2{0.0, 0.03}));
}

TEST(Flag, EndsControl) {
  const Level level = load_level("pump_it_up");
  Simulation simulation(level);
  const Flag flag = flag_of(*level.goal);
  simulation.player().body().SetTransform(ribbon::box2d::to_float(flag.foot + Vec2{-2.0, 0.76}), 0.0F);
  for (int k = 0; k < 120; ++k) simulation.tick(press(button_right));
  ASSERT_TRUE(simulation.goal_ticks());
  EXPECT_LT(simulation.player().position().x, flag.foot.x + 0.5);
  EXPECT_EQ(simulation.player().body().GetLinearVelocity().Length(), 0.0F);
  for (int k = 0; k < 60; ++k) simulation.tick(press(button_jump * (k % 2)));
  EXPECT_TRUE(simulation.player().is_on_ground());
  simulation.tick(press(button_restart));
  EXPECT_FALSE(simulation.goal_ticks());
}

TEST(Flag, OfASandboxMayBeMissing) {
  const Level level = load_level("sandbox");
  EXPECT_TRUE(level.sandbox);
  EXPECT_FALSE(level.goal);
  EXPECT_EQ(level.medals.gold, 0.0);
}

}  // namespace
}  // namespace game
