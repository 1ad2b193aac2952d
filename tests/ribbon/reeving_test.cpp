#include "ribbon/pulley.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/pulleys.h"
#include "tests/support/refusal.h"

// Cords that are laid around wheels.

namespace ribbon {
namespace {

using test_support::refusal;

TEST(Tangent, TouchesTheWheelInTheDirectionOfTravel) {
  for (const double sense : {1.0, -1.0}) {
    const Vec2 r{0.3, -1.1};
    const TangentLine in = arriving_line(r, 0.4, sense);
    EXPECT_LT(length(r + in.length * in.along - 0.4 * in.normal), 1e-14);
    EXPECT_LT(length(in.along - sense * perp(in.normal)), 1e-14);
    const TangentLine out = leaving_line(r, 0.4, sense);
    EXPECT_LT(length(0.4 * out.normal + out.length * out.along - r), 1e-14);
    EXPECT_LT(length(out.along - sense * perp(out.normal)), 1e-14);
  }
}

TEST(Tangent, FindsAnglesAndPowers) {
  for (double angle = -3.14; angle < 3.14; angle += 0.01) {
    EXPECT_NEAR(angle_between(rotation(0.7), rotation(0.7 + angle)), angle, 1e-13);
  }
  EXPECT_DOUBLE_EQ(std::abs(angle_between({-1.0, 0.0}, {1.0, 0.0})), std::numbers::pi);
  for (double x = 0.0; x < 40.0; x += 0.37) EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-12);
  EXPECT_EQ(exponential(600.0), exponential(40.0));
}

TEST(Reeving, LaysACordTautAroundWheels) {
  const ReevedCord tackle = test_support::reeve_tackle(181);
  // Five straight parts, of which two are 4 m between wheels of the same size, and four half turns.
  EXPECT_NEAR(tackle.length, 3.0 + 3.0 * 4.0 + 3.5 + 4.0 * 0.1 * std::numbers::pi, 1e-12);
  EXPECT_EQ(tackle.positions.front(), (Vec2{-0.1, 3.0}));
  EXPECT_EQ(tackle.positions.back(), (Vec2{0.7, 5.5}));
  const double link = tackle.length / 180.0;
  for (std::size_t p = 1; p < tackle.positions.size(); ++p) {
    const double size = length(tackle.positions[p] - tackle.positions[p - 1]);
    EXPECT_LE(size, link + 1e-12) << p;
    EXPECT_GE(size, 0.9 * link) << p;
  }
  ASSERT_EQ(tackle.pulleys.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(tackle.pulleys[k].before, tackle.pulleys[k].after);
    if (k > 0) {
      EXPECT_GT(tackle.pulleys[k].before, tackle.pulleys[k - 1].after);
    }
  }
}

TEST(Reeving, WindsWholeTurns) {
  PulleyDef wheel{.center = {}, .radius = 0.5, .counterclockwise = false, .turns = 3};
  const ReevedCord wound = reeve({-0.5, -2.0}, {&wheel, 1}, {0.5, -2.0}, 101);
  EXPECT_NEAR(wound.length, 4.0 + 7.0 * 0.5 * std::numbers::pi, 1e-12);
}

TEST(Reeving, RefusesWhatCannotBeLaid) {
  const std::vector<PulleyDef> close{{.center = {0.0, 0.0}, .radius = 0.5},
                                     {.center = {0.1, 0.0}, .radius = 0.1, .counterclockwise = true}};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-2.0, 0.0}, close, {2.0, 0.0}, 50);
            }),
            "wheels of a cord overlap, or one holds an end; accepted are ones with a common tangent");
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({0.1, 0.0}, {close.data(), 1}, {2.0, 0.0}, 50);
            }),
            "wheels of a cord overlap, or one holds an end; accepted are ones with a common tangent");
  const std::vector<PulleyDef> near{{.center = {0.0, 0.0}, .radius = 0.1}, {.center = {1.0, 0.0}, .radius = 0.1}};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-9.0, 0.0}, near, {9.0, 0.0}, 8);
            }),
            "points are 8, too few for wheel 1; accepted are enough that two lie between neighbouring wheels");
  EXPECT_EQ(refusal<std::exception>([] { (void)reeve({}, {}, {1.0, 0.0}, 1); }), "points is 1; accepted is 2 to 1e+06");
  const PulleyDef flat{.center = {}, .radius = 0.0};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-1.0, 0.0}, {&flat, 1}, {1.0, 0.0}, 9);
            }),
            "radius is 0; accepted is 1e-06 to 1e+06");
}

}  // namespace
}  // namespace ribbon
