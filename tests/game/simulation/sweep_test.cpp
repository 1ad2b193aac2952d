// When two moving segments meet.

#include "game/simulation/sweep.h"

#include <gtest/gtest.h>

#include "tests/support/dice.h"

namespace game {
namespace {

TEST(Sweep, ACrossingIsWhereTheSegmentsAreNow) {
  EXPECT_DOUBLE_EQ(crossing({{0.0, 0.0}, {4.0, 0.0}}, {{1.0, -1.0}, {1.0, 1.0}}).value_or(-1.0), 0.25);
  EXPECT_FALSE(crossing({{0.0, 0.0}, {4.0, 0.0}}, {{1.0, 0.5}, {1.0, 1.0}}));
  EXPECT_FALSE(crossing({{0.0, 0.0}, {4.0, 0.0}}, {{5.0, -1.0}, {5.0, 1.0}}));
}

TEST(Sweep, FindsAParallelEdgeThatASegmentPassesWithinATick) {
  const Segment edge{{1.0, -0.2}, {1.0, 0.3}};
  const Segment from{{0.5, -1.0}, {0.5, 1.0}};
  const Segment to{{1.5, -1.0}, {1.5, 1.0}};
  EXPECT_FALSE(crossing(from, edge));
  EXPECT_FALSE(crossing(to, edge));
  const auto place = swept_crossing(from, to, edge, edge);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->time, 0.5, 1e-12);
  EXPECT_NEAR(place->place, 0.4, 1e-12) << "where the lower end of the edge meets it";
  EXPECT_FALSE(swept_crossing(from, {{0.9, -1.0}, {0.9, 1.0}}, edge, edge));
  EXPECT_FALSE(swept_crossing(from, {{1.5, 1.0}, {1.5, 3.0}}, edge, {{1.0, -3.2}, {1.0, -3.0}}));
}

/// Small steps of the same motion find a crossing exactly where the sweep does, except where they only graze.
TEST(Sweep, AgreesWithSmallSteps) {
  test_support::Dice dice(5);
  const auto place = [&dice] { return ribbon::Vec2{dice(-1.0, 1.0), dice(-1.0, 1.0)}; };
  int meetings = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Segment from{place(), place()};
    const Segment to{place(), place()};
    const Segment edge_from{place(), place()};
    const Segment edge_to{place(), place()};
    if (crossing(from, edge_from)) continue;
    constexpr int steps = 2000;
    bool found = false;
    for (int k = 0; k <= steps && !found; ++k) {
      const double t = static_cast<double>(k) / steps;
      const auto at = [t](const Segment& a, const Segment& b) {
        return Segment{a.a + t * (b.a - a.a), a.b + t * (b.b - a.b)};
      };
      found = crossing(at(from, to), at(edge_from, edge_to)).has_value();
    }
    meetings += found ? 1 : 0;
    if (found) {
      EXPECT_TRUE(swept_crossing(from, to, edge_from, edge_to)) << trial;
    }
  }
  EXPECT_GT(meetings, 100);
}

}  // namespace
}  // namespace game
