#include "tests/support/coupled_world.h"

#include <gtest/gtest.h>

#include "tests/support/contact_figures.h"

// The thesis's cord in place of a rope, as the measurements use it.

namespace test_support {
namespace {

using ribbon::CordDef;
using ribbon::Vec2;

constexpr double mass = 0.5;  // kg
constexpr double link = 0.1;  // m

CordMethod thesis() {
  CordMethod method;
  method.thesis = true;
  method.substeps = 8;
  return method;
}

/// A level rope at y = 1 m.
CordDef rope() {
  CordDef def;
  def.points = 11;
  def.length = 10 * link;
  def.mass_per_length = mass / def.length;
  for (int p = 0; p < def.points; ++p) def.positions.push_back({link * p, 1.0});
  return def;
}

TEST(CoupledWorld, AThesisCordHasTheMassAndTheShapeOfItsRope) {
  CoupledWorld world(thesis());
  world.add(rope());
  EXPECT_EQ(world.points(0), rope().positions);
  EXPECT_EQ(world.outline(0).size(), 22U);
  EXPECT_TRUE(world.is_closed(0));
  // Half of the mass is one link lower.
  EXPECT_NEAR(world.energy(), mass * 9.81 * (1.0 - 0.5 * link), 1e-6);
  EXPECT_NEAR(world.energy_scale(), mass * 9.81 * rope().length, 1e-6);
}

TEST(CoupledWorld, APullIsTheRateOfChangeOfMomentumOfAThesisCord) {
  CoupledWorld world(thesis(), {});
  world.add(rope());
  world.pull(0, 10, {2.0, 0.0});
  constexpr int ticks = 6;
  for (int k = 0; k < ticks; ++k) world.tick();
  Vec2 momentum;
  for (const Vec2 v : world.coupling.cord(0).thesis().velocities()) momentum += mass / 22.0 * v;
  EXPECT_NEAR(momentum.x, 2.0 * ticks * CoupledWorld::dt, 1e-9);
  EXPECT_NEAR(momentum.y, 0.0, 1e-9);
}

TEST(CoupledWorld, AThesisCordHangsByItsPinOnCirclesThatItTouches) {
  CoupledWorld world(thesis());
  CordDef def = rope();
  def.pins = {0};
  world.add(def);
  world.add_circle(b2_staticBody, {0.5, 0.6}, 0.2, 0.0, 0.0);
  double deepest = 0.0;
  for (int k = 0; k < 120; ++k) {
    world.tick();
    deepest = std::max(deepest, penetration(world));
  }
  EXPECT_EQ(world.points(0).front(), def.positions.front());
  EXPECT_GT(world.points(0)[5].y, 0.8);  // above the circle, which it would pass without contact
  EXPECT_LT(deepest, 0.01);
  EXPECT_LT(stretch(world, 0), 0.1);
  world.settle(60);
  EXPECT_NEAR(length(world.coupling.cord(0).thesis().velocities()[10]), 0.0, 0.1);
}

}  // namespace
}  // namespace test_support
