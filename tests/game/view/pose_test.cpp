#include "game/view/pose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace game {
namespace {

using ribbon::Vec2;

constexpr double soles = 0.75;  // m below the middle

/// A cord that hangs at rest, held at `held`.
HeldCord cord_at(Vec2 held) { return {{held, held + Vec2{0.0, 1.0}}, {held, held - Vec2{0.0, 2.0}}, 0.3 * held.x}; }

FigureState some_state(std::mt19937& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  FigureState state;
  state.at = {20.0 * any(random), 10.0 * any(random)};
  state.velocity = {10.0 * any(random), 10.0 * any(random)};
  state.faces_left = any(random) < 0.0;
  state.on_ground = any(random) < 0.0;
  if (any(random) < 0.0) state.cord = cord_at(state.at + Vec2{0.6 * any(random), 0.5 + 0.4 * any(random)});
  state.climbs = any(random) < 0.0;
  if (any(random) < 0.0) state.throws_at = state.at + Vec2{9.0 * any(random), 9.0 * any(random)};
  if (any(random) < 0.0) state.cheers = 1.0 + any(random);
  state.time = 50.0 + 50.0 * any(random);
  return state;
}

/// Only an arm that holds a cord out of its reach is longer.
TEST(Pose, BonesKeepTheirLengths) {
  std::mt19937 random(9);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const FigureState state = some_state(random);
    const Pose pose = pose_of(state);
    for (const std::size_t k : {0U, 1U}) {
      EXPECT_NEAR(length(pose.knee[k] - pose.hip), 0.34, 1e-9);
      EXPECT_NEAR(length(pose.foot[k] - pose.knee[k]), 0.34, 1e-9);
      const double reach = length(pose.hand[k] - pose.shoulder[k]);
      const double bone = state.cord ? std::max(0.27, 0.5 * reach) : 0.27;
      EXPECT_NEAR(length(pose.elbow[k] - pose.shoulder[k]), bone, 1e-9);
      EXPECT_NEAR(length(pose.hand[k] - pose.elbow[k]), bone, 1e-9);
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
    state.cord = cord_at(state.at + Vec2{across, 0.95});
    const Pose pose = pose_of(state);
    EXPECT_LT(length(pose.hand[0] - state.cord->at(-0.13)), 1e-9) << across;
    EXPECT_LT(length(pose.hand[1] - state.cord->held()), 1e-9) << across;
  }
}

/// While it climbs by small steps, each hand goes down with the cord, and up again.
TEST(Pose, HandsTakeTurnsInAClimb) {
  FigureState state;
  state.on_ground = false;
  state.climbs = true;
  state.velocity = {0.0, 1.8};
  std::array<double, 2> lowest{};
  Pose before = pose_of(state);
  for (int k = 0; k < 60; ++k) {
    state.at.y = 0.03 * k;
    state.cord = cord_at(state.at + Vec2{0.0, 0.95});
    state.cord->climbed = state.at.y;
    const Pose pose = pose_of(state);
    for (const std::size_t hand : {0U, 1U}) {
      lowest[hand] = std::min(lowest[hand], pose.hand[hand].y - state.cord->held().y);
      if (k > 0) {
        EXPECT_LT(length(pose.hand[hand] - before.hand[hand]), 0.1) << k;
        EXPECT_LT(length(pose.foot[hand] - before.foot[hand]), 0.1) << k;
      }
    }
    before = pose;
  }
  EXPECT_LT(lowest[0], -0.2);
  EXPECT_LT(lowest[1], -0.2);
}

TEST(Pose, AFreeHandThrowsTheLine) {
  FigureState state;
  state.throws_at = Vec2{4.0, 3.0};
  for (const bool holds : {false, true}) {
    if (holds) state.cord = cord_at({0.0, 0.95});
    state.on_ground = !holds;
    const Pose pose = pose_of(state);
    const Vec2 to_hook = *state.throws_at - pose.shoulder[1];
    const Vec2 arm = pose.throwing_hand() - pose.shoulder[1];
    EXPECT_NEAR(dot(arm, to_hook), length(arm) * length(to_hook), 1e-9);
    EXPECT_GT(length(arm), 0.5);
  }
  EXPECT_LT(length(pose_of(state).hand[0] - state.cord->held()), 1e-9);
}

TEST(Pose, ArmsAreUpAfterTheGoalExceptInFlight) {
  FigureState state;
  const auto raised = [&state](std::size_t k) {
    const Pose pose = pose_of(state);
    return pose.hand[k].y - pose.head.y;
  };
  for (double time = 0.3; time < 3.0; time += 0.1) {
    state.cheers = time;
    EXPECT_GT(raised(0), 0.0) << time;
    EXPECT_GT(raised(1), 0.0) << time;
  }
  const double down = raised(1);
  state.cheers = 0.0;
  EXPECT_LT(raised(1), down - 0.5) << "it raises them in some ticks, not at once";
  state.cheers = 1.0;
  state.cord = cord_at({0.0, 0.95});
  state.on_ground = false;
  EXPECT_GT(raised(1), 0.0) << "while it hangs";
  EXPECT_LT(length(pose_of(state).hand[0] - state.cord->held()), 1e-9);
  state.cord.reset();
  const Pose cheering = pose_of(state);
  state.cheers.reset();
  EXPECT_EQ(cheering.hand, pose_of(state).hand) << "in the air";
}

TEST(Pose, LegsTrailTheSwing) {
  const auto feet = [](double speed) {
    FigureState state;
    state.on_ground = false;
    state.at = {5.0, 5.0};
    state.cord = cord_at(state.at + Vec2{0.0, 0.9});
    state.velocity = {speed, 0.0};
    const Pose pose = pose_of(state);
    return 0.5 * (pose.foot[0].x + pose.foot[1].x);
  };
  EXPECT_LT(feet(5.0), feet(0.0) - 0.2);
  EXPECT_GT(feet(-5.0), feet(0.0) + 0.2);
}

}  // namespace
}  // namespace game
