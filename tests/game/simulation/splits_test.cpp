#include "game/simulation/splits.h"

#include <gtest/gtest.h>

#include <string>

#include "game/simulation/buttons.h"
#include "game/simulation/ghost.h"
#include "tests/game/program.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

const std::string replays = TEST_ASSETS "/replays/";

TEST(Splits, AreTheTicksOfTheFirstEntryOfEachCheckpoint) {
  const Level level = load_level("rolling_bridge");
  const engine::Replay replay = engine::load_replay(replays + "rolling_bridge.replay");
  Simulation simulation(level);
  SplitTimer timer;
  Splits expected(level.checkpoints.size());
  int reported = 0;
  for (const engine::RecordedTick& recorded : replay.ticks) {
    simulation.tick(recorded.input);
    if (const auto entered = timer.update(simulation)) {
      ++reported;
      EXPECT_FALSE(expected[*entered]);
      EXPECT_TRUE(level.checkpoints[*entered].contains(simulation.player().position()));
      expected[*entered] = simulation.run_ticks();
    }
  }
  EXPECT_GE(reported, 1);
  EXPECT_EQ(timer.splits(), expected);

  engine::TickInput restart;
  restart.buttons = button_restart;
  simulation.tick(restart);
  timer.update(simulation);
  EXPECT_EQ(timer.splits(), Splits(level.checkpoints.size())) << "a new run has none";
}

TEST(Splits, AGhostFindsThoseOfItsRecording) {
  const Level level = load_level("rolling_bridge");
  const auto ghost = Ghost::open(replays + "rolling_bridge.replay", level);
  const auto scout = Ghost::open(replays + "rolling_bridge.replay", level);
  while (scout->advance_far()) {
  }
  int lead = 0;
  while (ghost->advance(0)) ++lead;
  EXPECT_EQ(lead, Ghost::max_lead);
  EXPECT_NE(scout->splits(), Splits(level.checkpoints.size()));
  EXPECT_NE(scout->splits(), ghost->splits()) << "it is only at the start";
}

TEST(Splits, AGhostOfAnotherLevelIsRefused) {
  const auto refused = [](const std::string& path) {
    return test_support::refusal<engine::ReplayError>([&] { Ghost::open(path, load_level("rolling_bridge")); });
  };
  const std::string other = refused(test_support::golden());
  EXPECT_NE(other.find("first_swing"), std::string::npos) << other;
  EXPECT_NE(other.find("rolling_bridge"), std::string::npos) << other;
  EXPECT_NE(refused("/nowhere.replay").find("/nowhere.replay"), std::string::npos);
  EXPECT_EQ(Ghost::load(test_support::golden(), load_level("rolling_bridge")), nullptr);
}

TEST(Splits, ADifferenceHasItsSign) {
  EXPECT_EQ(difference_in_words(125, 100), "+0.42 s");
  EXPECT_EQ(difference_in_words(37, 100), "−1.05 s");
  EXPECT_EQ(difference_in_words(100, 100), "±0.00 s");
}

}  // namespace
}  // namespace game
