#include <gtest/gtest.h>

#include <string>

#include "engine/replay/replay.h"
#include "game/simulation/recorded_run.h"

namespace game {
namespace {

RunOptions golden() {
  RunOptions options;
  options.replay = TEST_ASSETS "/replays/first_swing.replay";
  return options;
}

/// Seeks forwards, backwards, to the same tick and near the end; only the last two ticks are compared.
TEST(ReplaySeek, EveryTickIsAsRecordedFromAnyOtherTick) {
  const engine::Replay replay = engine::load_replay(golden().replay);
  const auto last = static_cast<int>(replay.ticks.size());
  RecordedRun run(golden());
  const Simulation& simulation = run.simulation();
  const ribbon::box2d::StateHash start = simulation.hash();
  for (const int tick : {0, 1, 2, 3, 120, 122, 122, 121, 7, last, last - 1, 0, 300}) {
    run.seek(tick);
    EXPECT_EQ(simulation.ticks(), tick);
    EXPECT_EQ(simulation.hash(), tick == 0 ? start : replay.ticks[static_cast<std::size_t>(tick) - 1].state) << tick;
  }
  run.tick({});
  EXPECT_EQ(simulation.hash(), replay.ticks[300].state);
  EXPECT_FALSE(run.is_over());
}

/// The picture between two ticks is that of a run without a seek.
TEST(ReplaySeek, RestoresBothTicksOfAnInterpolation) {
  RecordedRun sought(golden());
  RecordedRun run(golden());
  sought.seek(200);
  for (int k = 0; k < 200; ++k) run.tick({});
  EXPECT_EQ(sought.simulation().previous().cords, run.simulation().previous().cords);
  EXPECT_EQ(sought.simulation().current().cords, run.simulation().current().cords);
  EXPECT_NE(run.simulation().previous().cords, run.simulation().current().cords);
}

TEST(ReplaySeek, RefusesInvalidTicksAndRunsThatCannotSeek) {
  RecordedRun run(golden());
  run.seek(10);
  const ribbon::box2d::StateHash before = run.simulation().hash();
  EXPECT_THROW(run.seek(-1), engine::ReplayError);
  EXPECT_THROW(run.seek(1'000'000), engine::ReplayError);
  EXPECT_EQ(run.simulation().hash(), before);
  EXPECT_THROW(RecordedRun({}).seek(0), engine::ReplayError);
  RunOptions verified = golden();
  verified.verify = true;
  EXPECT_THROW(RecordedRun(verified).seek(1), engine::ReplayError);
}

}  // namespace
}  // namespace game
