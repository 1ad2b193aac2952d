#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/heavy_swing.h"
#include "tests/support/points.h"
#include "tests/support/reference_scenes.h"

namespace ribbon {
namespace {

using constants::gravity;
using constants::infinity;

// --- at rest ---------------------------------------------------------------------------------------------------------

class CatenaryRows : public testing::TestWithParam<test_support::Catenary> {};

TEST_P(CatenaryRows, HasTheExactSagAndTension) {
  const test_support::Catenary& row = GetParam();
  Cord cord(test_support::hanging_between_pins(row, 100));
  test_support::come_to_rest(cord, gravity);
  const test_support::HangingShape found = test_support::shape_of(cord);
  const test_support::HangingShape lumped = test_support::lumped_shape(row, 100);
  EXPECT_NEAR(found.sag / lumped.sag, 1.0, 1e-6);
  EXPECT_NEAR(found.tension / lumped.tension, 1.0, 1e-6);
  EXPECT_NEAR(found.sag / row.sag, 1.0, 1e-3);
  EXPECT_NEAR(found.tension / row.tension, 1.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(References, CatenaryRows, testing::ValuesIn(test_support::catenaries));

struct Beam {
  int columns;
  int rows;
  double slenderness;  // L / t
  double worst;        // maximum error of the tip's position, relative to L
};

class LongCantilever : public testing::TestWithParam<Beam> {};

TEST_P(LongCantilever, BendsLikeTheElastica) {
  const Beam& beam = GetParam();
  for (const test_support::Cantilever& row : test_support::cantilevers) {
    const double width = beam.rows > 1 ? 1.0 / beam.slenderness : 0.0;
    Cord cord = test_support::clamped_beam(beam.columns, beam.rows, width, row, test_support::tight());
    test_support::come_to_rest(cord, {});
    const test_support::Cantilever found = test_support::bent(cord, row.load);
    EXPECT_NEAR(found.down, row.down, beam.worst) << "P·L²/EI = " << row.load;
    EXPECT_NEAR(found.inward, row.inward, beam.worst) << "P·L²/EI = " << row.load;
  }
}

INSTANTIATE_TEST_SUITE_P(Ropes, LongCantilever, testing::Values(Beam{51, 1, 0.0, 0.005}));
INSTANTIATE_TEST_SUITE_P(Ribbons, LongCantilever,
                         testing::Values(Beam{20, 2, 20.0, 0.004}, Beam{20, 2, 100.0, 0.004}, Beam{20, 3, 20.0, 0.004},
                                         Beam{20, 3, 100.0, 0.004}, Beam{20, 4, 20.0, 0.004}, Beam{20, 4, 100.0, 0.004},
                                         Beam{20, 5, 20.0, 0.004}, Beam{20, 5, 100.0, 0.004}));

/// EI does not follow from EA: a strip a hundredth as stiff against bending as a solid bends a hundred times as far.
TEST(LongCantileverOfASoftStrip, BendsByItsOwnStiffness) {
  for (const int rows : {2, 3, 5}) {
    for (const test_support::Cantilever& row : test_support::cantilevers) {
      const Cord solid = test_support::clamped_beam(20, rows, 0.05, row, test_support::tight());
      CordDef def = solid.def();
      def.stretch_stiffness *= 100.0;  // and EI as it was
      Cord cord(def);
      for (int p = 0; p < cord.size(); ++p) {
        if (p / rows != 19) continue;
        const bool middle = p % rows == (rows - 1) / 2 || p % rows == rows / 2;
        if (middle) cord.set_load(p, {0.0, rows % 2 == 1 ? -row.load : -0.5 * row.load});
      }
      test_support::come_to_rest(cord, {});
      EXPECT_NEAR(test_support::bent(cord, row.load).down, row.down, 0.006) << rows << " rows, " << row.load;
    }
  }
}

/// The link angles θ of a clamped–free chain of n free links under a compressive force P: (EI/l)·(D·θ) = P·l·θ with D
/// of the fixed–free chain, whose least eigenvalue is 4·sin²(π/(2(2n + 1))).
TEST(CordBuckling, BeginsAtTheExactDiscreteLoad) {
  constexpr int links = 20;
  const auto grown = [](double share) {
    CordDef def;
    def.points = links + 2;
    def.length = 1.0;
    def.bending_stiffness = 1.0;
    def.accuracy.tolerance = 1e-12;
    def.pins = {0, 1};
    Cord cord(def);
    const double link = def.length / (def.points - 1);
    const double s = std::sin(std::numbers::pi / (2.0 * (2 * links + 1)));
    cord.set_load(links + 1, {-share * 4.0 * def.bending_stiffness / (link * link) * s * s, 0.0});
    cord.set_velocity(links + 1, {0.0, 1e-4});
    double most = 0.0;
    for (int k = 0; k < 2400; ++k) {
      cord.step(1.0 / 240.0, {});
      most = std::max(most, std::abs(cord.positions().back().y));
    }
    return most;
  };
  EXPECT_LT(grown(0.99), 1e-3);
  EXPECT_GT(grown(1.01), 1e-2);
}

// --- in motion -------------------------------------------------------------------------------------------------------

TEST(LongHangingChain, SwingsAtItsFrequencies) {
  for (int mode = 0; mode < 3; ++mode) {
    Accuracy accuracy = test_support::tight();
    accuracy.tolerance = 1e-12;
    Cord chain = test_support::swung_chain(mode, accuracy);
    const double found = test_support::measured_frequency(chain, mode, 3, 1.0 / 600.0);
    EXPECT_NEAR(found / test_support::hanging_frequencies[static_cast<std::size_t>(mode)], 1.0, 1e-3) << mode;
  }
}

struct OrderCase {
  double stiffness;
  double bending;
};

/// Returns the difference of a swinging chain after a step size dt from one after dt/32; the start is smooth.
double error_at(Integrator integrator, const OrderCase& chain, int steps) {
  const auto end = [&](int n, Integrator with) {
    CordDef def;
    def.points = 6;
    def.length = 1.0;
    def.stretch_stiffness = chain.stiffness;
    def.bending_stiffness = chain.bending;
    def.accuracy = {with, 1, 50, 1e-12};
    def.pins = {0};
    def.positions = test_support::equally_spaced(6, {0.0, 0.0}, {0.0, -0.2});
    Cord cord(def);
    for (int p = 0; p < 6; ++p) cord.set_velocity(p, {0.4 * p, 0.0});
    for (int k = 0; k < n; ++k) cord.step(0.5 / n, gravity);
    return cord.positions().back();
  };
  const Vec2 exact = end(32 * steps, Integrator::tr_bdf2);
  return length(end(steps, integrator) - exact);
}

class LongConvergence : public testing::TestWithParam<OrderCase> {};

TEST_P(LongConvergence, OrderInTheTimeStep) {
  const OrderCase chain = GetParam();
  for (const int steps : {400, 800}) {
    const auto order = [&](Integrator with) {
      return std::log2(error_at(with, chain, steps) / error_at(with, chain, 2 * steps));
    };
    EXPECT_NEAR(order(Integrator::tr_bdf2), 2.0, 0.1) << steps;
    EXPECT_NEAR(order(Integrator::implicit_euler), 1.0, 0.1) << steps;
  }
}

INSTANTIATE_TEST_SUITE_P(All, LongConvergence,
                         testing::Values(OrderCase{infinity, 0.0}, OrderCase{20.0, 0.0}, OrderCase{infinity, 0.01}));

TEST(HeavySwingBalanced, LosesLittleEnergy) {
  const auto run = test_support::run_heavy_swing(infinity, Accuracy::balanced());
  EXPECT_GE(run.lost_energy, 0.0);
  EXPECT_LE(run.lost_energy, 0.003);
  EXPECT_EQ(run.report.unconverged, 0);
  RecordProperty("lost_percent", std::to_string(100.0 * run.lost_energy));
}

/// A solid strip with a pull P at both ends gets longer by P·L/EA and narrower by ν times that strain.
TEST(CordStretch, ASolidStripNarrowsByPoissonsRatio) {
  for (const int rows : {2, 3}) {
    CordDef def;
    def.points = 41;
    def.rows = rows;
    def.length = 4.0;
    def.width = 0.2;
    solid(1e5, 0.3, 0.1, def.width).apply_to(def);
    def.damping = 0.05;
    Cord cord(def);
    const double pull = 0.01 * def.stretch_stiffness;
    for (int j = 0; j < rows; ++j) {
      const double share = (j == 0 || j == rows - 1 ? 0.5 : 1.0) / (rows - 1);
      cord.set_load(cord.index(40, j), {share * pull, 0.0});
      cord.set_load(cord.index(0, j), {-share * pull, 0.0});
    }
    test_support::come_to_rest(cord, {}, 600);
    const auto at = [&](int i, int j) { return cord.positions()[static_cast<std::size_t>(cord.index(i, j))]; };
    EXPECT_NEAR(length(at(30, 0) - at(10, 0)) / 2.0 - 1.0, 0.01, 1e-4) << rows;
    EXPECT_NEAR(length(at(20, rows - 1) - at(20, 0)) / 0.2 - 1.0, -0.3 * 0.01, 1e-4) << rows;
  }
}

/// One link with EA and the damping time β is an oscillator of ω² = EA/(l·m) and damping ratio β·ω/2.
TEST(CordDamping, DampsAnOscillationByItsDampingTime) {
  CordDef def;
  def.points = 2;
  def.length = 1.0;
  def.stretch_stiffness = 100.0;
  def.mass_per_length = 2.0;  // half of it on the free end: ω = 10 rad/s
  def.damping = 0.01;         // ratio 0.05
  def.accuracy.tolerance = 1e-12;
  def.pins = {0};
  def.positions = {{0.0, 0.0}, {1.1, 0.0}};
  Cord cord(def);
  double last = 0.1;
  double before = 0.1;
  std::vector<double> peaks;
  for (int k = 0; k < 4000; ++k) {
    cord.step(1e-3, {});
    const double now = cord.positions()[1].x - 1.0;
    if (last > before && last > now) peaks.push_back(last);
    before = last;
    last = now;
  }
  ASSERT_GE(peaks.size(), 3U);
  const double expected = std::exp(-2.0 * std::numbers::pi * 0.05 / std::sqrt(1.0 - 0.05 * 0.05));
  EXPECT_NEAR(peaks[1] / peaks[0], expected, 2e-3);
  EXPECT_NEAR(peaks[2] / peaks[1], expected, 2e-3);
}

TEST(CordDamping, DampsBending) {
  CordDef def;
  def.points = 20;
  def.length = 1.0;
  def.bending_stiffness = 0.1;
  def.pins = {0, 1};
  for (const bool damped : {false, true}) {
    def.damping = damped ? 0.05 : 0.0;
    Cord cord(def);
    for (int k = 0; k < 1800; ++k) cord.step(1.0 / 60.0, gravity);
    const double moving = energy_of(cord, gravity).kinetic;
    EXPECT_EQ(moving < 1e-9, damped) << moving;
  }
}

TEST(CordDrag, SlowsTheCordAndNotItsLoad) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.drag = 2.0;
  Cord cord(def);
  for (int p = 0; p < 11; ++p) cord.set_velocity(p, {3.0, 0.0});
  for (int k = 0; k < 100; ++k) cord.step(0.01, {});
  EXPECT_NEAR(cord.velocities()[4].x, 3.0 * std::exp(-2.0), 1e-4);

  Cord loaded(def);
  loaded.attach_mass(5, 0.1);  // as heavy as the cord: half the rate
  for (int p = 0; p < 11; ++p) loaded.set_velocity(p, {3.0, 0.0});
  double momentum = 0.0;
  for (int k = 0; k < 100; ++k) loaded.step(0.01, {});
  for (int p = 0; p < 11; ++p) momentum += loaded.mass(p) * loaded.velocities()[static_cast<std::size_t>(p)].x;
  EXPECT_GT(momentum / 0.6, std::exp(-2.0));
  EXPECT_LT(momentum / 0.6, std::exp(-0.5));
}

TEST(CordFreeFlight, ConservesMomentumToRoundOff) {
  CordDef rope;
  rope.points = 30;
  CordDef bending = rope;
  bending.bending_stiffness = 0.1;
  CordDef ribbon;
  ribbon.points = 15;
  ribbon.rows = 3;
  ribbon.length = 3.0;
  ribbon.width = 0.4;
  solid(1e5, 0.3, 0.1, 0.4).apply_to(ribbon);
  CordDef bars = ribbon;
  bars.elements = Elements::bars;
  bars.bending_stiffness = 0.0;
  bars.poisson_ratio = 0.0;
  for (const CordDef& def : {rope, bending, ribbon, bars}) {
    Cord cord = test_support::thrown(def, 1.0, 30.0);
    const Vec2 before = test_support::momentum(cord);
    for (int k = 0; k < 300; ++k) cord.step(1.0 / 60.0, {});
    EXPECT_NEAR(length(test_support::momentum(cord) - before), 0.0, 1e-9 * length(before)) << def.rows;
  }
}

}  // namespace
}  // namespace ribbon
