#include "ribbon/collision/outline.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/dice.h"

namespace ribbon {
namespace {

using test_support::Dice;

CordDef random_def(Dice& dice) {
  CordDef def;
  def.points = 2 + static_cast<int>(dice(0.0, 12.0));
  def.rows = 1 + static_cast<int>(dice(0.0, 4.0));
  def.length = dice(0.5, 3.0);
  def.width = dice(0.1, 1.0);
  def.radius = dice(0.005, 0.3);
  return def;
}

/// Calls check(point, link) for all of an outline.
template <typename Check>
void for_all(const CordDef& def, Check&& check) {
  const int points = static_cast<int>(CordParts(def).outline.size());
  for (int k = 0; k < points; ++k) {
    for (int link = 0; link < (def.rows == 1 ? points - 1 : points); ++link) check(k, link);
  }
}

TEST(Outline, ListedRestPositionsGiveTheSameNeighbours) {
  Dice dice(1);
  std::vector<Vec2> rest;
  int neighbours = 0;
  int others = 0;
  for (int run = 0; run < 200; ++run) {
    const CordDef def = random_def(dice);
    list_rest_positions(def, rest);
    ASSERT_EQ(rest.size(), CordParts(def).outline.size());
    for_all(def, [&](int k, int link) {
      for (const int near : {link - 1, link, link + 1}) {
        const bool are = are_neighbours(def, k, near);
        ++(are ? neighbours : others);
        EXPECT_EQ(are_neighbours(def, rest, k, near), are)
            << def.points << " × " << def.rows << ": " << k << ", " << near;
      }
    });
  }
  EXPECT_GT(neighbours, 10'000);
  EXPECT_GT(others, 10'000);
}

TEST(Outline, NoNeighbourIsOverlooked) {
  Dice dice(2);
  std::vector<Vec2> rest;
  int left_out = 0;
  for (int run = 0; run < 200; ++run) {
    const CordDef def = random_def(dice);
    list_rest_positions(def, rest);
    for_all(def, [&](int k, int link) {
      if (may_be_neighbours(def, rest, k, link)) return;
      ++left_out;
      for (const int near : {link - 1, link, link + 1}) {
        EXPECT_FALSE(are_neighbours(def, k, near)) << def.points << " × " << def.rows << ": " << k << ", " << near;
      }
    });
  }
  EXPECT_GT(left_out, 1000);
}

}  // namespace
}  // namespace ribbon
