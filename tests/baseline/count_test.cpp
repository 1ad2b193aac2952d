#include "tests/baseline/count.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "engine/replay/replay.h"
#include "tests/support/refusal.h"

namespace baseline {
namespace {

using tradeoff::Scene;
using tradeoff::Variant;

/// Counts work 1 in the first tick after a reset, 2 in the second and so on, with 100 more in the fourth.
Variant worker(const std::string& setting, bool continues) {
  const auto tick = std::make_shared<int>(0);
  Variant out;
  out.method = "cord";
  out.setting = setting;
  out.points = 51;
  if (!continues) out.reset = [tick] { *tick = 0; };
  out.tick = [tick] { ++*tick; };
  out.figures = [tick] {
    *tick = 10;
    return std::vector<double>();
  };
  out.work = [tick] { return std::int64_t{*tick} + (*tick == 4 ? 100 : 0); };
  return out;
}

Scene scene_of(const std::vector<Variant>& variants) {
  return {"some", "", 5, [variants] { return variants; }};
}

TEST(BaselineCount, AddsUpTheTicksThatASceneTimes) {
  const Row row{"some", "cord", "fast", 51, 5, 1 + 2 + 3 + 104 + 5, 104};
  EXPECT_EQ(count(scene_of({worker("fast", false)})), std::vector{row});
}

TEST(BaselineCount, CountsFewerTicksIfTheSceneLimitsThem) {
  Scene scene = scene_of({worker("fast", false)});
  scene.counted_ticks = 2;
  const Row row{"some", "cord", "fast", 51, 2, 1 + 2, 2};
  EXPECT_EQ(count(scene), std::vector{row});
}

TEST(BaselineCount, ContinuesAfterTheFigures) {
  const Row row{"some", "cord", "fast", 51, 5, 11 + 12 + 13 + 14 + 15, 15};
  EXPECT_EQ(count(scene_of({worker("fast", true)})), std::vector{row});
}

TEST(BaselineCount, RunsTheRestOfATickToo) {
  Variant variant = worker("fast", false);
  variant.rest = variant.tick;
  const Row row{"some", "cord", "fast", 51, 5, 1 + 3 + 5 + 7 + 9, 9};
  EXPECT_EQ(count(scene_of({variant})), std::vector{row});
}

TEST(BaselineCount, NamesRowsBySettingGroupAndPoints) {
  Variant grouped = worker("fast", false);
  grouped.group = "ratio=10";
  Variant group_alone = worker("", false);
  group_alone.group = "pile";
  Variant uncounted = worker("substeps=8", false);
  uncounted.work = {};
  Variant longer = worker("fast", false);
  longer.points = 501;
  const std::vector<Row> rows =
      count(scene_of({worker("fast", false), uncounted, worker("fast", false), grouped, group_alone, longer}));
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(name(rows[0]), "some cord fast, 51 points");
  EXPECT_EQ(name(rows[1]), "some cord fast ratio=10, 51 points");
  EXPECT_EQ(name(rows[2]), "some cord pile, 51 points");
  EXPECT_EQ(name(rows[3]), "some cord fast, 501 points");
}

TEST(BaselineCount, CountsEveryTickOfARecordedRun) {
  const Row row = count_run(TEST_ASSETS "/replays/first_swing.replay");
  EXPECT_EQ(name(row).rfind("first_swing recorded run, ", 0), 0U) << name(row);
  EXPECT_GT(row.ticks, 100);
  EXPECT_GT(row.worst_tick, row.work / row.ticks);
  EXPECT_LT(row.worst_tick, row.work);
  EXPECT_EQ(count_run(TEST_ASSETS "/replays/first_swing.replay"), row);
}

TEST(BaselineCount, ARunThatDiffersFromItsRecordingIsRefused) {
  const engine::Replay replay = engine::load_replay(TEST_ASSETS "/replays/first_swing.replay");
  const std::string path = testing::TempDir() + "baseline_other.replay";
  engine::ReplayWriter writer(path, replay.header);
  for (const engine::RecordedTick& tick : replay.ticks) writer.write(tick.input, replay.ticks[7].state);
  writer.finish();
  EXPECT_TRUE(test_support::starts_with(test_support::refusal<std::runtime_error>([&] { count_run(path); }),
                                        path + ": tick 1: "));
}

}  // namespace
}  // namespace baseline
