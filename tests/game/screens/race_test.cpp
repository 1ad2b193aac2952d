// The comparison of a run with the best run, and with a given recording.

#include "game/screens/race.h"

#include <gtest/gtest.h>

#include <string>

#include "game/screens/level_facts.h"
#include "tests/game/program.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

using namespace test_support;

const std::string recording = TEST_ASSETS "/replays/rolling_bridge.replay";

/// Runs the recording after some ticks without input. Returns the messages at the checkpoints.
std::vector<SplitMessage> messages_of(Race& race, const Level& level, int wait) {
  std::vector<SplitMessage> messages;
  Simulation simulation(level);
  const auto tick = [&](const engine::TickInput& input) {
    simulation.tick(input);
    const Splits before = race.splits();
    race.tick(simulation);
    if (!before.empty() && race.splits() != before) {
      EXPECT_NE(race.message(), nullptr);
      messages.push_back(*race.message());
    }
  };
  for (int k = 0; k < wait; ++k) tick({});
  for (const engine::RecordedTick& recorded : engine::load_replay(recording).ticks) tick(recorded.input);
  for (int k = 0; k < 200; ++k) tick({});
  EXPECT_EQ(race.message(), nullptr) << "it is shown for a while only";
  return messages;
}

TEST(Race, FindsTheSplitsOfABestRunWithoutThemAndStoresThem) {
  const std::string data = scratch("race_data");
  fs::remove_all(data);
  const Level level = load_level("rolling_bridge");
  std::string error;
  {
    Session session("", data);
    session.records.offer(level_key(level), {1000, false}, recording, error);
    Race race(session, "");
    race.begin(level);
    EXPECT_TRUE(race.reference().empty());
    for (int k = 0; k < 100'000 && session.records.best(level_key(level))->splits.empty(); ++k) race.advance(0, 0);
  }
  Session session("", data);
  const auto ghost = Ghost::open(recording, level);
  while (ghost->advance_far()) {
  }
  ASSERT_EQ(session.records.best(level_key(level))->splits, ghost->splits());

  Race race(session, "");
  race.begin(level);
  EXPECT_EQ(race.reference(), ghost->splits());
  const std::vector<SplitMessage> same = messages_of(race, level, 0);
  ASSERT_GE(same.size(), 1U);
  for (const SplitMessage& message : same) {
    EXPECT_EQ(message.difference, "±0.00 s");
    EXPECT_TRUE(message.is_ahead);
  }
  race.begin(level);
  EXPECT_EQ(race.message(), nullptr);
  const std::vector<SplitMessage> late = messages_of(race, level, 30);
  ASSERT_GE(late.size(), 1U);
  EXPECT_EQ(late.front().difference[0], '+') << late.front().difference;
  EXPECT_FALSE(late.front().is_ahead);
}

TEST(Race, WithoutABestRunTheTimeAloneIsShown) {
  Session session("", "");
  const Level level = load_level("rolling_bridge");
  Race race(session, "");
  race.begin(level);
  race.advance(10, 10);
  const std::vector<SplitMessage> messages = messages_of(race, level, 0);
  ASSERT_GE(messages.size(), 1U);
  EXPECT_EQ(messages.front().difference, "");
  EXPECT_EQ(race.ghost_at(1), std::nullopt);
}

TEST(Race, AGivenRecordingReplacesTheBestRun) {
  Session session("", "");
  session.settings.ghost = false;
  const Level level = load_level("rolling_bridge");
  Race race(session, recording);
  race.check(level);
  race.begin(level);
  for (int k = 0; k < 100'000 && (race.reference().empty() || !race.reference()[0]); ++k) race.advance(1, 1);
  EXPECT_TRUE(race.ghost_at(1)) << "it was asked for";
  const std::vector<SplitMessage> messages = messages_of(race, level, 0);
  ASSERT_GE(messages.size(), 1U);
  EXPECT_EQ(messages.front().difference, "±0.00 s");

  const std::string refused =
      refusal<engine::ReplayError>([&] { Race(session, golden()).check(load_level("rolling_bridge")); });
  EXPECT_EQ(refused.rfind("--ghost " + golden() + " cannot be raced against: ", 0), 0U) << refused;
  race.begin(load_level("first_swing"));
  EXPECT_NE(session.notice.text().find("no ghost"), std::string::npos);
}

TEST(Race, TheResultsNameThoseThatWereEntered) {
  using Lines = std::vector<std::string>;
  EXPECT_EQ(splits_in_words({}, {}), Lines());
  EXPECT_EQ(splits_in_words({std::nullopt}, {60}), Lines());
  EXPECT_EQ(splits_in_words({60, std::nullopt, 180, 240}, {120, 130, std::nullopt}),
            (Lines{"Checkpoint 1: 1.00 s (−1.00 s)   3: 3.00 s", "Checkpoint 4: 4.00 s"}));
}

TEST(GhostProgram, RacesAgainstARecordingOfTheSameLevelOnly) {
  const std::string dummy = "SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy";
  const Ended alone = ropeswing("--headless --ticks 60");
  const Ended raced = ropeswing("--ghost " + golden() + " --ticks 60", dummy);
  EXPECT_EQ(raced.status, 0) << raced.output;
  EXPECT_EQ(last_line(raced.output), last_line(alone.output)) << "the ghost changed the run";
  const Ended other = ropeswing("--level rolling_bridge --ghost " + golden() + " --ticks 5", dummy);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.output.find("first_swing"), std::string::npos) << other.output;
  EXPECT_NE(other.output.find("rolling_bridge"), std::string::npos) << other.output;
  EXPECT_EQ(ropeswing("--ghost /nowhere.replay", dummy).status, 2);
  EXPECT_EQ(ropeswing("--headless --ticks 5 --ghost " + golden()).status, 2);
  EXPECT_EQ(ropeswing("--replay " + golden() + " --ghost " + golden(), dummy).status, 2);
}

}  // namespace
}  // namespace game
