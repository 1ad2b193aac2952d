#include "ribbon/cord_line.h"

#include <gtest/gtest.h>

#include <vector>

namespace ribbon {
namespace {

TEST(CordLine, IsOneRowOfACord) {
  const std::vector<Vec2> x = {{0.0, 0.0}, {0.0, 1.0}, {2.0, 0.0}, {2.0, 2.0}};
  const CordLine line(x, 2, 1);
  EXPECT_EQ(line.links(), 1);
  EXPECT_EQ(line.at(1), (Vec2{2.0, 2.0}));
  EXPECT_EQ(line.place(0, 0.25), (Vec2{0.5, 1.25}));
  EXPECT_EQ(CordLine(x, 2, 0).length_of(0), 2.0);
  EXPECT_EQ(CordLine(x, 2, 0).tangent(0), (Vec2{1.0, 0.0}));
}

TEST(CordLine, FindsTheNearestPlaceDownhill) {
  const std::vector<Vec2> x = {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {0.0, 1.0}};
  const CordLine line(x, 1, 0);
  EXPECT_EQ(line.nearest_column(0, {0.5, 0.25}), 0.5);
  EXPECT_EQ(line.nearest_column(0, {1.75, 0.25}), 1.75);
  EXPECT_EQ(line.nearest_column(0, {2.5, 0.5}), 2.5);    // around the bend
  EXPECT_EQ(line.nearest_column(4, {0.5, 0.25}), 4.5);   // not the side across, which is nearer
  EXPECT_EQ(line.nearest_column(4, {-1.0, 2.0}), 5.0);   // the end
  EXPECT_EQ(line.nearest_column(2, {-1.0, -1.0}), 0.0);  // the other end, from far
  EXPECT_EQ(line.nearest_column(1, {2.5, -0.5}), 2.0);   // a corner
}

TEST(CordLine, GoesOverLinksWithoutLength) {
  const std::vector<Vec2> x = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  const CordLine line(x, 1, 0);
  EXPECT_EQ(line.tangent(1), Vec2{});
  EXPECT_EQ(line.nearest_column(1, {0.25, 1.0}), 0.25);
  EXPECT_GE(line.nearest_column(0, {1.5, 1.0}), 1.0);  // no place further on is nearer than the point before
}

}  // namespace
}  // namespace ribbon
