#include <gtest/gtest.h>

#include <string>

#include "tests/extremes/table.h"

// Runs a part of each grid; `extremes --full` runs all of it.

namespace extremes {
namespace {

class Extremes : public testing::TestWithParam<Group> {};

/// The thesis's method may stretch, gain energy and lose its shape. The test checks only that its figures are finite,
/// and that its steps report what is lost.
TEST_P(Extremes, EveryRowIsWithinItsLimit) {
  for (const Row& row : GetParam().run({})) {
    const std::string what = std::string(name(row.method)) + ", " + row.what + ", at " + row.setting;
    EXPECT_GT(row.cases, 0) << what;
    EXPECT_LT(row.worst, 1e300) << what << ": " << row.figure;
    EXPECT_TRUE(row.passed() || row.is_reported()) << what << ": " << row.figure;
    if (!row.is_required()) continue;
    EXPECT_LE(row.worst, row.limit) << what << ": " << row.figure;
    EXPECT_EQ(row.counts.direct.unconverged, 0) << what;
  }
}

std::string name_of(const testing::TestParamInfo<Group>& group) { return std::string(group.param.name); }
INSTANTIATE_TEST_SUITE_P(All, Extremes, testing::ValuesIn(groups()), name_of);

}  // namespace
}  // namespace extremes
