#include "game/view/view_in.h"

#include <gtest/gtest.h>

#include "engine/window/sdl_canvas.h"

namespace game {
namespace {

using ribbon::Vec2;

constexpr Vec2 level_size{60.0, 20.0};  // m
constexpr Rectangle right_part{{400.0, 0.0}, {800.0, 600.0}};

/// Returns where the player is on the canvas, if the camera of the part looks at `center`.
Vec2 place_of(Vec2 player, Vec2 center) {
  engine::HeadlessCanvas canvas(1200, 600);
  canvas.set_view(view_in(right_part, canvas, {center, 40.0}, player, level_size));
  return canvas.to_pixels(player);
}

TEST(ViewIn, TheMiddleOfThePartShowsWhatThatOfTheCameraWouldShow) {
  const Vec2 there = place_of({30.0, 8.0}, {30.0, 8.0});
  EXPECT_DOUBLE_EQ(there.x, 800.0);
  EXPECT_DOUBLE_EQ(there.y, 300.0);
}

TEST(ViewIn, ThePlayerIsInThePart) {
  for (double x = 0.5; x < level_size.x; x += 1.0) {
    for (const double lead : {-12.0, -3.0, 0.0, 3.0, 12.0}) {
      const Vec2 there = place_of({x, 8.0}, {x + lead, 8.0});
      EXPECT_GE(there.x, 400.0) << x << " m, lead " << lead;
      EXPECT_LE(there.x, 1200.0) << x << " m, lead " << lead;
    }
  }
}

TEST(ViewIn, ThePartDoesNotShowTheOutsideOfTheLevel) {
  engine::HeadlessCanvas canvas(1200, 600);
  for (const double x : {0.0, 60.0}) {
    canvas.set_view(view_in(right_part, canvas, {{x, 8.0}, 40.0}, {x, 8.0}, level_size));
    EXPECT_GE(canvas.to_world({400.0, 0.0}).x, -1e-9);
    EXPECT_LE(canvas.to_world({1200.0, 0.0}).x, level_size.x + 1e-9);
  }
}

}  // namespace
}  // namespace game
