#include "ribbon/pulley.h"

#include <gtest/gtest.h>

#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/pulleys.h"
#include "tests/support/refusal.h"

// Tackles.

namespace ribbon {
namespace {

using constants::dt;
using constants::g;
using constants::gravity;

/// The tackle and what it carries.
struct Tackle {
  explicit Tackle(double hand_mass, double load = 40.0, const Accuracy& accuracy = {})
      : Tackle(test_support::tackle_def(points, accuracy), hand_mass, load) {}
  Tackle(const CordDef& def, double hand_mass, double load)
      : cord(test_support::tackle_cord(def)), blocks(test_support::tackle_blocks(load)) {
    cord.attach_mass(0, hand_mass);
  }
  /// Returns the kinetic energy of all, J.
  double kinetic() const {
    const RigidBody& block = blocks[1];
    return energy_of(cord, gravity).kinetic + 0.5 / block.inverse_mass * dot(block.velocity, block.velocity);
  }
  /// Returns the energy of all, J.
  double energy() const {
    return energy_of(cord, gravity).potential + kinetic() + g / blocks[1].inverse_mass * blocks[1].position.y;
  }
  void step(int times) {
    const std::vector<Axle> axles = test_support::axles_of_tackle();
    Surroundings surroundings;
    surroundings.bodies = blocks;
    surroundings.axles = axles;
    for (int k = 0; k < times; ++k) {
      RigidBody& block = blocks[1];
      block.impulse = {};
      block.angular_impulse = 0.0;
      unconverged += cord.step(dt, gravity, surroundings).unconverged;
      block.velocity += dt * block.acceleration + block.inverse_mass * block.impulse;
      block.position += block.moved;
    }
  }
  static constexpr int points = 181;
  Cord cord;
  std::vector<RigidBody> blocks;
  int unconverged = 0;
};

/// A block and tackle 4:1: a quarter of the load holds it, and the hand goes four times as far.
TEST(Pulley, DividesALoadInATackle) {
  Tackle balance(10.0);
  balance.step(120);
  EXPECT_NEAR(balance.blocks[1].position.y, test_support::moving_block.y, 1e-4);
  EXPECT_NEAR(pulleys_of(balance.cord)[0].tension_before / (10.0 * g), 1.0, 1e-3);
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    Tackle lifting(11.0, 40.0, accuracy);
    lifting.step(120);
    const double a = g * (44.0 - 40.0) / (16.0 * 11.0 + 40.0);  // of the load
    EXPECT_NEAR(lifting.blocks[1].velocity.y / (2.0 * a), 1.0, 1e-3);
    EXPECT_NEAR(-lifting.cord.velocities().front().y / (8.0 * a), 1.0, 1e-3);
    for (const Pulley& pulley : pulleys_of(lifting.cord)) {
      EXPECT_NEAR(pulley.tension_after / (11.0 * (g - 4.0 * a)), 1.0, 2e-3);
    }
    EXPECT_NEAR(lifting.blocks[1].position.x, test_support::moving_block.x, 1e-3);
    EXPECT_EQ(lifting.unconverged, 0);
  }
}

/// The cord on the wheels of the block rises and falls with it, and turns around it. Its gravity may be another one.
TEST(Pulley, KeepsTheEnergyOfATackleWithAHeavyCord) {
  for (const double scale : {1.0, 2.5}) {
    for (const double load : {10.0, 60.0}) {
      CordDef def = test_support::tackle_def(Tackle::points, {});
      def.mass_per_length = 0.5;
      def.gravity_scale = scale;
      Tackle tackle(def, load < 20.0 ? 8.0 : 2.0, load);
      const double start = tackle.energy();
      tackle.step(20);
      EXPECT_EQ(tackle.blocks[1].velocity.y > 0.1, load < 20.0);
      EXPECT_NEAR((tackle.energy() - start) / tackle.kinetic(), 0.0, 0.005) << scale << ' ' << load;
    }
  }
}

}  // namespace
}  // namespace ribbon
