// When two moving segments meet.

#include "game/simulation/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>

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

/// Returns a segment on its way from one place to another.
Segment between(const Segment& from, const Segment& to, double time) {
  return {from.a + time * (to.a - from.a), from.b + time * (to.b - from.b)};
}

/// Returns the distance of a point from a segment.
double distance(ribbon::Vec2 point, const Segment& segment) {
  const ribbon::Vec2 way = segment.b - segment.a;
  const double along = std::clamp(dot(point - segment.a, way) / dot(way, way), 0.0, 1.0);
  return length(segment.a + along * way - point);
}

/// Small steps of the same motion find the crossings of the sweep, except those that last for less than a step; and
/// where the sweep says, the segments meet.
TEST(Sweep, AgreesWithSmallSteps) {
  test_support::Dice dice(5);
  const auto place = [&dice] { return ribbon::Vec2{dice(-1.0, 1.0), dice(-1.0, 1.0)}; };
  int meetings = 0;
  int grazes = 0;  // too short for a step
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
      found = crossing(between(from, to, t), between(edge_from, edge_to, t)).has_value();
    }
    const auto swept = swept_crossing(from, to, edge_from, edge_to);
    if (found) {
      EXPECT_TRUE(swept) << trial;
      ++meetings;
    }
    if (!swept) continue;
    grazes += found ? 0 : 1;
    const Segment segment = between(from, to, swept->time);
    const ribbon::Vec2 meets = segment.a + swept->place * (segment.b - segment.a);
    EXPECT_LT(distance(meets, between(edge_from, edge_to, swept->time)), 1e-9) << trial;
  }
  EXPECT_GT(meetings, 100);
  EXPECT_LE(grazes, 4);
}

}  // namespace
}  // namespace game
