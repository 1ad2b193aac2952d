#include "ribbon/smooth_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ribbon/cut.h"
#include "ribbon/layout.h"
#include "tests/ribbon/smooth_lines.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"

// Strips along smooth lines.

namespace ribbon {
namespace {

using test_support::equally_spaced;

TEST(SmoothStrip, OfAStraightRopeIsExact) {
  const std::vector<Vec2> points = equally_spaced(9, {1.0, 2.0}, {0.5, 0.0});
  const auto strip = strip_of({points, 1, RestLengths(0.5)}, 0.25, 4);
  ASSERT_EQ(strip.size(), 66U);
  for (std::size_t k = 0; k < 33; ++k) {
    const double arc = 0.125 * static_cast<double>(k);
    EXPECT_EQ(strip[2 * k], (StripVertex{{1.0 + arc, 1.75}, arc, 0.0}));
    EXPECT_EQ(strip[2 * k + 1], (StripVertex{{1.0 + arc, 2.25}, arc, 1.0}));
  }
}

/// A right angle has its full width; a sharper bend has no spike.
TEST(SmoothStrip, BendsAreMitredUpToARightAngle) {
  const auto corner = strip_of({std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}}, 0.1, 1);
  EXPECT_NEAR(length(corner[2].position - Vec2{1.1, -0.1}), 0.0, 1e-15);
  EXPECT_NEAR(length(corner[3].position - Vec2{0.9, 0.1}), 0.0, 1e-15);
  for (double angle = 0.0; angle <= std::numbers::pi; angle += 0.01) {
    const Vec2 tip{1.0 + std::cos(angle), std::sin(angle)};
    const auto strip = strip_of({std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, tip}}, 0.1, 1);
    const double expected = angle < 0.5 * std::numbers::pi ? 0.1 / std::cos(0.5 * angle) : 0.1 * std::numbers::sqrt2;
    EXPECT_NEAR(length(strip[2].position - Vec2{1.0, 0.0}), expected, 1e-12) << angle;
    EXPECT_NEAR(length(strip[3].position - Vec2{1.0, 0.0}), expected, 1e-12) << angle;
  }
}

/// The outer vertex of a fold is beyond its tip, not beside it.
TEST(SmoothStrip, AFoldEndsAtItsTip) {
  const auto strip = strip_of({std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {0.0, 0.0}}}, 0.1, 1);
  EXPECT_NEAR(length(strip[2].position - Vec2{1.0 + 0.1 * std::numbers::sqrt2, 0.0}), 0.0, 1e-12);
  EXPECT_NEAR(length(strip[3].position - Vec2{1.0 - 0.1 * std::numbers::sqrt2, 0.0}), 0.0, 1e-12);
}

TEST(SmoothStrip, OfARibbonHasItsOuterRowsAsEdges) {
  CordDef def;
  def.points = 9;
  def.rows = 3;
  def.width = 0.5;
  def.length = 2.0;
  lay_along(def, {{0.0, 0.0}, {1.0, 0.3}, {2.0, 0.0}});
  const PointGrid points{def.positions, 3, RestLengths(0.25)};
  const auto right = line_of(points, 5, 0);
  const auto left = line_of(points, 5, 2);
  const auto strip = strip_of(points, 0.0, 5);
  for (std::size_t k = 0; k < right.size(); ++k) {
    EXPECT_EQ(strip[2 * k].position, right[k].position);
    EXPECT_EQ(strip[2 * k + 1].position, left[k].position);
    EXPECT_EQ(strip[2 * k].arc, strip[2 * k + 1].arc) << "texture lines go straight across";
    EXPECT_EQ(strip[2 * k].across, 0.0);
    EXPECT_EQ(strip[2 * k + 1].across, 1.0);
    EXPECT_NEAR(strip[2 * k].arc, 0.05 * static_cast<double>(k), k % 5 == 0 ? 1e-12 : 0.01);
    EXPECT_GT(strip[2 * k].arc, k > 0 ? strip[2 * k - 2].arc : -1.0);
  }
  const auto wide = strip_of(points, 0.1, 5);
  for (std::size_t k = 0; k < right.size(); ++k) {
    EXPECT_NEAR(length(wide[2 * k].position - right[k].position), 0.1, 1e-12);
    EXPECT_NEAR(length(wide[2 * k + 1].position - wide[2 * k].position),
                length(left[k].position - right[k].position) + 0.2, 1e-12);
  }
}

TEST(SmoothStrip, OfACollapsedRibbonIsFinite) {
  const std::vector<Vec2> points{{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}};
  const auto strip = strip_of({points, 2}, 0.1, 3);
  for (std::size_t k = 0; k < strip.size(); k += 2) {
    EXPECT_TRUE(is_finite(strip[k].position));
    EXPECT_GE(length(strip[k + 1].position - strip[k].position), 0.2 - 1e-12);
  }
}

TEST(SmoothStrip, TrianglesOfARibbonAreCounterClockwise) {
  CordDef def;
  def.points = 5;
  def.rows = 2;
  def.width = 0.5;
  lay_along(def, {{0.0, 0.0}, {2.0, 0.3}});
  const auto strip = strip_of({def.positions, 2}, 0.0, 2);
  EXPECT_GT(cross(strip[2].position - strip[0].position, strip[1].position - strip[0].position), 0.0);
}

}  // namespace
}  // namespace ribbon
