#include "ribbon/cord.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/support/allocations.h"
#include "tests/support/heavy_swing.h"

namespace ribbon {
namespace {

constexpr Vec2 gravity{0.0, -9.81};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double cord_length(const Cord& cord) {
  double sum = 0.0;
  for (std::size_t p = 1; p < cord.positions().size(); ++p)
    sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  return sum;
}

void make_ribbon(CordDef& def, int rows) {
  def.rows = rows;
  def.width = 0.5;
  solid(1e6, 0.0, 0.01, def.width).apply_to(def);
}

/// Steps of a second are so strongly damped by an L-stable method that a few dozen bring any cord to rest.
void come_to_rest(Cord& cord) {
  for (int k = 0; k < 3000; ++k) cord.step(1.0, gravity);
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

TEST(Cord, HangsAsLongAsItsLumpedWeightsSay) {
  // Link e of n carries all points below it: its stretch is (weight below)/(EA/l).
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
  EXPECT_NEAR(cord_length(cord), 6.0, 1e-8);  // the least give of an inextensible link between two pins
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

TEST(Cord, AFreeOneKeepsItsMomentum) {
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
  EXPECT_NEAR(cord_length(cord), 10.0, 1e-4);
}

TEST(Cord, FreeFallIsExact) {
  CordDef def;
  Cord cord(def);
  for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(cord.positions()[20].y, -0.5 * 9.81, 1e-9);
  EXPECT_NEAR(cord.velocities()[20].y, -9.81, 1e-9);
}

// --- at the extremes
// ---------------------------------------------------------------------------------------------------

TEST(Cord, HoldsAMillionTimesItsWeight) {
  CordDef def;
  def.pins = {0};
  Cord cord(def);
  cord.attach_mass(50, 1e6);
  double worst = 0.0;
  for (int k = 0; k < 600; ++k) {
    cord.step(1.0 / 60.0, gravity);
    worst = std::max(worst, std::abs(cord_length(cord) / 10.0 - 1.0));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(Cord, StaysFiniteFromACollapsedStart) {
  CordDef def;
  def.positions.assign(51, Vec2{0.0, 0.0});
  def.pins = {0};
  Cord cord(def);
  for (int k = 0; k < 600; ++k) cord.step(1.0 / 60.0, gravity);
  for (const Vec2 p : cord.positions()) EXPECT_TRUE(is_finite(p));
}

TEST(Cord, AStraightInextensibleCordBetweenTwoPinsIsNoDivisionByZero) {
  CordDef def;
  def.pins = {0, 1, 50};
  Cord cord(def);
  for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(cord_length(cord), 10.0, 1e-3);
}

// --- the class itself
// --------------------------------------------------------------------------------------------------

TEST(Cord, AMovingPinArrivesExactlyAndIsFollowed) {
  CordDef def;
  def.pins = {0};
  Cord cord(def);
  come_to_rest(cord);
  for (int k = 1; k <= 60; ++k) {
    cord.constrain(0, {0.05 * k, 0.01 * k});
    cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(cord.positions()[0], (Vec2{0.05 * k, 0.01 * k}));
  }
  EXPECT_NEAR(cord_length(cord), 10.0, 1e-3);
  EXPECT_GT(cord.positions()[10].x, 0.5);
  cord.release(0);
  cord.step(1.0 / 60.0, gravity);
  EXPECT_NEAR(length(cord.positions()[0] - Vec2{3.0, 0.6}), 0.0, 0.2);
  EXPECT_NE(cord.positions()[0], (Vec2{3.0, 0.6}));
}

TEST(Cord, TakesNoHeapMemoryInAStep) {
  CordDef rope;
  rope.pins = {0};
  CordDef bending = rope;
  bending.bending_stiffness = 0.1;
  bending.damping = 0.01;
  bending.drag = 0.1;
  CordDef ribbon;
  ribbon.points = 12;
  make_ribbon(ribbon, 3);
  ribbon.area_stiffness = 1.0;
  for (int p = 0; p < 36; ++p) ribbon.positions.push_back({0.1 * ((7 * p) % 11), 0.1 * ((5 * p) % 13)});
  CordDef bars = ribbon;
  bars.elements = Elements::bars;
  bars.bending_stiffness = 0.0;
  bars.area_stiffness = 0.0;
  CordReport report;
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

TEST(CordSameBits, MovedOntoAnotherItRunsTheSame) {
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

TEST(CordSameBits, SavedAndRestoredItRunsTheSame) {
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

TEST(CordDef, RibbonsOfSolidMaterialAreAccepted) {
  for (const int rows : {2, 3, 64}) {
    CordDef def;
    make_ribbon(def, rows);
    EXPECT_NO_THROW(check(def));
    def.elements = Elements::bars;
    def.bending_stiffness = 0.0;
    EXPECT_NO_THROW(check(def));
  }
  // The same strip by Young's modulus and by its stiffnesses against shear and change of area.
  const RibbonMaterial by_modulus = solid(2e5, 0.25, 0.1, 0.5);
  const double modulus = 2e5 * 0.1;
  const RibbonMaterial by_shear = solid_of_shear_and_area(modulus / 2.5, modulus / 1.5, 0.5);
  EXPECT_NEAR(by_shear.stretch_stiffness, by_modulus.stretch_stiffness, 1e-9 * by_modulus.stretch_stiffness);
  EXPECT_NEAR(by_shear.bending_stiffness, by_modulus.bending_stiffness, 1e-9 * by_modulus.bending_stiffness);
  EXPECT_NEAR(by_shear.poisson_ratio, 0.25, 1e-12);
  EXPECT_THROW(solid(-1.0, 0.0, 0.1, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 1.0, 0.1, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 0.0, 0.0, 0.5), DefinitionError);
  EXPECT_THROW(solid(1e5, 0.0, 0.1, nan), DefinitionError);
  EXPECT_THROW(solid_of_shear_and_area(0.0, 1.0, 0.5), DefinitionError);
}

TEST(CordDef, RefusesEachBadFieldByNameAndValue) {
  struct Bad {
    const char* field;
    std::function<void(CordDef&)> spoil;
  };
  const Bad fields[] = {
      {"points", [](CordDef& d) { d.points = 1; }},
      {"length", [](CordDef& d) { d.length = 0.0; }},
      {"length", [](CordDef& d) { d.length = nan; }},
      {"mass_per_length", [](CordDef& d) { d.mass_per_length = -1.0; }},
      {"stretch_stiffness", [](CordDef& d) { d.stretch_stiffness = 0.0; }},
      {"stretch_stiffness", [](CordDef& d) { d.stretch_stiffness = -infinity; }},
      {"accuracy.substeps", [](CordDef& d) { d.accuracy.substeps = 0; }},
      {"accuracy.tolerance", [](CordDef& d) { d.accuracy.tolerance = 0.0; }},
      {"accuracy.max_iterations", [](CordDef& d) { d.accuracy.max_iterations = 0; }},
      {"accuracy.max_work", [](CordDef& d) { d.accuracy.max_work = 0; }},
      {"accuracy.max_work", [](CordDef& d) { d.accuracy.max_work = 1'000'001; }},
      {"points", [](CordDef& d) { d.points = 1000001; }},
      {"points",
       [](CordDef& d) {
         d.rows = 2;
         d.points = 500001;
       }},
      {"rows", [](CordDef& d) { d.rows = 0; }},
      {"rows", [](CordDef& d) { d.rows = 65; }},
      {"radius", [](CordDef& d) { d.radius = -0.1; }},
      {"bending_stiffness", [](CordDef& d) { d.bending_stiffness = -1.0; }},
      {"bending_stiffness", [](CordDef& d) { d.bending_stiffness = infinity; }},
      {"damping", [](CordDef& d) { d.damping = nan; }},
      {"drag", [](CordDef& d) { d.drag = -1.0; }},
      // of a rope
      {"width", [](CordDef& d) { d.width = 0.1; }},
      {"poisson_ratio", [](CordDef& d) { d.poisson_ratio = 0.3; }},
      {"area_stiffness", [](CordDef& d) { d.area_stiffness = 1.0; }},
      {"elements", [](CordDef& d) { d.elements = Elements::bars; }},
      {"bending_stiffness",
       [](CordDef& d) {
         d.points = 2;
         d.bending_stiffness = 1.0;
       }},
      // of a ribbon
      {"width",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.width = 0.0;
       }},
      {"stretch_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.stretch_stiffness = infinity;
       }},
      {"poisson_ratio",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.poisson_ratio = 1.0;
       }},
      {"area_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.area_stiffness = -1.0;
       }},
      {"tension_only",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.tension_only = true;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 3);
         d.bending_stiffness = 0.0;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 3);
         d.bending_stiffness *= 1.01;
       }},
      {"bending_stiffness",
       [](CordDef& d) {
         make_ribbon(d, 2);
         d.elements = Elements::bars;
       }},
      {"positions", [](CordDef& d) { d.positions.resize(50); }},
      {"positions[3]",
       [](CordDef& d) {
         d.positions.resize(51);
         d.positions[3].x = nan;
       }},
      {"pins[0]", [](CordDef& d) { d.pins = {51}; }},
  };
  for (const Bad& bad : fields) {
    CordDef def;
    bad.spoil(def);
    try {
      const Cord cord(def);
      ADD_FAILURE() << bad.field << " was accepted";
    } catch (const DefinitionError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(bad.field, 0), 0U) << error.what();
    }
  }
}

TEST(Cord, RefusesStepsThatCannotBeAndChangesNothing) {
  Cord cord{CordDef{}};
  const Cord::State before = cord.save();
  const auto refuses = [&](double dt, Vec2 pull, const Surroundings& met, const std::string& field) {
    try {
      cord.step(dt, pull, met);
      ADD_FAILURE() << field << " was accepted";
    } catch (const DefinitionError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(field + " is ", 0), 0U) << error.what();
    }
  };
  refuses(nan, {}, {}, "dt");
  refuses(0.0, {}, {}, "dt");
  refuses(1e-10, {}, {}, "dt");
  refuses(2.0, {}, {}, "dt");
  refuses(0.01, {0.0, nan}, {}, "gravity");
  std::array bodies{RigidBody{}, RigidBody{}};
  const std::array circles{RigidCircle{1, {}, 0.1}, RigidCircle{2, {}, 0.1}};
  refuses(0.01, {}, {bodies, circles, {}, {}}, "circles[1].body");
  const std::array thin{RigidCircle{0, {}, -0.1}};
  refuses(0.01, {}, {bodies, thin, {}, {}}, "circles[0].radius");
  const std::array segments{RigidSegment{0, {}, {nan, 0.0}}};
  refuses(0.01, {}, {bodies, {}, {}, segments}, "segments[0].b");
  const std::array grips{Grip{51, 0, {}}};
  refuses(0.01, {}, {bodies, {}, grips, {}}, "grips[0].point");
  bodies[1].inverse_mass = -1.0;
  refuses(0.01, {}, {bodies, {}, {}, {}}, "bodies[1].inverse_mass");
  EXPECT_EQ(cord.save(), before);
}

TEST(Cord, RefusesUnknownPointsAndBadNumbersAndChangesNothing) {
  Cord cord{CordDef{}};
  const Cord::State before = cord.save();
  EXPECT_THROW(cord.attach_mass(51, 1.0), DefinitionError);
  EXPECT_THROW(cord.attach_mass(3, -1.0), DefinitionError);
  EXPECT_THROW(cord.constrain(-1, {}), DefinitionError);
  EXPECT_THROW(cord.constrain(3, {nan, 0.0}), DefinitionError);
  EXPECT_THROW(cord.release(51), DefinitionError);
  EXPECT_THROW(cord.set_velocity(3, {0.0, 1e10}), DefinitionError);
  Cord::State other = before;
  other.tensions.pop_back();
  EXPECT_THROW(cord.restore(other), DefinitionError);
  EXPECT_EQ(cord.save(), before);
}

}  // namespace
}  // namespace ribbon
