#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/direct_solver.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

// CordDef::gravity_scale.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

CordDef rope(double gravity_scale) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.gravity_scale = gravity_scale;
  return def;
}

TEST(CordGravityScale, AFreeCordFallsByScaleTimesGravity) {
  for (const double scale : {-1.0, 0.0, 0.5, 1.0, 3.0}) {
    Cord cord(rope(scale));
    for (int k = 0; k < 60; ++k) cord.step(dt, gravity);
    for (const Vec2 x : cord.positions()) EXPECT_NEAR(x.y, 0.5 * scale * gravity.y, 1e-9) << scale;
  }
}

TEST(CordGravityScale, APinnedCordCarriesScaleTimesItsWeight) {
  CordDef def = rope(0.25);
  def.pins = {0};
  def.drag = 5.0;
  def.stretch_stiffness = 1e6;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  Cord cord(def);
  for (int k = 0; k < 1200; ++k) cord.step(dt, gravity);
  const double weight = def.mass_per_length * def.length * 9.81;
  EXPECT_NEAR(cord.tensions()[0], 0.25 * weight * 0.95, 1e-6 * weight)
      << "all points but half of the first link's mass";
}

TEST(CordGravityScale, ABalloonOnARopeRises) {
  CordDef def = rope(-2.0);
  def.pins = {0};
  def.drag = 2.0;
  Cord cord(def);
  for (int k = 0; k < 1200; ++k) cord.step(dt, gravity);
  EXPECT_NEAR(cord.positions()[10].y, 1.0, 1e-3);
}

TEST(CordGravityScale, ConservesEnergy) {
  CordDef def = rope(0.3);
  def.pins = {0};
  Cord cord(def);
  const double before = energy_of(cord, gravity).total();
  const double scale = def.mass_per_length * 9.81;
  double most = before;
  for (int k = 0; k < 600; ++k) {
    cord.step(dt, gravity);
    most = std::max(most, energy_of(cord, gravity).total());
  }
  EXPECT_LT(most - before, 1e-3 * scale);
}

TEST(CordGravityScale, IsSeparateForEachCordOfAnIsland) {
  CordDef light = rope(0.0);
  CordDef heavy = rope(1.0);
  light.cord_contact = heavy.cord_contact = true;
  light.radius = heavy.radius = 0.02;
  heavy.positions = test_support::equally_spaced(heavy.points, {0.0, 0.05}, {0.1, 0.0});
  Cord below(light);
  Cord above(heavy);
  DirectSolver solver;
  for (int k = 0; k < 60; ++k) {
    const std::array cords = {IslandCord{&below, {}, 1}, IslandCord{&above, {}, 2}};
    std::array<CordReport, 2> reports;
    solver.step(cords, {}, dt, gravity, reports);
  }
  EXPECT_LT(below.positions()[5].y, -0.5) << "the heavy cord pushes it down";
  EXPECT_GT(above.positions()[5].y, below.positions()[5].y + 0.035);
}

TEST(CordGravityScale, AHeavyBodySwingsOnAWeightlessCord) {
  CordDef def = rope(0.0);
  def.pins = {0};
  Cord cord(def);
  RigidBody body;
  body.position = {1.0, 0.0};
  body.inverse_mass = 0.1;
  body.acceleration = gravity;
  const std::array grips = {Grip{10, 0, {}}};
  double lowest = 0.0;
  IslandReport total;
  for (int k = 0; k < 120; ++k) {
    std::array bodies = {body};
    total += cord.step(dt, gravity, {bodies, {}, grips});
    body.velocity += dt * body.acceleration + body.inverse_mass * bodies[0].impulse;
    body.position += bodies[0].moved;
    lowest = std::min(lowest, body.position.y);
  }
  EXPECT_NEAR(lowest, -1.0, 0.001);
  EXPECT_EQ(total.unconverged + total.fallbacks, 0);
  EXPECT_LE(total.energy_gains, 4) << "2 with a scale of 1: the guard measures by the weight of the body too";
}

TEST(CordGravityScale, OutOfRangeIsRefused) {
  for (const double scale : {-1001.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Cord{rope(scale)}, DefinitionError) << scale;
  }
}

}  // namespace
}  // namespace ribbon
