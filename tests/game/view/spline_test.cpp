#include "game/view/spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace game {
namespace {

using ribbon::Vec2;

TEST(Spline, GoesThroughItsPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  for (int steps = 1; steps <= 9; ++steps) {
    std::vector<Vec2> points;
    for (int k = 0; k < 12; ++k) points.push_back({place(random), place(random)});
    std::vector<Vec2> curve;
    smooth_curve(points, steps, curve);
    ASSERT_EQ(curve.size(), 11U * static_cast<std::size_t>(steps) + 1U);
    for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(curve[k * static_cast<std::size_t>(steps)], points[k]);
  }
}

TEST(Spline, IsStraightThroughPointsOnALine) {
  const std::vector<Vec2> points{{0.0, 0.0}, {1.0, 2.0}, {1.5, 3.0}, {4.0, 8.0}};
  std::vector<Vec2> curve;
  smooth_curve(points, 8, curve);
  for (std::size_t k = 1; k < curve.size(); ++k) {
    EXPECT_NEAR(curve[k].y, 2.0 * curve[k].x, 1e-12);
    EXPECT_GT(curve[k].x, curve[k - 1].x);
  }
}

/// A spline through points of a circle approximates the circle far better than the chords do.
TEST(Spline, ApproximatesACircleThroughItsPoints) {
  std::vector<Vec2> points;
  for (int k = 0; k <= 24; ++k) points.push_back({std::cos(0.2 * k), std::sin(0.2 * k)});
  std::vector<Vec2> curve;
  smooth_curve(points, 10, curve);
  const double sagitta = 1.0 - std::cos(0.1);
  for (std::size_t k = 10; k + 10 < curve.size(); ++k) EXPECT_NEAR(length(curve[k]), 1.0, 0.02 * sagitta) << k;
}

/// A uniform spline with unequal distances would have a cusp or a loop within a short piece.
TEST(Spline, HasNoCuspInAShortPiece) {
  const std::vector<Vec2> points{{0.0, 0.0}, {3.0, 0.0}, {3.1, 0.1}, {3.0, 3.0}};
  std::vector<Vec2> curve;
  smooth_curve(points, 16, curve);
  for (std::size_t k = 17; k < 32; ++k) {
    const Vec2 in = curve[k] - curve[k - 1];
    const Vec2 out = curve[k + 1] - curve[k];
    EXPECT_GT(dot(in, out), 0.0) << k;
  }
}

TEST(Spline, CoincidentPointsAreHarmless) {
  const std::vector<Vec2> points{{0.0, 0.0}, {0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}};
  std::vector<Vec2> curve;
  smooth_curve(points, 6, curve);
  for (const Vec2 p : curve) {
    EXPECT_TRUE(is_finite(p));
    EXPECT_LT(length(p), 3.0);
  }
  smooth_curve({}, 6, curve);
  EXPECT_TRUE(curve.empty());
  smooth_curve(std::vector<Vec2>{{1.0, 1.0}}, 6, curve);
  EXPECT_EQ(curve.size(), 1U);
}

}  // namespace
}  // namespace game
