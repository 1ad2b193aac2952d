#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/direct_solver.h"
#include "ribbon/rigid_circle.h"
#include "tests/support/constants.h"

// What keeps bodies of a step from moving, without Box2D.

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

/// A body of 1 kg holds a load of 100 kg and lies on another one of 1,000 kg, which nothing else holds. The heavier one
/// is drawn along, and what the lighter one turns by goes to it.
TEST(Supports, ThatGiveWayAreMovedByWhatTheyCarry) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.mass_per_length = 1.0;
  for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, -0.1 * k});
  Cord cord(def);
  cord.attach_mass(10, 100.0);
  const std::array grips{Grip{0, 0, {}}};
  const std::array supports{Support{0, {0.2, -0.1}, {0.0, 1.0}, 0.0, 0.0, 1, {-0.3, 0.1}},
                            Support{0, {-0.2, -0.1}, {0.0, 1.0}, 0.0, 0.0, 1, {-0.7, 0.1}}};
  std::array<RigidBody, 2> bodies;
  bodies[0].inverse_mass = 1.0;
  bodies[0].inverse_inertia = 10.0;
  bodies[0].acceleration = gravity;
  bodies[1].position = {0.5, -0.2};
  bodies[1].inverse_mass = 1e-3;
  bodies[1].inverse_inertia = 1e-3;
  Surroundings surroundings{bodies, {}, grips};
  surroundings.supports = supports;
  EXPECT_EQ(cord.step(dt, gravity, surroundings).unconverged, 0);
  const double fall = 102.0 * 9.81 * dt;  // kg·m/s
  double momentum = bodies[0].impulse.y - 9.81 * dt + bodies[1].impulse.y;
  for (int k = 0; k < def.points; ++k)
    momentum += (k == 0 || k == 10 ? 0.05 : 0.1) * cord.velocities()[static_cast<std::size_t>(k)].y;
  momentum += 100.0 * cord.velocities()[10].y;
  EXPECT_NEAR(momentum, -fall, 1e-9 * fall);
  EXPECT_NEAR(bodies[1].moved.y - 0.5 * bodies[1].turned, bodies[0].moved.y, 1e-6);
  EXPECT_GT(bodies[1].turned, 1e-5);
  EXPECT_NEAR(bodies[0].turned, bodies[1].turned, 1e-6);
  EXPECT_NEAR(bodies[0].support_force.y, -bodies[1].support_force.y, 1e-6);
  EXPECT_GT(bodies[0].support_force.y, 500.0);
}

/// A kinematic body that rises lifts the one on it. Two of them that are driven into each other support none.
TEST(Supports, OfBodiesThatAreDrivenRiseWithThem) {
  for (const bool holder_is_driven : {false, true}) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    for (int k = 0; k < def.points; ++k) def.positions.push_back({0.0, -0.1 * k});
    Cord cord(def);
    const std::array grips{Grip{0, 0, {}}};
    const std::array supports{Support{0, {0.0, -0.1}, {0.0, 1.0}, 0.0, 0.0, 1, {0.0, 0.1}}};
    std::array<RigidBody, 2> bodies;
    if (!holder_is_driven) bodies[0].inverse_mass = 1.0;
    bodies[0].acceleration = gravity;
    bodies[1].position = {0.0, -0.2};
    bodies[1].velocity = {0.0, 1.0};
    Surroundings surroundings{bodies, {}, grips};
    surroundings.supports = supports;
    EXPECT_EQ(cord.step(dt, gravity, surroundings).unconverged, 0);
    EXPECT_NEAR(cord.positions()[0].y, holder_is_driven ? 0.0 : dt, 1e-3);
  }
}

/// Each of two cords holds one of two bodies, one of which lies on the other: what a body takes, the other one gives.
TEST(Supports, ThatGiveWayJoinCords) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  std::vector<Cord> cords;
  for (const double y : {0.0, -0.2}) {
    def.positions.clear();
    for (int k = 0; k < def.points; ++k) def.positions.push_back({0.1 * k, y});
    cords.emplace_back(def);
  }
  std::array<RigidBody, 2> bodies;
  for (RigidBody& body : bodies) body.inverse_mass = 1.0;
  bodies[0].velocity = {0.0, -1.0};
  bodies[1].position = {0.0, -0.2};
  const std::array grips_of_upper{Grip{0, 0, {}}};
  const std::array grips_of_lower{Grip{0, 1, {}}};
  const std::array supports{Support{0, {0.0, -0.1}, {0.0, 1.0}, 0.0, 0.0, 1, {0.0, 0.1}}};
  std::array<Surroundings, 2> surroundings{Surroundings{bodies, {}, grips_of_upper}, {bodies, {}, grips_of_lower}};
  surroundings[0].supports = surroundings[1].supports = supports;
  const std::array all{IslandCord{&cords[0], surroundings[0], 1}, IslandCord{&cords[1], surroundings[1], 2}};
  DirectSolver solver;
  std::array<CordReport, 2> reports;
  solver.step(all, bodies, dt, {}, reports);
  EXPECT_EQ(solver.islands(), 1);
  const double upper = bodies[0].velocity.y + bodies[0].impulse.y;
  const double lower = bodies[1].velocity.y + bodies[1].impulse.y;
  EXPECT_GE(upper, lower);
  EXPECT_LT(lower, -0.3);
  EXPECT_GT(bodies[0].moved.y - bodies[1].moved.y, -1e-5);
}

}  // namespace
}  // namespace ribbon
