#include "game/view/fall.h"

#include <gtest/gtest.h>

#include "engine/window/sdl_canvas.h"
#include "game/simulation/buttons.h"
#include "game/view/effects.h"
#include "game/view/trail.h"
#include "game/view/veil.h"

namespace game {
namespace {

TEST(Fall, GetsDarkAndLightAgainWithinHalfASecond) {
  Fall fall;
  EXPECT_FALSE(fall.is_shown());
  EXPECT_EQ(fall.openness(1.0), 1.0);
  fall.begin({3.0, -3.0}, {1.0, -8.0});
  double before = 1.0;
  int ticks = 0;
  for (; fall.is_closing(); ++ticks) {
    fall.tick();
    const double open = fall.openness(1.0);
    if (fall.is_closing()) {
      EXPECT_LT(open, before) << ticks;
    }
    before = open;
  }
  EXPECT_LE(ticks, Fall::closing);
  before = 0.0;
  for (; fall.is_shown(); ++ticks) {
    EXPECT_GE(fall.openness(1.0), before) << ticks;
    before = fall.openness(1.0);
    fall.tick();
  }
  EXPECT_LE(ticks, ticks_per_second / 2);
  EXPECT_EQ(fall.openness(0.0), 1.0);
}

TEST(Fall, TheFigureFallsOn) {
  Fall fall;
  fall.begin({3.0, 2.0}, {1.0, 0.0});
  for (int k = 0; k < 6; ++k) fall.tick();
  EXPECT_NEAR(fall.at(1.0).x, 3.1, 1e-12);
  EXPECT_NEAR(fall.at(1.0).y, 2.0 - 0.5 * 9.81 * 0.01, 1e-12);
}

/// The player falls off the left edge of the level; the view follows it back.
TEST(Fall, TheViewIsAtThePlayerAgainAfterIt) {
  const Level level = load_level("first_swing");
  Simulation simulation(level);
  Effects effects(simulation);
  engine::TickInput input;
  input.buttons = button_right;
  while (simulation.falls() == 0 && simulation.ticks() < 1200) {
    simulation.tick(input);
    effects.follow(palette(false), false);
  }
  ASSERT_EQ(simulation.falls(), 1);
  EXPECT_TRUE(effects.fall().is_closing());
  const engine::View there = effects.view(1.0, 1280, 720, false);
  simulation.tick({});
  effects.follow(palette(false), false);
  EXPECT_EQ(effects.view(1.0, 1280, 720, false).center.x, there.center.x);  // the picture stays where the fall was
  for (int k = 0; k < ticks_per_second / 2; ++k) {
    simulation.tick({});
    effects.follow(palette(false), false);
  }
  EXPECT_FALSE(effects.fall().is_shown());
  Effects fresh(simulation);
  fresh.follow(palette(false), false);
  EXPECT_NEAR(effects.view(1.0, 1280, 720, false).center.x, fresh.view(1.0, 1280, 720, false).center.x, 1.0);
}

TEST(Veil, AnIrisIsDarkOutsideOfItsHole) {
  engine::HeadlessCanvas canvas(200, 100);
  canvas.clear({200, 200, 200});
  draw_iris(canvas, {100.0, 50.0}, 0.3);
  const auto pixel = [&](int x, int y) {
    return canvas.raster().pixels()[200 * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)];
  };
  EXPECT_EQ(pixel(100, 50), 0xc8c8c8U);
  EXPECT_EQ(pixel(100 + 31, 50), 0xc8c8c8U);
  EXPECT_NE(pixel(100 + 36, 50), 0xc8c8c8U);
  for (const int x : {0, 199})
    for (const int y : {0, 99}) EXPECT_NE(pixel(x, y), 0xc8c8c8U);
  canvas.clear({200, 200, 200});
  draw_iris(canvas, {100.0, 50.0}, 1.0);
  EXPECT_EQ(pixel(0, 0), 0xc8c8c8U);
}

TEST(Veil, AScreenFadesInByTheElapsedTime) {
  ScreenFade fade;
  EXPECT_EQ(fade.darkness(), 0.0);
  fade.begin();
  EXPECT_DOUBLE_EQ(fade.darkness(), 0.8);
  fade.advance(ScreenFade::length_ns / 2);
  EXPECT_DOUBLE_EQ(fade.darkness(), 0.4);
  fade.advance(10 * ScreenFade::length_ns);
  EXPECT_EQ(fade.darkness(), 0.0);
}

TEST(Trail, IsThereAtSpeedAndNotWithReducedMotion) {
  EXPECT_EQ(Trail::strength(5.0), 0.0);
  EXPECT_GT(Trail::strength(10.0), 0.0);
  EXPECT_EQ(Trail::strength(20.0), 1.0);
  Trail trail;
  for (int k = 0; k < 40; ++k) trail.add({0.2 * k, 5.0});
  EXPECT_EQ(trail.count(), Trail::max_count);
  const auto changes = [&](double speed, bool reduced) {
    engine::HeadlessCanvas canvas(320, 180);
    canvas.set_view({{6.0, 5.0}, 15.0});
    const auto before = canvas.raster().pixels();
    Pen pen{canvas, palette(false), textures(false, Place::hills), 1.0, reduced};
    trail.draw(pen, {8.0, 5.0}, {speed, 0.0});
    return canvas.raster().pixels() != before;
  };
  EXPECT_TRUE(changes(14.0, false));
  EXPECT_FALSE(changes(14.0, true));
  EXPECT_FALSE(changes(4.0, false));
}

}  // namespace
}  // namespace game
