#include "game/view/camera.h"
#include "tests/game/view/window_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace game {
namespace {

using ribbon::Vec2;

constexpr Vec2 level{48.0, 18.0};

CameraSubject at(Vec2 place, Vec2 velocity = {}) {
  CameraSubject subject;
  subject.on_ground = true;
  subject.at = place;
  subject.velocity = velocity;
  return subject;
}

void expect_within_level(const engine::View& view, int pixels_wide, int pixels_high) {
  const double half_width = 0.5 * pixels_wide / view.pixels_per_metre;
  const double half_height = 0.5 * pixels_high / view.pixels_per_metre;
  EXPECT_GE(view.center.x - half_width, -1e-9);
  EXPECT_LE(view.center.x + half_width, level.x + 1e-9);
  EXPECT_GE(view.center.y - half_height, -1e-9);
  EXPECT_LE(view.center.y + half_height, level.y + 1e-9);
}

TEST(Camera, NeverShowsWhatIsOutsideTheLevel) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-30.0, 80.0);
  std::uniform_real_distribution<double> speed(-40.0, 40.0);
  Camera camera(level);
  for (int k = 0; k < 2000; ++k) {
    CameraSubject subject = at({place(random), place(random)}, {speed(random), speed(random)});
    subject.lands = k % 7 == 0;
    subject.impact = 40.0;
    camera.tick(subject);
    for (const auto& [w, h] : {std::pair{1280, 720}, std::pair{400, 900}, std::pair{3000, 500}})
      expect_within_level(camera.view(0.3, w, h, k % 2 == 0), w, h);
  }
}

TEST(Camera, LooksAheadInTheDirectionOfMotion) {
  for (const double side : {-1.0, 1.0}) {
    Camera camera(level);
    CameraSubject subject = at({24.0, 9.0}, {side * 6.0, 0.0});
    subject.faces_left = side < 0.0;
    camera.jump_to(subject);
    for (int k = 0; k < 60; ++k) {
      subject.at.x += subject.velocity.x / 60.0;
      camera.tick(subject);
    }
    EXPECT_GT(side * (camera.view(1.0, window_width, window_height, false).center.x - subject.at.x), 2.0);
  }
}

TEST(Camera, LooksUpASwing) {
  const auto height_above = [](double speed) {
    Camera camera({48.0, 40.0});
    CameraSubject subject = at({24.0, 20.0}, {0.0, speed});
    subject.on_ground = false;
    subject.hangs = true;
    camera.jump_to(subject);
    return camera.view(1.0, window_width, window_height, true).center.y - 20.0;
  };
  EXPECT_GT(height_above(6.0), height_above(0.0) + 1.0);
  EXPECT_LT(height_above(-6.0), height_above(0.0) - 1.0);
}

TEST(Camera, ComesToRestWhereItWouldJump) {
  Camera jumped(level);
  jumped.jump_to(at({20.0, 8.0}));
  Camera followed(level);
  followed.jump_to(at({35.0, 12.0}, {9.0, 3.0}));
  double before = 1e9;
  for (int k = 0; k < 600; ++k) {
    followed.tick(at({20.0, 8.0}));
    const double away = length(followed.view(1.0, window_width, window_height, false).center -
                               jumped.view(1.0, window_width, window_height, false).center);
    if (k > 60) {
      EXPECT_LE(away, before + 1e-9) << k;
    }
    before = away;
  }
  EXPECT_LT(before, 1e-3);
  EXPECT_NEAR(followed.view(1.0, window_width, window_height, false).pixels_per_metre,
              jumped.view(1.0, window_width, window_height, false).pixels_per_metre, 1e-3);
}

TEST(Camera, MovesSmoothly) {
  Camera camera(level);
  CameraSubject subject = at({10.0, 9.0}, {6.0, 0.0});
  camera.jump_to(subject);
  Vec2 before = camera.view(1.0, window_width, window_height, true).center;
  Vec2 step_before{0.1, 0.0};
  for (int k = 0; k < 200; ++k) {
    if (k == 60) subject.velocity = {-6.0, 8.0};  // a sudden reversal
    if (k == 60) subject.faces_left = true;
    subject.at += (1.0 / 60.0) * subject.velocity;
    if (k > 100) subject.velocity.y = 0.0;
    camera.tick(subject);
    const Vec2 now = camera.view(1.0, window_width, window_height, true).center;
    EXPECT_LT(length(now - before - step_before), 0.04) << k;
    step_before = now - before;
    before = now;
  }
}

/// Three jumps of 6.5 m/s on level ground.
TEST(Camera, DoesNotBobWithJumps) {
  Camera camera(level);
  CameraSubject subject = at({15.0, 9.0}, {6.0, 0.0});
  camera.jump_to(subject);
  for (int k = 0; k < 60; ++k) camera.tick(subject);
  const double still = camera.view(1.0, window_width, window_height, false).center.y;
  for (int k = 0; k < 260; ++k) {
    if (k % 85 == 0) subject.velocity.y = 6.5;
    subject.at += (1.0 / 60.0) * subject.velocity;
    subject.velocity.y -= 10.0 / 60.0;
    subject.on_ground = subject.at.y <= 9.0;
    if (subject.on_ground) {
      subject.at.y = 9.0;
      subject.velocity.y = 0.0;
    }
    camera.tick(subject);
    EXPECT_NEAR(camera.view(1.0, window_width, window_height, false).center.y, still, 0.05) << k;
  }
}

TEST(Camera, LooksDownInAFastFall) {
  Camera camera({48.0, 60.0});
  CameraSubject subject = at({24.0, 50.0});
  camera.jump_to(subject);
  subject.on_ground = false;
  for (int k = 0; k < 90; ++k) {
    subject.velocity.y -= 10.0 / 60.0;
    subject.at.y += subject.velocity.y / 60.0;
    camera.tick(subject);
  }
  EXPECT_LT(camera.view(1.0, window_width, window_height, false).center.y, subject.at.y - 0.5);
}

TEST(Camera, ShakesOnAHardLandingOnly) {
  const auto shaken = [](double impact, bool reduced) {
    Camera still(level);
    Camera camera(level);
    CameraSubject subject = at({24.0, 9.0});
    still.jump_to(subject);
    camera.jump_to(subject);
    double most = 0.0;
    for (int k = 0; k < 30; ++k) {
      subject.lands = k == 0;
      subject.impact = impact;
      camera.tick(subject);
      still.tick(at({24.0, 9.0}));
      most = std::max(most, length(camera.view(1.0, window_width, window_height, reduced).center -
                                   still.view(1.0, window_width, window_height, reduced).center));
    }
    EXPECT_LT(length(camera.view(1.0, window_width, window_height, reduced).center -
                     still.view(1.0, window_width, window_height, reduced).center),
              0.01);
    return most;
  };
  EXPECT_GT(shaken(14.0, false), 0.03);
  EXPECT_LT(shaken(40.0, false), 0.4);
  EXPECT_EQ(shaken(4.0, false), 0.0);
  EXPECT_EQ(shaken(14.0, true), 0.0);
}

/// Two players side by side, and one high above the other.
TEST(Camera, HasBothPlayersInThePicture) {
  for (const Vec2 spread : {Vec2{2.0, 0.0}, Vec2{8.0, 1.0}, Vec2{12.0, 3.0}, Vec2{1.0, 5.0}}) {
    for (const bool reduced_motion : {false, true}) {
      CameraSubject both = at({24.0, 9.0});
      both.spread = spread;
      Camera camera(level);
      camera.jump_to(both);
      for (int k = 0; k < 300; ++k) camera.tick(both);
      const engine::View view = camera.view(1.0, window_width, window_height, reduced_motion);
      expect_within_level(view, window_width, window_height);
      for (const double side : {-1.0, 1.0}) {
        const Vec2 off = both.at + side * spread - view.center;
        EXPECT_LT(std::abs(off.x) * view.pixels_per_metre, 0.5 * window_width - 20.0) << spread.x << " " << spread.y;
        EXPECT_LT(std::abs(off.y) * view.pixels_per_metre, 0.5 * window_height - 20.0) << spread.x << " " << spread.y;
      }
    }
  }
}

TEST(Camera, DoesNotZoomOutWithoutLimit) {
  CameraSubject both = at({24.0, 9.0});
  both.spread = Vec2{1000.0, 0.0};
  Camera camera({400.0, 300.0});
  camera.jump_to(both);
  EXPECT_GT(camera.view(1.0, window_width, window_height, false).pixels_per_metre, window_height / 27.0);
}

TEST(Camera, ShowsMoreOfTheLevelAtHighSpeed) {
  Camera slow(level);
  Camera fast(level);
  slow.jump_to(at({24.0, 9.0}));
  fast.jump_to(at({24.0, 9.0}, {12.0, 0.0}));
  EXPECT_LT(fast.view(1.0, window_width, window_height, false).pixels_per_metre,
            0.9 * slow.view(1.0, window_width, window_height, false).pixels_per_metre);
  EXPECT_EQ(fast.view(1.0, window_width, window_height, true).pixels_per_metre,
            slow.view(1.0, window_width, window_height, true).pixels_per_metre);
}

}  // namespace
}  // namespace game
