#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"

// Damping, and links that only pull.

namespace ribbon {
namespace {

using constants::gravity;
using constants::infinity;
using test_support::hanging;

/// A set velocity is a jump, and so is the damping tension. The elastic energy does not jump.
TEST(CordDamping, ElasticEnergyDoesNotDependOnASetVelocity) {
  CordDef ribbon;
  ribbon.points = 21;
  ribbon.rows = 3;
  ribbon.length = 2.0;
  ribbon.width = 0.1;
  solid(1e6, 0.2, 0.01, 0.1).apply_to(ribbon);
  ribbon.bending_stiffness *= 0.5;  // so that it has a spine
  ribbon.pins = {0, 1, 2};
  CordDef rope = hanging(21, 2.0);
  rope.stretch_stiffness = 1e5;
  CordDef bending = rope;
  bending.bending_stiffness = 1e-3;
  for (CordDef def : {ribbon, rope, bending}) {
    def.damping = 0.01;
    Cord cord(def);
    for (int k = 0; k < 30; ++k) cord.step(1.0 / 60.0, gravity);
    const double before = energy_of(cord, gravity).elastic;
    const Cord::State state = cord.save();
    cord.set_velocity(cord.size() - 1, {50.0, 30.0});
    EXPECT_NEAR(energy_of(cord, gravity).elastic, before, 1e-9 * (1.0 + before)) << def.rows;
    cord.set_velocity(cord.size() - 1, state.velocities.back());
    Cord other(def);
    other.restore(state);
    cord.step(1.0 / 60.0, gravity);
    other.step(1.0 / 60.0, gravity);
    EXPECT_NEAR(length(cord.positions().back() - other.positions().back()), 0.0, 5e-4) << def.rows;
  }
}

/// Implicit Euler moves points along chords, which lengthen the links of a spinning rope. If that were damped, the rope
/// would get shorter from step to step. But a spinning rope is longer by μω²L²/12/EA, here 0.8 % at the start.
TEST(CordDamping, ImplicitEulerDoesNotShortenARotatingRope) {
  for (const double bending : {0.0, 1e-3}) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.mass_per_length = 1.0;
    def.stretch_stiffness = 1e3;
    def.bending_stiffness = bending;
    def.damping = 0.05;
    def.accuracy = Accuracy::fast();
    Cord cord(def);
    for (int i = 0; i < 11; ++i) cord.set_velocity(i, {0.0, i - 5.0});
    for (int k = 0; k < 60; ++k) {
      cord.step(1.0 / 60.0, {});
      double elastic = 0.0;
      for (std::size_t i = 0; i < 10; ++i) {
        const double stretch = length(cord.positions()[i + 1] - cord.positions()[i]) - 0.1;
        elastic += 0.5 * 1e4 * stretch * stretch;
        ASSERT_GT(stretch, 0.0) << "link " << i << ", tick " << k;
      }
      ASSERT_NEAR(energy_of(cord, {}).elastic, elastic, 0.01 * elastic) << "tick " << k;
    }
    EXPECT_NEAR(length(cord.positions()[10] - cord.positions()[0]), 1.002, 1e-3);
  }
}

/// The same for the cells of a ribbon, whose bars are the sums of their edges.
TEST(CordDamping, ImplicitEulerDoesNotShortenARotatingRibbon) {
  for (const int rows : {2, 3}) {
    CordDef def;
    def.points = 11;
    def.rows = rows;
    def.length = 1.0;
    def.width = 0.1;
    def.mass_per_length = 1.0;
    def.stretch_stiffness = 1e3;
    def.bending_stiffness = 1e-2;
    def.damping = 0.05;
    def.accuracy = Accuracy::fast();
    Cord cord(def);
    const Vec2 middle = 0.5 * (cord.positions().front() + cord.positions().back());
    for (int p = 0; p < 11 * rows; ++p) {
      cord.set_velocity(p, 10.0 * perp(cord.positions()[static_cast<std::size_t>(p)] - middle));
    }
    double before = energy_of(cord, {}).total();
    for (int k = 0; k < 60; ++k) {
      cord.step(1.0 / 60.0, {});
      const double now = energy_of(cord, {}).total();
      ASSERT_LE(now, (1.0 + 1e-9) * before) << rows << " rows, tick " << k;
      before = now;
    }
    // The spin makes it longer, and it still turns.
    const double length_now = length(cord.positions().back() - cord.positions()[static_cast<std::size_t>(rows - 1)]);
    EXPECT_GT(length_now, 1.0) << rows << " rows";
    EXPECT_LT(length_now, 1.01) << rows << " rows";
  }
}

/// A short cycle of steps once gained energy: strong damping, and links that turn by half a radian per step.
TEST(CordDamping, ALivelyRopeConverges) {
  CordDef def;
  def.points = 13;
  def.length = 0.6;
  def.mass_per_length = 0.5;
  def.stretch_stiffness = 1e3;
  def.damping = 0.05;
  IslandReport report;
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    const auto dice = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    def.positions.clear();
    for (int i = 0; i < 13; ++i) {
      const double x = 0.6 * dice();
      def.positions.push_back({x, 0.6 * dice()});
    }
    Cord cord(def);
    for (int k = 0; k < 60; ++k) report += cord.step(1.0 / 60.0, {});
  }
  EXPECT_EQ(report.unconverged, 0);
}

TEST(CordTensionOnly, NeverPushes) {
  for (const double stiffness : {infinity, 1e5}) {
    for (const double bending : {0.0, 1e-4}) {
      CordDef def = hanging(21, 2.0);
      def.stretch_stiffness = stiffness;
      def.bending_stiffness = bending;
      def.tension_only = true;
      def.accuracy.tolerance = 1e-9;  // a link may push by that much times the inertia of its points
      Cord cord(def);
      for (int p = 1; p <= 20; ++p) cord.set_velocity(p, {0.3, 6.0});  // thrown upwards, past the pin
      IslandReport report;
      double shortest = 2.0;
      for (int k = 0; k < 180; ++k) {
        report += cord.step(1.0 / 60.0, gravity);
        double sum = 0.0;
        for (std::size_t p = 1; p <= 20; ++p) sum += length(cord.positions()[p] - cord.positions()[p - 1]);
        shortest = std::min(shortest, sum);
        EXPECT_LE(sum, 2.0 * (1.0 + 2e-3));
        for (const double tension : cord.tensions()) EXPECT_GE(tension, -1e-6);
      }
      EXPECT_EQ(report.unconverged, 0);
      EXPECT_LT(shortest, 1.95) << "its links give way to a push";
    }
  }
}

/// Damped links that are shorter than at rest have no elastic energy, and one that shortens too fast to pull keeps its.
TEST(CordTensionOnly, StoresEnergyOnlyInStretchedLinks) {
  for (const double damping : {1e-3, 1e-2, 1e-1}) {
    for (const double bending : {0.0, 1e-8}) {
      CordDef def = hanging(21, 2.0);
      def.stretch_stiffness = 1e5;
      def.bending_stiffness = bending;
      def.damping = damping;
      def.tension_only = true;
      def.accuracy.tolerance = 1e-9;
      Cord cord(def);
      for (int p = 1; p <= 20; ++p) cord.set_velocity(p, {0.3, 6.0});  // thrown upwards, past the pin
      const double scale = energy_of(cord, gravity).kinetic;
      for (int k = 0; k < 180; ++k) {
        cord.step(1.0 / 60.0, gravity);
        double stored = 0.0;
        for (std::size_t p = 1; p <= 20; ++p) {
          const double elongation = length(cord.positions()[p] - cord.positions()[p - 1]) - 0.1;
          stored += 0.5 * 1e5 / 0.1 * std::pow(std::max(0.0, elongation), 2);
        }
        ASSERT_NEAR(energy_of(cord, gravity).elastic, stored, 1e-4 * scale) << "damping " << damping << ", tick " << k;
      }
    }
  }
}

TEST(CordTensionOnly, HangsAsACordWithCompression) {
  CordDef def = hanging(21, 2.0);
  def.tension_only = true;
  def.pins = {0, 20};
  for (int p = 0; p <= 20; ++p)
    def.positions[static_cast<std::size_t>(p)] = {1.5 * p / 20.0, -0.6 * (1.0 - std::abs(p / 10.0 - 1.0))};
  CordDef both = def;
  both.tension_only = false;
  Cord pulling(def);
  Cord bars(both);
  for (int k = 0; k < 3000; ++k) {
    pulling.step(1.0, gravity);
    bars.step(1.0, gravity);
  }
  for (std::size_t p = 0; p <= 20; ++p) EXPECT_NEAR(length(pulling.positions()[p] - bars.positions()[p]), 0.0, 1e-6);
}

/// In short time steps a Newton step that treats all links as slack moves them by less than the tolerance. That must
/// not end the iteration.
TEST(CordTensionOnly, HangsStillInShortSteps) {
  for (const double stiffness : {infinity, 1e9}) {
    for (const double bending : {0.0, 0.5}) {
      for (const int substeps : {1, 64, 256, 1024}) {
        CordDef def = hanging(41, 8.0);
        def.stretch_stiffness = stiffness;
        def.bending_stiffness = bending;
        def.tension_only = true;
        def.accuracy = {Integrator::tr_bdf2, substeps, 8, 1e-7};
        Cord cord(def);
        const std::vector<Vec2> start(cord.positions().begin(), cord.positions().end());
        IslandReport report;
        for (int k = 0; k < 20; ++k) report += cord.step(1.0 / 60.0, gravity);
        for (std::size_t p = 0; p < start.size(); ++p) {
          EXPECT_LE(length(cord.positions()[p] - start[p]), stiffness < infinity ? 1e-6 : 1e-10) << substeps;
        }
        for (const double tension : cord.tensions()) EXPECT_GT(tension, 0.0);
        EXPECT_EQ(report.searches + report.unconverged, 0);
        EXPECT_LE(report.iterations, 1.2 * report.stages);
      }
    }
  }
}

/// A body that takes hold of a rope while rising continues to rise, also in short steps. Links that push would stop it.
TEST(CordTensionOnly, DoesNotStopABodyThatTakesHoldWhileRising) {
  for (const int substeps : {1, 8, 64}) {
    CordDef def = hanging(41, 8.0);
    def.tension_only = true;
    def.accuracy.substeps = substeps;
    Cord cord(def);
    std::vector<RigidBody> bodies(1);
    bodies[0].position = cord.positions()[30];
    bodies[0].velocity = {6.0, 2.2};
    bodies[0].inverse_mass = 1.0 / 60.0;
    bodies[0].acceleration = gravity;
    std::vector<Grip> grips(1);
    grips[0].point = 30;
    EXPECT_EQ(cord.step(1.0 / 60.0, gravity, {bodies, {}, grips}).unconverged, 0);
    EXPECT_NEAR(bodies[0].velocity.y + bodies[0].impulse.y / 60.0, 2.2, 0.05) << substeps;  // its owner adds gravity
    EXPECT_NEAR(bodies[0].velocity.x + bodies[0].impulse.x / 60.0, 6.0, 0.1) << substeps;
  }
}

}  // namespace
}  // namespace ribbon
