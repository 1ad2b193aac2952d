#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "ribbon/direct_solver.h"
#include "ribbon/linear/index.h"
#include "ribbon/pulley.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/pulleys.h"

// Cords that cannot run on around their wheels.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
using test_support::Atwood;
using test_support::hanging;
using test_support::Machine;

/// What is tied to a cord stops it before the wheel.
TEST(BlockedPulley, StopsAtATie) {
  Atwood atwood;
  atwood.right = 20.0;
  Machine machine(atwood);
  CordDef def = hanging(6, 0.5);
  def.pins = {};
  const Vec2 at_tie = machine.cord.positions()[15];
  for (Vec2& x : def.positions) x += at_tie;
  Cord other(def);
  DirectSolver solver;
  const Axle axle{0, {}};
  const Tie tie{0, 15, 1, 0};
  std::vector<CordReport> reports(2);
  std::vector<IslandCord> cords{{&machine.cord, {}, 1}, {&other, {}, 2}};
  cords[0].surroundings.axles = {&axle, 1};
  for (int k = 0; k < 150; ++k) {
    solver.step(cords, {&machine.wall, 1}, dt, gravity, reports, {&tie, 1});
    ASSERT_GE(machine.pulley().def.before, 15) << k;
  }
  EXPECT_LT(length(other.positions()[0] - machine.cord.positions()[15]), 1e-9);
  EXPECT_EQ(machine.pulley().def.before, 15);
  EXPECT_LT(std::abs(machine.pulley().speed), 0.05);
}

/// Where the cord cannot run on, because its end has reached the wheel, it stops, and stays.
TEST(BlockedPulley, StopsAtTheEndOfTheCord) {
  Atwood atwood;
  atwood.right = 60.0;
  Machine machine(atwood);
  machine.step(300);
  EXPECT_LT(std::abs(machine.pulley().speed), 0.02);
  EXPECT_GT(machine.fall(), 3.0);
  EXPECT_LT(machine.fall(), 3.6);
  EXPECT_LT(length(machine.cord.velocities().back()), 0.2);
}

/// A machine whose cord has run until its first point reached the wheel.
Machine blocked_machine(double inertia, double friction) {
  Atwood atwood;
  atwood.right = 60.0;
  atwood.wheel.inertia = inertia;
  atwood.wheel.friction = friction;
  Machine machine(atwood);
  machine.step(300);
  machine.unconverged = machine.iterations = 0;
  return machine;
}

/// What blocks the cord takes the difference of its tensions, which is more than the friction could. So the wheel
/// stands still, and no step has to find that out.
TEST(BlockedPulley, DoesNotTurnItsWheel) {
  for (const double inertia : {0.002, 0.5}) {
    for (const double friction : {0.05, 0.3}) {
      Machine machine = blocked_machine(inertia, friction);
      ASSERT_NE(machine.pulley().blocked, 0.0);
      const double difference = machine.pulley().tension_after - machine.pulley().tension_before;
      EXPECT_GT(difference, 2.0 * (std::exp(friction * machine.pulley().arc) - 1.0) * machine.pulley().tension_before);
      const double angle = machine.pulley().angle;
      for (int k = 0; k < 60; ++k) {
        machine.step();
        EXPECT_EQ(machine.pulley().turning, 0.0) << inertia << ' ' << friction << ' ' << k;
      }
      EXPECT_EQ(machine.pulley().angle, angle);
      EXPECT_EQ(machine.pulley().slip_sign, 0.0);
      EXPECT_LE(machine.iterations, 4) << "the step is redone";
      EXPECT_EQ(machine.unconverged, 0);
    }
  }
}

/// A motor turns the wheel under a blocked cord if it gives more than the friction.
TEST(BlockedPulley, SlipsOnAWheelWithAStrongMotor) {
  Machine machine = blocked_machine(0.5, 0.05);
  const double limit = (std::exp(0.05 * machine.pulley().arc) - 1.0) * machine.pulley().tension_before * 0.2;  // N·m
  set_motor(machine.cord, 0, -3.0, 0.8 * limit);
  machine.step(60);
  EXPECT_EQ(machine.pulley().turning, 0.0);
  EXPECT_EQ(machine.pulley().slip_sign, 0.0);
  set_motor(machine.cord, 0, -3.0, 1.5 * limit);
  machine.step();
  EXPECT_NEAR(machine.pulley().turning / (-0.5 * limit / 0.5 / 60.0), 1.0, 0.02);
  set_motor(machine.cord, 0, -3.0, std::numeric_limits<double>::infinity());
  machine.step(2);
  EXPECT_EQ(machine.pulley().turning, -3.0);
  set_motor(machine.cord, 0, 0.0, 1e3);
  machine.step(2);
  EXPECT_EQ(machine.pulley().turning, 0.0) << "the brake";
  EXPECT_EQ(machine.unconverged, 0);
}

}  // namespace
}  // namespace ribbon
