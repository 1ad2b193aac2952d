#include "ribbon/layout.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ribbon/cord.h"
#include "tests/support/refusal.h"

namespace {

using ribbon::CordDef;
using ribbon::Vec2;

CordDef of_points(int points, int rows = 1) {
  CordDef def;
  def.points = points;
  def.rows = rows;
  if (rows > 1) def.stretch_stiffness = 100.0;
  return def;
}

double link(const CordDef& def, std::size_t i) { return length(def.positions[i + 1] - def.positions[i]); }

TEST(Layout, AStraightRopeReachesFromEndToEnd) {
  CordDef def = of_points(5);
  lay_along(def, {{1.0, 2.0}, {4.0, -2.0}});
  EXPECT_NEAR(def.length, 5.0, 1e-12);
  EXPECT_EQ(def.width, 0.0);
  ASSERT_EQ(def.positions.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const double share = static_cast<double>(i) / 4.0;
    EXPECT_NEAR(length(def.positions[i] - Vec2{1.0 + 3.0 * share, 2.0 - 4.0 * share}), 0.0, 1e-12);
  }
}

TEST(Layout, LinksAreEquallyLongAroundCorners) {
  CordDef def = of_points(18);
  def.pins = {0, 17};
  lay_along(def, {{0.0, 0.0}, {1.3, 2.1}, {2.0, 0.0}, {4.0, -0.5}});
  for (std::size_t i = 0; i < 17; ++i) EXPECT_NEAR(link(def, i), def.length / 17.0, 1e-12);
  EXPECT_NEAR(length(def.positions.back() - Vec2{4.0, -0.5}), 0.0, 1e-9);

  ribbon::Cord cord(def);
  cord.step(1.0 / 60.0, {0.0, 0.0});
  for (const Vec2 v : cord.velocities()) EXPECT_LT(length(v), 1e-6);
}

TEST(Layout, RowsAreAcrossThePathWithTheFirstToItsRight) {
  CordDef def = of_points(3, 2);
  def.width = 0.5;
  lay_along(def, {{0.0, 0.0}, {0.0, 4.0}});  // upwards: its right is +x
  EXPECT_EQ(def.width, 0.5);
  ASSERT_EQ(def.positions.size(), 6U);
  EXPECT_NEAR(length(def.positions[2] - Vec2{0.25, 2.0}), 0.0, 1e-12);
  EXPECT_NEAR(length(def.positions[3] - Vec2{-0.25, 2.0}), 0.0, 1e-12);
}

TEST(Layout, ARibbonWithoutAWidthGetsSquareCells) {
  CordDef def = of_points(9, 3);
  lay_along(def, {{0.0, 0.0}, {4.0, 0.0}});
  EXPECT_NEAR(def.width, 1.0, 1e-12);
  EXPECT_NEAR(length(def.positions[1] - def.positions[0]), 0.5, 1e-12);
}

TEST(Layout, RefusesInvalidInputByNameAndChangesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec2> straight = {{0.0, 0.0}, {1.0, 0.0}};
  struct Bad {
    std::string named;
    std::function<void(CordDef&)> change;
    std::vector<Vec2> path;
  };
  const std::vector<Bad> bads = {
      {"points", [](CordDef& def) { def.points = 1; }, straight},
      {"points", [](CordDef& def) { def.points = 1'000'001; }, straight},
      {"rows", [](CordDef& def) { def.rows = 0; }, straight},
      {"path.size", [](CordDef& /*def*/) {}, {{0.0, 0.0}}},
      {"path", [](CordDef& /*def*/) {}, {{0.0, 0.0}, {nan, 0.0}}},
      {"path", [](CordDef& /*def*/) {}, {{0.0, 0.0}, {2e9, 0.0}}},
      {"corners", [](CordDef& /*def*/) {}, {{0.0, 0.0}, {1.0, 1.0}, {1.0, 1.0}}},
  };
  for (const Bad& bad : bads) {
    CordDef def = of_points(5);
    bad.change(def);
    const CordDef before = def;
    const std::string message = test_support::refusal<ribbon::DefinitionError>([&] { lay_along(def, bad.path); });
    EXPECT_TRUE(test_support::says(message, bad.named));
    EXPECT_TRUE(test_support::says(message, "accepted"));
    EXPECT_TRUE(def == before) << bad.named;
  }
}

TEST(Layout, TrianglesFillTheRibbonOnceAndTurnCounterClockwise) {
  CordDef def = of_points(6, 4);
  lay_along(def, {{0.0, 0.0}, {5.0, 0.0}});
  const std::vector<int> indices = ribbon::triangle_indices(def.points, def.rows);
  ASSERT_EQ(indices.size(), 6U * 5U * 3U);
  double area = 0.0;
  for (std::size_t k = 0; k < indices.size(); k += 3) {
    const auto at = [&](std::size_t corner) { return def.positions[static_cast<std::size_t>(indices[k + corner])]; };
    const double twice = cross(at(1) - at(0), at(2) - at(0));
    EXPECT_NEAR(twice, 1.0, 1e-12);
    area += 0.5 * twice;
  }
  EXPECT_NEAR(area, def.length * def.width, 1e-12);
  EXPECT_TRUE(ribbon::triangle_indices(6, 1).empty());
}

}  // namespace
