#include "tests/baseline/compare.h"

#include <gtest/gtest.h>

namespace baseline {
namespace {

using Sentences = std::vector<std::string>;

Row strips(std::int64_t work, std::int64_t worst_tick = 100) {
  return {"strips", "cord", "fast with contact between strips", 9900, 60, work, worst_tick};
}

TEST(BaselineCompare, EqualTablesHaveNoDifference) {
  const Comparison found = compare({strips(1000)}, {strips(1000)});
  EXPECT_EQ(found.worse, Sentences{});
  EXPECT_EQ(found.better, Sentences{});
}

TEST(BaselineCompare, FourPercentMoreAreAllowedAndSixAreNot) {
  EXPECT_EQ(compare({strips(11'000'000)}, {strips(11'440'000)}).worse, Sentences{});
  EXPECT_EQ(
      compare({strips(11'000'000)}, {strips(11'660'000)}).worse,
      Sentences{"strips cord fast with contact between strips, 9900 points: work 11,660,000, baseline 11,000,000: 6 % "
                "more (5 % allowed)"});
}

TEST(BaselineCompare, TheWorstTickHasTheSameLimit) {
  EXPECT_EQ(compare({strips(1000, 100)}, {strips(1000, 104)}).worse, Sentences{});
  EXPECT_EQ(compare({strips(1000, 100)}, {strips(1000, 106)}).worse,
            Sentences{"strips cord fast with contact between strips, 9900 points: worst tick 106, baseline 100: 6 % "
                      "more (5 % allowed)"});
}

TEST(BaselineCompare, LessWorkIsReportedAndAccepted) {
  const Comparison found = compare({strips(1000)}, {strips(940)});
  EXPECT_EQ(found.worse, Sentences{});
  EXPECT_EQ(found.better,
            Sentences{"strips cord fast with contact between strips, 9900 points: work 940, baseline 1,000: 6 % less"});
  EXPECT_EQ(compare({strips(1000)}, {strips(960)}).better, Sentences{});
}

TEST(BaselineCompare, AnyWorkIsMoreThanNone) {
  EXPECT_EQ(compare({strips(0, 0)}, {strips(0, 0)}).worse, Sentences{});
  EXPECT_EQ(compare({strips(0, 0)}, {strips(0, 0)}).better, Sentences{});
  const Comparison found = compare({strips(0, 0)}, {strips(1, 0)});
  EXPECT_EQ(found.worse, Sentences{"strips cord fast with contact between strips, 9900 points: work 1, baseline 0: "
                                   "more than none (5 % allowed)"});
}

TEST(BaselineCompare, RowsWithOtherTickCountsAreWorse) {
  Row fewer = strips(1000);
  fewer.ticks = 30;
  EXPECT_EQ(
      compare({strips(1000)}, {fewer}).worse,
      Sentences{
          "strips cord fast with contact between strips, 9900 points: 30 ticks, baseline 60; accepted are as many"});
}

TEST(BaselineCompare, MissingAndNewRowsAreWorse) {
  EXPECT_EQ(compare({strips(1000)}, {}).worse,
            Sentences{"strips cord fast with contact between strips, 9900 points: in the baseline, and not counted"});
  EXPECT_EQ(compare({}, {strips(1000)}).worse,
            Sentences{"strips cord fast with contact between strips, 9900 points: counted, and not in the baseline"});
}

}  // namespace
}  // namespace baseline
