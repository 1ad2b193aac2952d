#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "ribbon/cord.h"
#include "ribbon/rigid_circle.h"
#include "tests/support/constants.h"

// What keeps a body that holds a cord from moving, without Box2D.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

/// A body that holds the first point of a cord. Supports keep it from moving down and sideways.
struct SupportedBody {
  explicit SupportedBody(Cord of, double mass = 1.0) : cord(std::move(of)) {
    body.position = cord.positions()[0];
    body.inverse_mass = 1.0 / mass;
    body.inverse_inertia = 10.0 / mass;
    supports = {{{0, {}, {0.0, 1.0}}, {0, {}, {1.0, 0.0}}, {0, {}, {-1.0, 0.0}}}};
  }

  IslandReport step() {
    body.acceleration = gravity;
    body.impulse = body.moved = {};
    body.angular_impulse = 0.0;
    Surroundings surroundings{std::span(&body, 1), {}, grips};
    surroundings.supports = supports;
    const IslandReport report = cord.step(dt, gravity, surroundings);
    body.velocity += dt * body.acceleration + body.inverse_mass * body.impulse;
    body.angular_velocity += body.inverse_inertia * body.angular_impulse;
    body.position += body.moved;
    return report;
  }

  Cord cord;
  RigidBody body;
  std::array<Grip, 1> grips{Grip{0, 0, {}}};
  std::array<Support, 3> supports;
};

/// A cord of 10 m and 1 kg that is released from the horizontal with a load at its end.
Cord swing(double load, const Accuracy& accuracy, bool pinned) {
  CordDef def;
  def.accuracy = accuracy;
  if (pinned) def.pins = {0};
  Cord cord(def);
  cord.attach_mass(50, load);
  return cord;
}

class SupportedSwing : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(MassRatios, SupportedSwing, testing::Values(1.0, 70.0, 1000.0));

/// A load of a thousand times the body's mass swings as from a pin.
TEST_P(SupportedSwing, FollowsThatOfAPinnedCord) {
  for (const Accuracy& accuracy : {Accuracy::balanced(), Accuracy::accurate()}) {
    Cord pinned = swing(GetParam(), accuracy, true);
    SupportedBody supported(swing(GetParam(), accuracy, false));
    double apart = 0.0;
    double sunk = 0.0;
    int unconverged = 0;
    for (int k = 0; k < 120; ++k) {
      pinned.step(dt, gravity);
      unconverged += supported.step().unconverged;
      apart = std::max(apart, length(supported.cord.positions()[50] - pinned.positions()[50]));
      sunk = std::max(sunk, length(supported.body.position));
    }
    EXPECT_LT(apart, 0.03);
    EXPECT_LT(sunk, 1e-3);
    EXPECT_EQ(unconverged, 0);
  }
}

/// The forces of the supports carry all that hangs on the body.
TEST(Supports, CarryWhatHangsOnTheirBody) {
  CordDef def;
  def.positions = {};
  for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, -0.2 * k});
  Cord cord(def);
  cord.attach_mass(50, 1000.0);
  SupportedBody supported(std::move(cord));
  for (int k = 0; k < 120; ++k) EXPECT_EQ(supported.step().unconverged, 0);
  EXPECT_NEAR(supported.body.support_force.y, 1002.0 * 9.81, 0.02 * 1002.0 * 9.81);
  EXPECT_NEAR(supported.body.support_force.x, 0.0, 1e-3);
  EXPECT_LT(length(supported.body.position), 1e-3);
  EXPECT_LT(length(supported.body.velocity), 1e-3);
}

/// A support pushes only: what is drawn away from it leaves it at once.
TEST(Supports, LetABodyLeaveThem) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.pins = {10};
  def.positions = {};
  for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, 0.1 * k});
  SupportedBody supported{Cord(def)};
  for (int k = 1; k <= 30; ++k) {
    supported.cord.constrain(10, {0.0, 1.0 + 1.0 * k * dt});
    supported.step();
    EXPECT_NEAR(supported.body.position.y, 1.0 * k * dt, 1e-3) << k;
    for (Support& support : supported.supports) support.gap = support.normal.y * supported.body.position.y;
  }
  EXPECT_EQ(supported.body.support_force, Vec2{});
}

/// A support that rises lifts its body, and one that is `gap` away stops it there.
TEST(Supports, MoveAndMayBeAtADistance) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.positions = {};
  for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, -0.1 * k});
  SupportedBody lifted{Cord(def)};
  for (Support& support : lifted.supports) support.speed = support.normal.y;  // upwards at 1 m/s
  lifted.step();
  EXPECT_NEAR(lifted.body.moved.y, dt, 1e-3);
  SupportedBody falling{Cord(def)};
  for (Support& support : falling.supports) support.gap = 5e-4 * support.normal.y;
  falling.step();
  EXPECT_NEAR(falling.body.moved.y, -5e-4, 1e-5);
}

/// A support beside the centre of mass turns the body.
TEST(Supports, ActWhereTheyAre) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.positions = {};
  for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, -0.1 * k});
  SupportedBody tipping{Cord(def)};
  tipping.supports[0] = {0, {-0.1, -0.1}, {0.0, 1.0}};
  tipping.supports[1] = tipping.supports[2] = tipping.supports[0];
  for (int k = 0; k < 3; ++k) tipping.step();
  EXPECT_LT(tipping.body.angular_velocity, -0.3);
  SupportedBody standing{Cord(def)};
  standing.supports[0] = {0, {-0.1, -0.1}, {0.0, 1.0}};
  standing.supports[1] = standing.supports[2] = {0, {0.1, -0.1}, {0.0, 1.0}};
  for (int k = 0; k < 30; ++k) standing.step();
  EXPECT_NEAR(standing.body.angular_velocity, 0.0, 1e-3);
  EXPECT_NEAR(standing.body.position.y, 0.0, 1e-4);
}

}  // namespace
}  // namespace ribbon
