#include "ribbon/collision/stored_touches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ribbon {
namespace {

Touch place(std::uint64_t other, int feature, int other_feature, double force = 0.0) {
  Touch touch;
  touch.other = other;
  touch.feature = feature;
  touch.other_feature = other_feature;
  touch.force = force;
  return touch;
}

CordParts cord_with(std::vector<Touch> touches) {
  CordDef def;
  def.points = 5;
  CordParts cord(def);
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) { return a.place_before(b); });
  cord.state.touches = std::move(touches);
  return cord;
}

TEST(StoredTouches, AreFoundByAllThatNamesTheirPlace) {
  const CordParts cord =
      cord_with({place(7, 3, 0, 1.0), place(7, 3, 2, 2.0), place(7, 4, 0, 3.0), place(9, 3, 0, 4.0)});
  StoredTouches touches;
  touches.list(cord);
  for (const Touch& stored : cord.state.touches) {
    const Touch* found = touches.find(place(stored.other, stored.feature, stored.other_feature));
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(*found, stored);
  }
  EXPECT_EQ(touches.find(place(7, 3, 1)), nullptr) << "another feature of the other cord";
  EXPECT_EQ(touches.find(place(8, 3, 0)), nullptr) << "another cord";
  EXPECT_EQ(touches.find(place(7, 5, 0)), nullptr) << "another feature of the cord";
  EXPECT_EQ(touches.find(place(7, 9, 0)), nullptr) << "the last feature that a rope of five points has";
}

TEST(StoredTouches, OfTwoAtOnePlaceTheFirstIsFound) {
  const CordParts cord = cord_with({place(7, 3, 0, 1.0), place(7, 3, 0, 2.0)});
  StoredTouches touches;
  touches.list(cord);
  EXPECT_EQ(touches.find(place(7, 3, 0)), cord.state.touches.data());
}

TEST(StoredTouches, AnotherCordsListLeavesNothingOfTheLast) {
  const CordParts before = cord_with({place(7, 3, 0), place(7, 8, 0)});
  const CordParts after = cord_with({place(7, 4, 0)});
  StoredTouches touches;
  touches.list(before);
  touches.list(after);
  EXPECT_EQ(touches.find(place(7, 3, 0)), nullptr);
  EXPECT_EQ(touches.find(place(7, 8, 0)), nullptr);
  EXPECT_NE(touches.find(place(7, 4, 0)), nullptr);
}

/// A restored state may name features that its cord does not have.
TEST(StoredTouches, AFeatureThatTheCordDoesNotHaveIsLeftOut) {
  const CordParts cord = cord_with({place(7, -2, 0), place(7, 1000, 0), place(7, 3, 0)});
  StoredTouches touches;
  touches.list(cord);
  EXPECT_NE(touches.find(place(7, 3, 0)), nullptr);
}

}  // namespace
}  // namespace ribbon
