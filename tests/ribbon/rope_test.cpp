#include "ribbon/rope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/support/allocations.h"
#include "tests/support/heavy_swing.h"

namespace ribbon {
namespace {

constexpr Vec2 gravity{0.0, -9.81};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double cord_length(const Rope& rope) {
  double sum = 0.0;
  for (std::size_t p = 1; p < rope.positions().size(); ++p)
    sum += length(rope.positions()[p] - rope.positions()[p - 1]);
  return sum;
}

/// Steps of a second are so strongly damped by an L-stable method that a few dozen bring any cord to rest.
void come_to_rest(Rope& rope) {
  for (int k = 0; k < 3000; ++k) rope.step(1.0, gravity);
}

// --- heavy_swing against the converged solution of the same cord
// -------------------------------------------------------

struct HeavySwingBar {
  double stiffness;  // N
  int substeps;
  double rms;   // m, at most
  double peak;  // stretch above the converged cord's own peak, at most
};

class HeavySwing : public testing::TestWithParam<HeavySwingBar> {};

TEST_P(HeavySwing, StaysNearItsConvergedMotion) {
  const HeavySwingBar& bar = GetParam();
  const auto converged = test_support::run_heavy_swing(bar.stiffness, 128, 1e-9);
  const auto run = test_support::run_heavy_swing(bar.stiffness, bar.substeps, 1e-3);
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

TEST(Rope, HangsAsLongAsItsLumpedWeightsSay) {
  // Link e of n carries all points below it: its stretch is (weight below)/(EA/l).
  RopeDef def;
  def.points = 21;
  def.length = 4.0;
  def.mass = 3.0;
  def.stretch_stiffness = 5000.0;
  def.tolerance = 1e-10;
  def.pins = {0};
  Rope rope(def);
  rope.attach_mass(20, 7.0);
  come_to_rest(rope);
  double expected = 0.0;
  double below = 0.0;
  for (int p = 20; p >= 1; --p) {
    below += rope.mass(p);
    expected += below * 9.81 * 0.2 / def.stretch_stiffness;
    EXPECT_NEAR(rope.tensions()[static_cast<std::size_t>(p - 1)], below * 9.81, 1e-6);
  }
  EXPECT_NEAR(rope.positions()[20].y, -(4.0 + expected), 1e-8);
  EXPECT_NEAR(rope.positions()[20].x, 0.0, 1e-6);
}

/// A lumped chain between two pins obeys tan θ_i = (V_0 + i·m·g)/H exactly.
TEST(Rope, HangsBetweenTwoPinsAsALumpedCatenary) {
  RopeDef def;
  def.points = 31;
  def.length = 6.0;
  def.mass = 2.0;
  def.tolerance = 1e-10;
  def.pins = {0, 30};
  Rope rope(def);
  rope.constrain(30, {4.0, 0.0});  // L/D = 1.5
  come_to_rest(rope);
  EXPECT_NEAR(cord_length(rope), 6.0, 1e-8);  // the least give of an inextensible link between two pins
  std::vector<double> tangents;
  for (std::size_t e = 0; e < 30; ++e) {
    const Vec2 d = rope.positions()[e + 1] - rope.positions()[e];
    tangents.push_back(d.y / d.x);
  }
  const double step = tangents[1] - tangents[0];
  EXPECT_GT(step, 0.0);
  for (std::size_t e = 1; e < 30; ++e) EXPECT_NEAR(tangents[e] - tangents[e - 1], step, 1e-6);
  const double sag = -rope.positions()[15].y / 4.0;
  EXPECT_NEAR(sag, 0.502633, 2e-3);  // of the continuous catenary
}

TEST(Rope, AFreeOneKeepsItsMomentum) {
  RopeDef def;
  def.points = 30;
  Rope rope(def);
  rope.attach_mass(7, 30.0);
  for (int p = 0; p < 30; ++p) rope.set_velocity(p, {std::sin(3.0 * p), std::cos(5.0 * p)});
  const auto momentum = [&] {
    Vec2 sum;
    for (int p = 0; p < 30; ++p) sum += rope.mass(p) * rope.velocities()[static_cast<std::size_t>(p)];
    return sum;
  };
  const Vec2 before = momentum();
  for (int k = 0; k < 300; ++k) rope.step(1.0 / 60.0, {});
  EXPECT_NEAR(length(momentum() - before), 0.0, 1e-9 * length(before));
  EXPECT_NEAR(cord_length(rope), 10.0, 1e-4);
}

TEST(Rope, FreeFallIsExact) {
  RopeDef def;
  Rope rope(def);
  for (int k = 0; k < 60; ++k) rope.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(rope.positions()[20].y, -0.5 * 9.81, 1e-9);
  EXPECT_NEAR(rope.velocities()[20].y, -9.81, 1e-9);
}

// --- at the extremes
// ---------------------------------------------------------------------------------------------------

TEST(Rope, HoldsAMillionTimesItsWeight) {
  RopeDef def;
  def.pins = {0};
  Rope rope(def);
  rope.attach_mass(50, 1e6);
  double worst = 0.0;
  for (int k = 0; k < 600; ++k) {
    rope.step(1.0 / 60.0, gravity);
    worst = std::max(worst, std::abs(cord_length(rope) / 10.0 - 1.0));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(Rope, StaysFiniteFromACollapsedStart) {
  RopeDef def;
  def.positions.assign(51, Vec2{0.0, 0.0});
  def.pins = {0};
  Rope rope(def);
  for (int k = 0; k < 600; ++k) rope.step(1.0 / 60.0, gravity);
  for (const Vec2 p : rope.positions()) EXPECT_TRUE(is_finite(p));
}

TEST(Rope, AStraightInextensibleCordBetweenTwoPinsIsNoDivisionByZero) {
  RopeDef def;
  def.pins = {0, 1, 50};
  Rope rope(def);
  for (int k = 0; k < 60; ++k) rope.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(cord_length(rope), 10.0, 1e-3);
}

// --- the class itself
// --------------------------------------------------------------------------------------------------

TEST(Rope, AMovingPinArrivesExactlyAndIsFollowed) {
  RopeDef def;
  def.pins = {0};
  Rope rope(def);
  come_to_rest(rope);
  for (int k = 1; k <= 60; ++k) {
    rope.constrain(0, {0.05 * k, 0.01 * k});
    rope.step(1.0 / 60.0, gravity);
    EXPECT_EQ(rope.positions()[0], (Vec2{0.05 * k, 0.01 * k}));
  }
  EXPECT_NEAR(cord_length(rope), 10.0, 1e-3);
  EXPECT_GT(rope.positions()[10].x, 0.5);
  rope.release(0);
  rope.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(length(rope.positions()[0] - Vec2{3.0, 0.6}), 0.0, 0.2);
  EXPECT_NE(rope.positions()[0], (Vec2{3.0, 0.6}));
}

TEST(Rope, TakesNoHeapMemoryInAStep) {
  RopeDef def;
  def.pins = {0};
  Rope rope(def);
  const test_support::AllocationCount count;
  for (int k = 0; k < 60; ++k) rope.step(1.0 / 60.0, gravity);
  EXPECT_EQ(count.so_far(), 0);
}

TEST(RopeSameBits, SavedAndRestoredItRunsTheSame) {
  RopeDef def;
  def.pins = {0};
  def.stretch_stiffness = 1e6;
  Rope rope(def);
  rope.attach_mass(50, 20.0);
  for (int k = 0; k < 40; ++k) {
    const Rope::State state = rope.save();
    rope.step(1.0 / 60.0, gravity);
    const Rope::State after = rope.save();
    Rope other(def);
    other.restore(state);
    other.step(1.0 / 60.0, gravity);
    EXPECT_EQ(other.save(), after);
    if (k == 20) rope.release(0);
  }
}

TEST(RopeDef, RefusesEachBadFieldByNameAndValue) {
  struct Bad {
    const char* field;
    std::function<void(RopeDef&)> spoil;
  };
  const Bad fields[] = {
      {"points", [](RopeDef& d) { d.points = 1; }},
      {"length", [](RopeDef& d) { d.length = 0.0; }},
      {"length", [](RopeDef& d) { d.length = nan; }},
      {"mass", [](RopeDef& d) { d.mass = -1.0; }},
      {"stretch_stiffness", [](RopeDef& d) { d.stretch_stiffness = 0.0; }},
      {"stretch_stiffness", [](RopeDef& d) { d.stretch_stiffness = -infinity; }},
      {"substeps", [](RopeDef& d) { d.substeps = 0; }},
      {"tolerance", [](RopeDef& d) { d.tolerance = 0.0; }},
      {"max_iterations", [](RopeDef& d) { d.max_iterations = 0; }},
      {"positions", [](RopeDef& d) { d.positions.resize(50); }},
      {"positions[3]",
       [](RopeDef& d) {
         d.positions.resize(51);
         d.positions[3].x = nan;
       }},
      {"pins[0]", [](RopeDef& d) { d.pins = {51}; }},
  };
  for (const Bad& bad : fields) {
    RopeDef def;
    bad.spoil(def);
    try {
      const Rope rope(def);
      ADD_FAILURE() << bad.field << " was accepted";
    } catch (const DefinitionError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(bad.field, 0), 0U) << error.what();
    }
  }
}

TEST(Rope, RefusesUnknownPointsAndBadNumbersAndChangesNothing) {
  Rope rope{RopeDef{}};
  const Rope::State before = rope.save();
  EXPECT_THROW(rope.attach_mass(51, 1.0), DefinitionError);
  EXPECT_THROW(rope.attach_mass(3, -1.0), DefinitionError);
  EXPECT_THROW(rope.constrain(-1, {}), DefinitionError);
  EXPECT_THROW(rope.constrain(3, {nan, 0.0}), DefinitionError);
  EXPECT_THROW(rope.release(51), DefinitionError);
  EXPECT_THROW(rope.set_velocity(3, {0.0, 1e10}), DefinitionError);
  Rope::State other = before;
  other.tensions.pop_back();
  EXPECT_THROW(rope.restore(other), DefinitionError);
  EXPECT_EQ(rope.save(), before);
}

}  // namespace
}  // namespace ribbon
