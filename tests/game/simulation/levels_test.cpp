// Every level of the game: its recorded winning run, and the scripted player that made it.

#include "game/simulation/level.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/medals.h"
#include "game/simulation/run_header.h"
#include "game/simulation/simulation.h"
#include "tests/support/dice.h"
#include "tests/support/scripted_player.h"

namespace game {
namespace {

class EveryLevel : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Replay, EveryLevel, testing::ValuesIn(level_names()),
                         [](const auto& level) { return level.param; });

TEST_P(EveryLevel, HasAWinningRunThatVerifiesInAllItsTicks) {
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + GetParam() + ".replay");
  EXPECT_TRUE(replay.complete);
  const Level level = load_level(GetParam());
  EXPECT_NO_THROW(engine::check_header(replay.header, replay_header(level)));
  Simulation simulation(level);
  for (std::size_t k = 0; k < replay.ticks.size(); ++k) {
    simulation.tick(replay.ticks[k].input);
    ASSERT_EQ(simulation.hash().combined(), replay.ticks[k].state.combined()) << "tick " << k;
  }
  EXPECT_EQ(simulation.goal_ticks().has_value(), level.goal.has_value());
}

TEST_P(EveryLevel, HasAPlaceATitleAHintAndAPicture) {
  const Level level = load_level(GetParam());
  EXPECT_GT(level.number, 0);
  EXPECT_NE(level.title, level.name);
  EXPECT_FALSE(level.hint.empty());
  EXPECT_TRUE(std::filesystem::exists(assets_folder() + "/pictures/" + GetParam() + ".jpg"));
}

TEST_P(EveryLevel, HasTheMedalsThatFollowFromItsWinningRun) {
  const Level level = load_level(GetParam());
  if (!level.goal) {
    EXPECT_EQ(level.medals.bronze, 0.0);
    return;
  }
  const engine::Replay replay = engine::load_replay(assets_folder() + "/replays/" + GetParam() + ".replay");
  Simulation simulation(level);
  for (const engine::RecordedTick& tick : replay.ticks) simulation.tick(tick.input);
  const int winning = simulation.goal_ticks().value_or(0);
  ASSERT_GT(winning, 0);
  const Medals wanted = medals_by_rule(winning);
  EXPECT_EQ(level.medals.gold, wanted.gold);
  EXPECT_EQ(level.medals.silver, wanted.silver);
  EXPECT_EQ(level.medals.bronze, wanted.bronze);
  EXPECT_EQ(medal_for(winning, level.medals), Medal::gold) << "gold can be reached";
  EXPECT_EQ(medal_for(2 * winning, level.medals), Medal::silver) << "and not by everybody";
  EXPECT_EQ(medal_for(5 * winning, level.medals), Medal::none);
}

/// Returns the ticks to the goal of the scripted player, which starts after a delay; 0 if it fails.
int ticks_to_goal(const Level& level, int delay) {
  Simulation simulation(level);
  for (int k = 0; k < delay; ++k) simulation.tick({});
  test_support::ScriptedPlayer player = test_support::winner_of(level.name);
  while (!simulation.goal_ticks() && !player.is_stuck() && !player.is_done() && simulation.ticks() < 3600) {
    simulation.tick(player.input(simulation));
  }
  return simulation.goal_ticks().value_or(0);
}

class ScriptedLevels : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ScriptedPlayer, ScriptedLevels,
                         testing::Values("first_steps", "in_rhythm", "line_and_knife", "up_and_away", "first_swing",
                                         "pump_it_up", "round_the_pegs", "over_the_wall", "up_the_shaft",
                                         "hand_over_hand", "gently", "wait_for_the_wind", "open_the_gate", "zip_line",
                                         "the_lift", "wrecking_ball", "cut_the_bridge", "the_harbour", "over_you_go",
                                         "pull_me_up", "swing_me_across", "before_it_burns", "the_light_one_first"),
                         [](const auto& level) { return std::string(level.param); });

TEST_P(ScriptedLevels, AreWonAfterRandomDelays) {
  const Level level = load_level(GetParam());
  test_support::Dice dice(7);
  for (int trial = 0; trial < 6; ++trial) {
    const int delay = static_cast<int>(dice(0.0, 240.0));
    EXPECT_GT(ticks_to_goal(level, delay), 0) << "after a delay of " << delay << " ticks";
  }
}

}  // namespace
}  // namespace game
