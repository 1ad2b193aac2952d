#include "game/view/free_space.h"

#include <gtest/gtest.h>

#include <array>

namespace game {
namespace {

using ribbon::Vec2;

constexpr Rectangle area{{10.0, 20.0}, {400.0, 200.0}};
constexpr std::array corners = {Vec2{10.0, 20.0}, Vec2{310.0, 20.0}, Vec2{310.0, 190.0}};
constexpr Vec2 size{100.0, 30.0};

TEST(FreeSpace, GivesTheFirstPlaceThatIsFree) {
  FreeSpace space(area, 5.0);
  int last = 0;
  EXPECT_EQ(space.place(size, corners, last), corners[0]);
  EXPECT_EQ(space.place(size, corners, last), corners[1]);
  EXPECT_EQ(last, 1);
  space.take({{300.0, 185.0}, {10.0, 10.0}});
  const auto other = space.place(size, corners, last);
  ASSERT_TRUE(other);
  EXPECT_EQ(shared_area({*other, size}, {{300.0, 185.0}, {10.0, 10.0}}), 0.0);
  for (const Vec2 taken : {corners[0], corners[1]}) EXPECT_EQ(shared_area({*other, size}, {taken, size}), 0.0);
  EXPECT_GE(other->x, area.corner.x);
  EXPECT_LE(other->y + size.y, area.corner.y + area.size.y);
}

TEST(FreeSpace, GivesNoneToABoxThatFitsNowhere) {
  FreeSpace space(area, 5.0);
  int last = 0;
  EXPECT_FALSE(space.place({401.0, 10.0}, corners, last));
  space.take({{10.0, 100.0}, {400.0, 40.0}});
  EXPECT_FALSE(space.place({100.0, 100.0}, corners, last));
  EXPECT_TRUE(space.place({100.0, 60.0}, corners, last));
}

/// A sign that passes below the first place, to and fro, moves the box away once.
TEST(FreeSpace, ABoxReturnsOnlyWhenItHasRoomToSpare) {
  int last = 0;
  const auto place_beside = [&last](double sign) {
    FreeSpace space(area, 5.0);
    space.take({{sign, 20.0}, {50.0, 30.0}});
    return space.place(size, corners, last);
  };
  EXPECT_EQ(place_beside(116.0), corners[0]);
  EXPECT_EQ(place_beside(114.0), corners[1]);
  EXPECT_EQ(place_beside(116.0), corners[1]) << "as little as before is not enough";
  EXPECT_EQ(place_beside(131.0), corners[0]);
}

}  // namespace
}  // namespace game
