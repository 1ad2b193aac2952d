#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/slot.h"

// The guards that keep a step finite and free of spurious energy.

namespace ribbon {
namespace {

constexpr int ample_work = 1'000'000;  // Accuracy::max_work that is enough for every case

using constants::gravity;
using constants::infinity;
using test_support::all_finite;
using test_support::Dice;
using test_support::slot;

struct Snap {
  int points;
  int rows;
  double stiffness;  // EA, N
  double bending;    // EI: of a rope in N·m², of a ribbon relative to that of a solid
};

/// A cord that is held at one end, thrown, and folded like a hairpin: its other end, with a load, falls until the cord
/// is taut.
Cord slack(const Snap& snap, unsigned seed, const Accuracy& accuracy) {
  Dice dice(seed + 1);
  CordDef def;
  def.points = snap.points;
  def.rows = snap.rows;
  def.length = 2.0;
  def.mass_per_length = 0.5;
  def.stretch_stiffness = snap.stiffness;
  def.bending_stiffness = snap.bending;
  def.accuracy = accuracy;
  const double link = def.length / (def.points - 1);
  if (def.rows > 1) {
    def.width = link * (def.rows - 1);
    def.bending_stiffness *= def.stretch_stiffness * def.width * def.width / 12.0;
  }
  const double there = 2.0 * std::numbers::pi * dice();
  const double corner = 0.3 + 0.6 * dice();
  const double turn = std::numbers::pi * (0.6 + 0.8 * dice());
  Vec2 middle;
  for (int i = 0; i < def.points; ++i) {
    const double angle =
        there + turn * std::clamp((static_cast<double>(i) / (def.points - 1) - corner) / 0.1 + 0.5, 0.0, 1.0);
    const Vec2 along{std::cos(angle), std::sin(angle)};
    for (int j = 0; j < def.rows; ++j) {
      const double across = def.rows > 1 ? def.width * (static_cast<double>(j) / (def.rows - 1) - 0.5) : 0.0;
      def.positions.push_back(middle + across * perp(along));
    }
    middle += link * along;
  }
  for (int j = 0; j < (seed % 3 == 0 ? 1 : def.rows); ++j) def.pins.push_back(j);  // for some seeds by one corner
  Cord cord(def);
  const Vec2 thrown{4.0 * dice() - 2.0, 4.0 * dice() - 2.0};
  constexpr double loads[] = {0.0, 1.0, 10.0, 100.0, 1000.0};  // cord: 1 kg
  for (int j = 0; j < def.rows; ++j) {
    for (int i = 1; i < def.points; ++i) {
      cord.set_velocity(cord.index(i, j), (static_cast<double>(i) / (def.points - 1)) * thrown);
    }
    cord.attach_mass(cord.index(def.points - 1, j), loads[seed % 5] / def.rows);
  }
  return cord;
}

class LongSnap : public testing::TestWithParam<Snap> {};

/// With the default work limit, and with ample work, which solves every case.
TEST_P(LongSnap, NeverGainsEnergy) {
  std::vector<Accuracy> all = {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()};
  for (Accuracy accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    accuracy.max_work = ample_work;
    all.push_back(accuracy);
  }
  for (const Accuracy& accuracy : all) {
    IslandReport report;
    double worst = 0.0;
    for (unsigned seed = 0; seed < 45; ++seed) {
      Cord cord = slack(GetParam(), seed, accuracy);
      double mass = 0.0;
      for (int p = 0; p < cord.size(); ++p) mass += cord.mass(p);
      const double scale = mass * 9.81 * cord.def().length;
      const double start = energy_of(cord, gravity).total();
      for (int k = 0; k < 240; ++k) {
        report += cord.step(1.0 / 60.0, gravity);
        const double gain = (energy_of(cord, gravity).total() - start) / scale;
        ASSERT_LE(gain, 1e-3) << "seed " << seed << ", tick " << k;
        worst = std::max(worst, gain);
      }
    }
    if (accuracy.max_work == ample_work) {
      EXPECT_EQ(report.unconverged, 0);
    }
    const std::string setting = std::to_string(accuracy.max_work) + "_" + std::to_string(accuracy.substeps) + "_" +
                                std::to_string(static_cast<int>(accuracy.integrator));
    RecordProperty("worst_gain_" + setting, std::to_string(worst));
    RecordProperty("redone_" + setting, report.energy_gains + report.fallbacks);
  }
}

INSTANTIATE_TEST_SUITE_P(Ropes, LongSnap,
                         testing::Values(Snap{51, 1, infinity, 0.0}, Snap{51, 1, 1e7, 0.0}, Snap{51, 1, 1e4, 0.0},
                                         Snap{51, 1, infinity, 1e-3}));
INSTANTIATE_TEST_SUITE_P(Ribbons, LongSnap,
                         testing::Values(Snap{25, 2, 1e6, 1.0}, Snap{25, 2, 1e6, 1e-3}, Snap{25, 2, 1e4, 0.0},
                                         Snap{10, 5, 1e6, 1.0}, Snap{10, 5, 1e6, 1e-2}));

/// The pieces of a cord get random velocities up to `speed`: links turn more than once in a step.
struct Dashed {
  int points;
  int piece;     // links
  double speed;  // m/s
  unsigned seed;
};

/// A cord in steps of a second.
Cord dashed(const Dashed& how, int max_work) {
  Dice dice(how.seed);
  CordDef def;
  def.points = how.points;
  def.pins = {0};
  def.accuracy.max_iterations = 12;
  def.accuracy.tolerance = 1e-4;
  def.accuracy.max_work = max_work;
  Cord cord(def);
  Vec2 thrown;
  for (int p = 1; p < how.points; ++p) {
    if ((p - 1) % how.piece == 0) thrown = {dice(-how.speed, how.speed), dice(-how.speed, how.speed)};
    cord.set_velocity(p, thrown);
  }
  return cord;
}

class LongDashed : public testing::TestWithParam<Dashed> {};

/// Shorter pieces need more than ten halvings at the start, the long cord needs more than 4,000 Newton steps.
TEST_P(LongDashed, ConvergesInAStepOfASecond) {
  Cord cord = dashed(GetParam(), ample_work);
  const double start = energy_of(cord, gravity).total();
  EXPECT_EQ(cord.step(1.0, gravity).unconverged, 0);
  EXPECT_LE(energy_of(cord, gravity).total(), start);
  for (int p = 1; p < GetParam().points; ++p) {
    EXPECT_NEAR(length(cord.positions()[slot(p)] - cord.positions()[slot(p - 1)]), cord.rest_length(p - 1), 1e-6);
  }
}

/// The rest of a step then costs one more attempt, and is finite and without spurious energy.
TEST(LongMaxWork, BoundsTheCostOfAStep) {
  const Dashed how{1000, 20, 100.0, 1};
  Cord whole = dashed(how, ample_work);
  const int needed = whole.step(1.0, gravity).iterations;
  ASSERT_GT(needed, 1000);
  for (const int max_work : {1, 100, 500}) {
    Cord cord = dashed(how, max_work);
    const double start = energy_of(cord, gravity).total();
    const IslandReport report = cord.step(1.0, gravity);
    EXPECT_LT(report.iterations, max_work + 250) << max_work;
    EXPECT_GE(report.unconverged, 1) << max_work;
    EXPECT_LE(energy_of(cord, gravity).total(), start) << max_work;
    for (const Vec2 x : cord.positions()) ASSERT_LT(length(x), 1e4);
  }
}

INSTANTIATE_TEST_SUITE_P(All, LongDashed,
                         testing::Values(Dashed{1000, 20, 100.0, 1}, Dashed{1000, 20, 100.0, 3},
                                         Dashed{1000, 20, 100.0, 8}, Dashed{5000, 300, 60.0, 5}));

// --- every load on every stiffness -----------------------------------------------------------------------------------

class LongMassRatios : public testing::TestWithParam<int> {};

TEST_P(LongMassRatios, ConvergeEverywhere) {
  const int links = GetParam();
  IslandReport all;
  for (const double load : {0.0, 1.0, 1e3, 1e6}) {
    for (const double ratio : {10.0, 1e3, 1e5, 1e7, 1e9, infinity}) {
      CordDef def;
      def.points = links + 1;
      def.stretch_stiffness = ratio * 9.81 * (1.0 + load);
      def.pins = {0};
      Cord cord(def);
      cord.attach_mass(links, load);
      const double start = energy_of(cord, gravity).total();
      IslandReport report;
      for (int k = 0; k < 300; ++k) report += cord.step(1.0 / 60.0, gravity);
      EXPECT_EQ(report.unconverged, 0) << load << " : 1, EA/(Mg) = " << ratio;
      EXPECT_LE(report.iterations, 4.0 * report.stages) << load << " : 1, EA/(Mg) = " << ratio;
      EXPECT_LE(energy_of(cord, gravity).total() - start, 1e-3 * (1.0 + load) * 9.81 * 10.0);
      all += report;
    }
  }
  RecordProperty("iterations_a_stage", std::to_string(static_cast<double>(all.iterations) / all.stages));
  RecordProperty("searches", all.searches);
  RecordProperty("fallbacks", all.fallbacks);
  RecordProperty("energy_gains", all.energy_gains);
}

INSTANTIATE_TEST_SUITE_P(Links, LongMassRatios, testing::Values(50, 500));

/// The grip of a holder moves on its body while the rope goes taut. That does not throw the body further.
TEST(CordGuard, GuardsRopesThatHoldersMove) {
  constexpr double mass = 60.0;
  for (const int substeps : {1, 2, 8}) {
    CordDef def;
    def.points = 31;
    def.length = 6.0;
    def.mass_per_length = 0.5;
    def.tension_only = true;
    def.bending_stiffness = 0.5;
    def.damping = 0.05;
    def.pins = {0};
    def.accuracy.substeps = substeps;
    def.accuracy.tolerance = 1e-4;
    def.positions.push_back({0.0, 0.0});
    for (int i = 1; i < def.points; ++i) {  // in zigzag, so that it is slack
      def.positions.push_back(def.positions.back() + 0.2 * Vec2{i % 2 == 0 ? -0.343 : 0.343, -0.939});
    }
    Cord cord(def);
    std::vector<RigidBody> bodies(1);
    RigidBody& body = bodies[0];
    body.position = cord.positions()[30];
    body.velocity = {6.9, -0.3};
    body.inverse_mass = 1.0 / mass;
    body.acceleration = gravity;
    std::vector<Grip> grips(1);
    grips[0].point = 30;
    grips[0].travel = {5e-4, 0.0};
    const auto energy = [&] {
      return 0.5 * mass * dot(body.velocity, body.velocity) - mass * dot(gravity, body.position) +
             energy_of(cord, gravity).total();
    };
    const double before = energy();
    for (int k = 0; k < 40; ++k) {
      body.impulse = {};
      cord.step(1.0 / 60.0, gravity, {bodies, {}, grips});
      body.velocity += body.inverse_mass * body.impulse + (1.0 / 60.0) * gravity;
      body.position += body.moved;
      grips[0].offset += grips[0].travel;
      EXPECT_LE(energy() - before, 2e-3 * mass * 9.81 * def.length) << substeps << ", tick " << k;
    }
  }
}

/// A stiff cord of many short links gains a small part of M·g·L if its first links turn by a whole turn in a step. The
/// guard removes that energy and no more.
TEST(CordGuard, RemovesSpuriousEnergy) {
  for (const int points : {1001, 5001}) {
    CordDef def;
    def.points = points;
    def.stretch_stiffness = 1e7;
    def.length = 10.0;
    def.mass_per_length = 0.1;
    def.pins = {0};
    Cord cord(def);
    const double scale = 9.81 * def.length;
    const double start = energy_of(cord, gravity).total();
    double gain = -infinity;
    for (int k = 0; k < 20; ++k) {
      EXPECT_EQ(cord.step(1.0 / 60.0, gravity).unconverged, 0);
      gain = std::max(gain, energy_of(cord, gravity).total() - start);
    }
    EXPECT_LT(gain, 1e-6 * scale) << points;
    EXPECT_GT(gain, 1e-7 * scale) << points;
  }
}

TEST(CordGuard, CountsItsCorrections) {
  IslandReport report;
  for (unsigned seed = 0; seed < 5; ++seed) {
    Cord cord = slack({51, 1, 1e7, 0.0}, seed, Accuracy::balanced());
    for (int k = 0; k < 240; ++k) report += cord.step(1.0 / 60.0, gravity);
  }
  EXPECT_GT(report.searches, 0);
  EXPECT_GT(report.energy_gains, 0);
  EXPECT_GT(report.iterations, report.stages);
  EXPECT_EQ(report.unlocked, 0);
}

/// A stiff ribbon that is dragged about: the tolerance times its tensions exceeds its energy.
TEST(CordGuard, ImplicitEulerGainsNoEnergyEither) {
  CordDef def;
  def.points = 12;
  def.rows = 4;
  def.length = 1.0;
  def.width = 0.2;
  def.elements = Elements::bars;
  def.mass_per_length = 1.0;
  def.stretch_stiffness = 1e10;
  def.pins = {0, 1, 2, 3};
  def.accuracy = Accuracy::fast();
  Cord cord(def);
  for (int p = 4; p < 48; ++p) {
    cord.set_velocity(p, {5.0 * (p * 7919 % 101 / 50.0 - 1.0), 5.0 * (p * 104729 % 103 / 51.0 - 1.0)});
  }
  const double start = energy_of(cord, gravity).total();
  IslandReport report;
  for (int k = 0; k < 120; ++k) {
    report += cord.step(1.0 / 60.0, gravity);
    ASSERT_LE(energy_of(cord, gravity).total(), start + 0.1) << "tick " << k;
  }
  EXPECT_GT(report.energy_gains, 0);
}

/// The work on a substep that cannot be solved is limited.
TEST(CordGuard, StopsAtItsBudget) {
  Cord cord = slack({51, 1, 1e7, 0.0}, 4, {Integrator::tr_bdf2, 1, 1, 1e-12});
  for (int k = 0; k < 20; ++k) {
    EXPECT_LT(cord.step(0.5, gravity).iterations, 4 * 4100);
  }
}

/// An unsolved step stays finite and is reported: one Newton step per stage, and a tolerance that cannot be reached.
TEST(CordGuard, ReportsUnconvergedSubstepsAndStaysFinite) {
  Cord cord = slack({501, 1, 1e7, 0.0}, 4, {Integrator::tr_bdf2, 1, 1, 1e-12});
  IslandReport report;
  for (int k = 0; k < 20; ++k) report += cord.step(1.0, gravity);
  EXPECT_GT(report.unconverged, 0);
  EXPECT_GT(report.halvings, 0);
  EXPECT_GT(report.fallbacks, 0);
  EXPECT_TRUE(all_finite(cord.positions()));
  EXPECT_TRUE(all_finite(cord.velocities()));
}

/// It hangs between two pins that are as far apart as it is long, and the tolerance is many times its sag. What a solve
/// leaves of its stretch would be taken back by lifting the rope, without a motion that could be slowed down.
TEST(CordGuard, LeavesANearlyTautRopeItsLength) {
  CordDef def;
  def.points = 27;
  def.length = 2.6;
  def.bending_stiffness = 0.01;
  def.pins = {0, 26};
  def.accuracy = Accuracy::fast();
  for (int i = 0; i < def.points; ++i) def.positions.push_back({0.1 * i, 0.0});
  Cord cord(def);
  const auto largest_strain = [&cord] {
    double largest = 0.0;
    const auto& x = cord.positions();
    for (std::size_t i = 1; i < x.size(); ++i) {
      largest = std::max(largest, std::abs(length(x[i] - x[i - 1]) / 0.1 - 1.0));
    }
    return largest;
  };
  for (int k = 0; k < 30; ++k) {
    EXPECT_EQ(cord.step(1.0 / 60.0, gravity).unconverged, 0);
    EXPECT_LE(largest_strain(), 1e-3) << "tick " << k;
  }
}

}  // namespace
}  // namespace ribbon
