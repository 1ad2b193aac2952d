#include "game/view/pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double soles = 0.75;  // m below the middle

FigureState some_state(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  FigureState state;
  state.at = {20.0 * any(random), 10.0 * any(random)};
  state.velocity = {10.0 * any(random), 10.0 * any(random)};
  state.faces_left = any(random) < 0.0;
  state.on_ground = any(random) < 0.0;
  if (any(random) < 0.0) state.held = state.at + Vec2{0.6 * any(random), 0.5 + 0.4 * any(random)};
  state.climbing = any(random);
  state.time = 50.0 + 50.0 * any(random);
  return state;
}

TEST(Pose, BonesKeepTheirLengths) {
  std::mt19937 random(9);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const Pose pose = pose_of(some_state(random));
    for (const std::size_t k : {0U, 1U}) {
      EXPECT_NEAR(length(pose.knee[k] - pose.hip), 0.34, 1e-9);
      EXPECT_NEAR(length(pose.foot[k] - pose.knee[k]), 0.34, 2e-3);
      EXPECT_NEAR(length(pose.elbow[k] - (pose.neck - Vec2{0.0, 0.06})), 0.27, 1e-9);
      EXPECT_NEAR(length(pose.hand[k] - pose.elbow[k]), 0.27, 2e-3);
    }
    EXPECT_NEAR(length(pose.neck - pose.hip), 0.44, 1e-9);
  }
}

TEST(Pose, FeetDoNotGoIntoTheGroundTheyRunOn) {
  for (const double speed : {0.0, 1.0, 3.0, 6.0, -6.0}) {
    for (int k = 0; k < 200; ++k) {
      FigureState state;
      state.at = {0.05 * k, 5.0};
      state.velocity = {speed, 0.0};
      state.faces_left = speed < 0.0;
      const Pose pose = pose_of(state);
      EXPECT_GT(std::min(pose.foot[0].y, pose.foot[1].y), state.at.y - soles);
      // One foot is on the ground, or nearly.
      EXPECT_LT(std::min(pose.foot[0].y, pose.foot[1].y), state.at.y - soles + 0.22);
    }
  }
}

TEST(Pose, HandsHoldTheCord) {
  FigureState state;
  state.on_ground = false;
  state.at = {5.0, 5.0};
  for (double across = -0.4; across <= 0.4; across += 0.1) {
    state.held = state.at + Vec2{across, 0.75};
    const Pose pose = pose_of(state);
    EXPECT_LT(length(pose.hand[0] - *state.held), 0.2) << across;
    EXPECT_LT(length(pose.hand[1] - *state.held), 0.2) << across;
  }
}

TEST(Pose, LegsTrailTheSwing) {
  const auto feet = [](double speed) {
    FigureState state;
    state.on_ground = false;
    state.at = {5.0, 5.0};
    state.held = state.at + Vec2{0.0, 0.9};
    state.velocity = {speed, 0.0};
    const Pose pose = pose_of(state);
    return 0.5 * (pose.foot[0].x + pose.foot[1].x);
  };
  EXPECT_LT(feet(5.0), feet(0.0) - 0.2);
  EXPECT_GT(feet(-5.0), feet(0.0) + 0.2);
}

}  // namespace
}  // namespace game
