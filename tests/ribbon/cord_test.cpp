#include "ribbon/cord.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/heavy_swing.h"
#include "tests/support/points.h"

namespace ribbon {
namespace {

using constants::gravity;
using constants::infinity;
using test_support::all_finite;
using test_support::path_length;

/// An L-stable method damps steps of a second so strongly that a few dozen bring any cord to rest.
void come_to_rest(Cord& cord) {
  for (int k = 0; k < 3000; ++k) cord.step(1.0, gravity);
}

struct HeavySwingBar {
  double stiffness;  // N
  int substeps;
  double rms;   // m, at most
  double peak;  // stretch above the converged cord's own peak, at most
};

class HeavySwing : public testing::TestWithParam<HeavySwingBar> {};

TEST_P(HeavySwing, StaysNearItsConvergedMotion) {
  const HeavySwingBar& bar = GetParam();
  const auto converged = test_support::run_heavy_swing(bar.stiffness, {Integrator::tr_bdf2, 128, 8, 1e-9});
  const auto run = test_support::run_heavy_swing(bar.stiffness, {Integrator::tr_bdf2, bar.substeps, 8, 1e-3});
  EXPECT_LE(test_support::rms_distance(run.load, converged.load), bar.rms);
  EXPECT_LE(run.peak_stretch - converged.peak_stretch, bar.peak);
  EXPECT_EQ(run.report.unconverged, 0);
  RecordProperty("rms_mm", std::to_string(1e3 * test_support::rms_distance(run.load, converged.load)));
  RecordProperty("peak_above", std::to_string(run.peak_stretch - converged.peak_stretch));
  RecordProperty("iterations_a_stage", std::to_string(run.report.iterations / (600.0 * bar.substeps)));
  RecordProperty("fallbacks", run.report.fallbacks);
}

INSTANTIATE_TEST_SUITE_P(Bars, HeavySwing,
                         testing::Values(HeavySwingBar{infinity, 1, 0.010, 1e-5},
                                         HeavySwingBar{infinity, 4, 0.002, 1e-5}, HeavySwingBar{1e7, 1, 0.010, 1e-4},
                                         HeavySwingBar{1e8, 1, 0.005, 1e-4}));

// --- exact solutions
// ---------------------------------------------------------------------------------------------------

TEST(Cord, StretchesUnderItsLumpedWeight) {
  // Link e of n carries all points below it: stretch = (weight below)/(EA/l).
  CordDef def;
  def.points = 21;
  def.length = 4.0;
  def.mass_per_length = 0.75;
  def.stretch_stiffness = 5000.0;
  def.accuracy.tolerance = 1e-10;
  def.pins = {0};
  Cord cord(def);
  cord.attach_mass(20, 7.0);
  come_to_rest(cord);
  double expected = 0.0;
  double below = 0.0;
  for (int p = 20; p >= 1; --p) {
    below += cord.mass(p);
    expected += below * 9.81 * 0.2 / def.stretch_stiffness;
    EXPECT_NEAR(cord.tensions()[static_cast<std::size_t>(p - 1)], below * 9.81, 1e-6);
  }
  EXPECT_NEAR(cord.positions()[20].y, -(4.0 + expected), 1e-8);
  EXPECT_NEAR(cord.positions()[20].x, 0.0, 1e-6);
}

/// A lumped chain between two pins obeys tan θ_i = (V_0 + i·m·g)/H exactly.
TEST(Cord, HangsBetweenTwoPinsAsALumpedCatenary) {
  CordDef def;
  def.points = 31;
  def.length = 6.0;
  def.mass_per_length = 1.0 / 3.0;
  def.accuracy.tolerance = 1e-10;
  def.pins = {0, 30};
  Cord cord(def);
  cord.constrain(30, {4.0, 0.0});  // L/D = 1.5
  come_to_rest(cord);
  EXPECT_NEAR(path_length(cord.positions()), 6.0, 1e-8);  // the least give of an inextensible link between two pins
  std::vector<double> tangents;
  for (std::size_t e = 0; e < 30; ++e) {
    const Vec2 d = cord.positions()[e + 1] - cord.positions()[e];
    tangents.push_back(d.y / d.x);
  }
  const double step = tangents[1] - tangents[0];
  EXPECT_GT(step, 0.0);
  for (std::size_t e = 1; e < 30; ++e) EXPECT_NEAR(tangents[e] - tangents[e - 1], step, 1e-6);
  const double sag = -cord.positions()[15].y / 4.0;
  EXPECT_NEAR(sag, 0.502633, 2e-3);  // of the continuous catenary
}

TEST(Cord, AFreeCordConservesMomentum) {
  CordDef def;
  def.points = 30;
  Cord cord(def);
  cord.attach_mass(7, 30.0);
  for (int p = 0; p < 30; ++p) cord.set_velocity(p, {std::sin(3.0 * p), std::cos(5.0 * p)});
  const auto momentum = [&] {
    Vec2 sum;
    for (int p = 0; p < 30; ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
    return sum;
  };
  const Vec2 before = momentum();
  for (int k = 0; k < 300; ++k) cord.step(1.0 / 60.0, {});
  EXPECT_NEAR(length(momentum() - before), 0.0, 1e-9 * length(before));
  EXPECT_NEAR(path_length(cord.positions()), 10.0, 1e-4);
}

TEST(Cord, FreeFallIsExact) {
  CordDef def;
  Cord cord(def);
  for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(cord.positions()[20].y, -0.5 * 9.81, 1e-9);
  EXPECT_NEAR(cord.velocities()[20].y, -9.81, 1e-9);
}

TEST(Cord, HoldsAMillionTimesItsWeight) {
  CordDef def;
  def.pins = {0};
  Cord cord(def);
  cord.attach_mass(50, 1e6);
  double worst = 0.0;
  for (int k = 0; k < 600; ++k) {
    cord.step(1.0 / 60.0, gravity);
    worst = std::max(worst, std::abs(path_length(cord.positions()) / 10.0 - 1.0));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(Cord, StaysFiniteFromACollapsedStart) {
  CordDef def;
  def.positions.assign(51, Vec2{0.0, 0.0});
  def.pins = {0};
  Cord cord(def);
  for (int k = 0; k < 600; ++k) cord.step(1.0 / 60.0, gravity);
  EXPECT_TRUE(all_finite(cord.positions()));
}

TEST(Cord, AStraightInextensibleCordBetweenTwoPinsStaysFinite) {
  CordDef def;
  def.pins = {0, 1, 50};
  Cord cord(def);
  for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(path_length(cord.positions()), 10.0, 1e-3);
}

TEST(Cord, AMovingPinArrivesExactlyAndPullsTheCord) {
  CordDef def;
  def.pins = {0};
  Cord cord(def);
  come_to_rest(cord);
  for (int k = 1; k <= 60; ++k) {
    cord.constrain(0, {0.05 * k, 0.01 * k});
    cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(cord.positions()[0], (Vec2{0.05 * k, 0.01 * k}));
  }
  EXPECT_NEAR(path_length(cord.positions()), 10.0, 1e-3);
  EXPECT_GT(cord.positions()[10].x, 0.5);
  cord.release(0);
  cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(length(cord.positions()[0] - Vec2{3.0, 0.6}), 0.0, 0.2);
  EXPECT_NE(cord.positions()[0], (Vec2{3.0, 0.6}));
}

TEST(Cord, AStepAllocatesNothing) {
  CordDef rope;
  rope.pins = {0};
  CordDef bending = rope;
  bending.bending_stiffness = 0.1;
  bending.damping = 0.01;
  bending.drag = 0.1;
  CordDef ribbon;
  ribbon.points = 12;
  ribbon.rows = 3;
  ribbon.width = 0.5;
  solid(1e6, 0.0, 0.01, ribbon.width).apply_to(ribbon);
  ribbon.area_stiffness = 1.0;
  for (int p = 0; p < 36; ++p) ribbon.positions.push_back({0.1 * ((7 * p) % 11), 0.1 * ((5 * p) % 13)});
  CordDef bars = ribbon;
  bars.elements = Elements::bars;
  bars.bending_stiffness = 0.0;
  bars.area_stiffness = 0.0;
  IslandReport report;
  for (const CordDef& def : {rope, bending, ribbon, bars}) {
    Cord cord(def);
    cord.attach_mass(cord.size() - 1, 100.0);
    cord.set_load(cord.size() - 1, {1.0, 0.0});
    cord.reel(0, 5, 0.3 * def.length, 0.5);
    const test_support::AllocationCount count;
    for (int k = 0; k < 60; ++k) report += cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(count.so_far(), 0);
  }
  EXPECT_GT(report.searches + report.energy_gains, 0) << "the guard takes none either";
}

/// A coupling does so with each of its cords.
TEST(CordSameBits, ACordThatFreesItsSolverRunsTheSame) {
  CordDef def;
  def.points = 21;
  def.pins = {0};
  Cord keeps(def);
  const test_support::AllocationCount count;
  Cord frees(def);
  const long before = count.held();
  frees.free_solver();
  EXPECT_LT(count.held(), before / 2);
  for (int k = 0; k < 10; ++k) {
    keeps.step(1.0 / 60.0, gravity);
    const test_support::AllocationCount in_step;
    frees.step(1.0 / 60.0, gravity);
    EXPECT_EQ(in_step.so_far() > 0, k == 0) << "step " << k;
  }
  EXPECT_EQ(frees.save(), keeps.save());
}

TEST(CordSameBits, AMoveAssignedCordRunsTheSame) {
  CordDef def;
  def.points = 21;
  def.pins = {0};
  def.bending_stiffness = 0.5;
  Cord stays(def);
  Cord leaves(def);
  CordDef other;
  other.points = 5;
  Cord arrives(other);
  for (int k = 0; k < 10; ++k) {
    stays.step(1.0 / 60.0, gravity);
    leaves.step(1.0 / 60.0, gravity);
  }
  arrives = std::move(leaves);
  for (int k = 0; k < 10; ++k) {
    stays.step(1.0 / 60.0, gravity);
    arrives.step(1.0 / 60.0, gravity);
  }
  EXPECT_TRUE(arrives.def() == stays.def());
  EXPECT_TRUE(arrives.save() == stays.save());
}

TEST(CordSameBits, ARestoredCordRunsTheSame) {
  CordDef def;
  def.pins = {0};
  def.stretch_stiffness = 1e6;
  Cord cord(def);
  cord.attach_mass(50, 20.0);
  for (int k = 0; k < 40; ++k) {
    const Cord::State state = cord.save();
    cord.step(1.0 / 60.0, gravity);
    const Cord::State after = cord.save();
    Cord other(def);
    other.restore(state);
    other.step(1.0 / 60.0, gravity);
    EXPECT_EQ(other.save(), after);
    if (k == 20) cord.release(0);
  }
}

}  // namespace
}  // namespace ribbon
