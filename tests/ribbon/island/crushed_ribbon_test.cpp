#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/elastic/cell.h"
#include "tests/support/dice.h"
#include "tests/support/slot.h"

// Ribbons that start from shapes that no motion leads to.

namespace ribbon {
namespace {

using test_support::Dice;
using test_support::slot;

int inverted_corners(const Cord& cord) {
  const auto x = cord.positions();
  int count = 0;
  for (int i = 0; i + 1 < cord.def().points; ++i) {
    for (int j = 0; j + 1 < cord.def().rows; ++j) {
      const Corners corners{x[slot(cord.index(i, j))], x[slot(cord.index(i, j + 1))], x[slot(cord.index(i + 1, j))],
                            x[slot(cord.index(i + 1, j + 1))]};
      for (const double area : doubled_corner_areas(corners)) count += area <= 0.0 ? 1 : 0;
    }
  }
  return count;
}

/// Returns the maximum strain of the sides and diagonals of all cells.
double worst_strain(const Cord& cord) {
  const CordDef& def = cord.def();
  const Vec2 rest{def.length / (def.points - 1), def.width / (def.rows - 1)};
  double worst = 0.0;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) {
      for (const auto& [di, dj] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
        if (i + di >= def.points || j + dj >= def.rows) continue;
        const Vec2 side = cord.positions()[slot(cord.index(i + di, j + dj))] - cord.positions()[slot(cord.index(i, j))];
        worst = std::max(worst, std::abs(length(side) / length({di * rest.x, dj * rest.y}) - 1.0));
      }
    }
  }
  return worst;
}

enum class Start { random, collapsed, mirrored, folded };

struct Crushed {
  int columns;
  int rows;
  Start start;
};

CordDef crushed(const Crushed& what, unsigned seed) {
  CordDef def;
  def.points = what.columns;
  def.rows = what.rows;
  def.length = 0.05 * (what.columns - 1);
  def.width = 0.05 * (what.rows - 1);
  def.mass_per_length = 0.5;
  solid(2e5, 0.0, 0.1, def.width).apply_to(def);
  def.area_stiffness = 1.0;
  def.damping = 0.05;
  def.accuracy = Accuracy::balanced();
  Dice dice(seed);
  const Cord rest(def);
  const double fold = def.length * (0.3 + 0.4 * dice());
  for (Vec2 p : rest.positions()) {
    const Vec2 off{1e-3 * dice(), 1e-3 * dice()};
    switch (what.start) {
      case Start::random: p = {dice() * def.length, dice() * def.length}; break;
      case Start::collapsed: p = off; break;
      case Start::mirrored: p = Vec2{p.x, -p.y} + off; break;
      case Start::folded: p = Vec2{p.x > fold ? 2.0 * fold - p.x : p.x, p.y} + off; break;
    }
    def.positions.push_back(p);
  }
  return def;
}

class LongCrushedRibbon : public testing::TestWithParam<Crushed> {};

TEST_P(LongCrushedRibbon, RecoversItsShapeInFourSeconds) {
  IslandReport report;
  double worst = 0.0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    Cord cord(crushed(GetParam(), seed));
    for (int k = 0; k < 240; ++k) report += cord.step(1.0 / 60.0, {});
    EXPECT_EQ(inverted_corners(cord), 0) << "seed " << seed;
    worst = std::max(worst, worst_strain(cord));
  }
  EXPECT_LE(worst, 1e-3);
  EXPECT_GT(report.unlocked, 0);
  EXPECT_EQ(report.unconverged, 0);
  RecordProperty("worst_strain", std::to_string(worst));
}

std::vector<Crushed> all_crushed() {
  std::vector<Crushed> all;
  for (const auto& [columns, rows] : {std::pair{25, 2}, {12, 3}, {10, 5}}) {
    for (const Start start : {Start::random, Start::collapsed, Start::mirrored, Start::folded}) {
      all.push_back({columns, rows, start});
    }
  }
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, LongCrushedRibbon, testing::ValuesIn(all_crushed()));

TEST(CordGuard, WithoutAreaStiffnessARibbonMayStayInverted) {
  int inverted = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    CordDef def = crushed({12, 3, Start::random}, seed);
    def.area_stiffness = 0.0;
    Cord cord(def);
    for (int k = 0; k < 240; ++k) EXPECT_EQ(cord.step(1.0 / 60.0, {}).unlocked, 0);
    inverted += inverted_corners(cord) > 0 ? 1 : 0;
  }
  EXPECT_GT(inverted, 0);
}

}  // namespace
}  // namespace ribbon
