#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "engine/replay/replay.h"
#include "game/simulation/level.h"
#include "game/simulation/simulation.h"

// With how much force a player reels its partner in.

namespace game {
namespace {

/// The light one stands firmly against a wall. At the edge, where the rope draws sideways, a winch without a limit
/// threw the heavy one up at 48 m/s.
TEST(TheLightOneFirst, ReelsTheHeavyOneOverTheEdgeWithoutThrowingIt) {
  const engine::Replay replay = engine::load_replay(TEST_ASSETS "/replays/the_light_one_first.replay");
  const Level level = load_level("the_light_one_first");
  Simulation simulation(level);
  float fastest = 0.0F;
  for (const auto& tick : replay.ticks) {
    simulation.tick(tick.input);
    fastest = std::max(fastest, simulation.player(1).body().GetLinearVelocity().Length());
  }
  EXPECT_TRUE(simulation.goal_ticks());
  EXPECT_LT(fastest, 9.0F);
}

}  // namespace
}  // namespace game
