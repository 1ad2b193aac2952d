#include "ribbon/medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/weather.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"
#include "tests/support/towed_line.h"

// Cords in a medium: CordDef::drag_across, drag_along and displaced_area.

namespace ribbon {
namespace {

using constants::dt;
using constants::g;
using constants::gravity;
constexpr double air = 1.2;
constexpr double across = 1.2;
constexpr double along = 0.01;
const std::array presets{Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()};

CordDef rope_with_drag(double mass_per_length = 0.1) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.mass_per_length = mass_per_length;
  def.drag_across = across;
  def.drag_along = along;
  return def;
}

double round_area(const CordDef& def) { return std::numbers::pi * def.radius * def.radius; }

/// N·s²/m³: the drag per length, and per square of the velocity.
double drag_across_of(const CordDef& def, double density) { return density * def.drag_across * def.radius; }
double drag_along_of(const CordDef& def, double density) {
  return density * def.drag_along * std::numbers::pi * def.radius;
}

WeatherDef wind(Vec2 velocity) {
  WeatherDef def;
  def.wind = velocity;
  return def;
}

/// Air of no density, and water up to y = 0.
WeatherDef water(Vec2 current = {}) {
  WeatherDef def;
  def.air_density = 0.0;
  def.water_level = 0.0;
  def.current = current;
  return def;
}

/// A cord that is stepped in a medium.
struct InMedium {
  Cord cord;
  const Medium& medium;
  double time = 0.0;
  IslandReport total = {};

  void step(int steps = 1) {
    for (int k = 0; k < steps; ++k) {
      Surroundings surroundings;
      surroundings.medium = &medium;
      surroundings.time = time;
      total += cord.step(dt, gravity, surroundings);
      time += dt;
    }
  }
  Vec2 momentum() const {
    Vec2 sum;
    for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
    return sum;
  }
  double top_speed() const {
    double top = 0.0;
    for (const Vec2 v : cord.velocities()) top = std::max(top, length(v));
    return top;
  }
  bool is_finite() const {
    const auto finite = [](Vec2 v) { return ribbon::is_finite(v); };
    return std::all_of(cord.positions().begin(), cord.positions().end(), finite) &&
           std::all_of(cord.velocities().begin(), cord.velocities().end(), finite);
  }
  double longest_link() const {
    double longest = 0.0;
    for (std::size_t p = 1; p < cord.positions().size(); ++p)
      longest = std::max(longest, length(cord.positions()[p] - cord.positions()[p - 1]));
    return longest;
  }
};

/// Falling broadside, m·g = ½·ρ·C·d·v². On the way, v = v∞·tanh(g·t/v∞).
TEST(CordInMedium, FallsBroadsideAtTheTerminalVelocity) {
  const Weather still{WeatherDef{}};
  const CordDef def = rope_with_drag();
  const double terminal = std::sqrt(def.mass_per_length * g / drag_across_of(def, air));
  const std::array tolerated{5e-3, 5e-5, 5e-6};  // of it, on the way
  for (std::size_t k = 0; k < presets.size(); ++k) {
    CordDef made = def;
    made.accuracy = presets[k];
    InMedium falling{Cord(made), still};
    double worst = 0.0;
    for (int n = 0; n < 600; ++n) {
      falling.step();
      const double expected = terminal * std::tanh(g * falling.time / terminal);
      worst = std::max(worst, std::abs(-falling.cord.velocities()[20].y - expected) / terminal);
    }
    EXPECT_LT(worst, tolerated[k]);
    EXPECT_NEAR(-falling.cord.velocities()[20].y, terminal, 1e-9 * terminal);
    EXPECT_EQ(falling.total.unconverged, 0);
  }
}

TEST(CordInMedium, FallsLengthwiseAtTheTerminalVelocity) {
  CordDef def = rope_with_drag();
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  WeatherDef dense;
  dense.air_density = 1000.0;
  const Weather medium(dense);
  InMedium falling{Cord(def), medium};
  falling.step(900);
  const double terminal = std::sqrt(def.mass_per_length * g / drag_along_of(def, 1000.0));
  EXPECT_NEAR(-falling.cord.velocities()[20].y, terminal, 1e-9 * terminal);
}

/// A straight line at 45° that falls goes aside: with v across v_n and along v_t, m·g/√2 = k_n·v_n² = k_t·v_t².
TEST(CordInMedium, HasItsOwnCoefficientInEachDirection) {
  CordDef def = rope_with_drag();
  def.drag_along = 0.1;
  def.bending_stiffness = 1e3;
  const double step = 0.1 * std::numbers::sqrt2 / 2.0;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {step, -step});
  const Weather still{WeatherDef{}};
  InMedium falling{Cord(def), still};
  falling.step(1800);
  const Vec2 v = falling.cord.velocities()[20];
  const double weight = def.mass_per_length * g * std::numbers::sqrt2 / 2.0;
  EXPECT_NEAR((v.x - v.y) / std::numbers::sqrt2, std::sqrt(weight / drag_along_of(def, air)), 1e-3);
  EXPECT_NEAR((-v.x - v.y) / std::numbers::sqrt2, std::sqrt(weight / drag_across_of(def, air)), 1e-3);
}

/// See TowedLine.
TEST(CordInMedium, ATowedLineHangsAtTheCriticalAngle) {
  for (const Accuracy& accuracy : presets) {
    for (const double speed : {1.0, 2.0, 3.0}) {
      test_support::TowedLine line(accuracy, speed);
      int unconverged = 0;
      for (int k = 0; k < 3600; ++k) unconverged += line.step().unconverged;
      std::printf("towed at %.0f m/s, %.1f degrees to the flow: off by %.1e of the length\n", speed, line.degrees(),
                  line.error());
      EXPECT_LT(line.error(), 1e-6);
      EXPECT_EQ(unconverged, 0);
    }
  }
}

/// A flow, and a point that is towed through still air, are the same.
TEST(CordInMedium, IsTowedAsInAFlow) {
  CordDef def = rope_with_drag(0.02);
  def.pins = {0};
  const Weather flow(wind({3.0, 0.0}));
  const Weather still{WeatherDef{}};
  InMedium in_flow{Cord(def), flow};
  InMedium towed{Cord(def), still};
  for (int p = 0; p < def.points; ++p) towed.cord.set_velocity(p, {-3.0, 0.0});
  for (int k = 1; k <= 600; ++k) {
    in_flow.step();
    towed.cord.constrain(0, {-3.0 * k * dt, 0.0});
    towed.step();
  }
  for (std::size_t p = 0; p < 41; ++p) {
    const Vec2 expected = in_flow.cord.positions()[p] - Vec2{3.0 * towed.time, 0.0};
    EXPECT_LT(length(towed.cord.positions()[p] - expected), 0.01 * def.length) << p;
  }
}

/// A line without weight, in a flow, that a force T pulls at its end across the flow: with the pressure R·sin² φ across
/// it, cot φ = s/a at a distance s from this end, with a = T/R. It is a catenary on its side.
TEST(CordInMedium, ALineUnderPressureIsACatenary) {
  for (const Accuracy& accuracy : presets) {
    CordDef def = rope_with_drag();
    def.drag_along = 0.0;
    def.gravity_scale = 0.0;
    def.pins = {0};
    def.accuracy = accuracy;
    const Weather flow(wind({10.0, 0.0}));
    InMedium line{Cord(def), flow};
    const double pull = 5.0;
    line.cord.set_load(40, {0.0, -pull});
    line.step(1800);
    const double a = pull / (drag_across_of(def, air) * 100.0);
    double worst = 0.0;
    for (std::size_t p = 0; p < 41; ++p) {
      const double s = 0.1 * (40.0 - static_cast<double>(p));
      const Vec2 expected{a - std::sqrt(a * a + s * s), a * std::asinh(s / a)};
      worst = std::max(worst, length(line.cord.positions()[p] - line.cord.positions()[40] - expected));
    }
    EXPECT_LT(worst, 5e-5 * def.length);
    for (const double tension : line.cord.tensions()) EXPECT_NEAR(tension, pull, 2e-3 * pull);
  }
}

/// The pin carries all forces on the cord: weight, loads, and those of the medium on it.
TEST(CordInMedium, ThePinCarriesTheDrag) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  def.drag = 2.0;  // so that it comes to rest
  const Weather flow(wind({2.0, 0.0}));
  InMedium line{Cord(def), flow};
  line.step(1800);
  ASSERT_LT(line.top_speed(), 1e-6);
  Vec2 sum;
  const Cord::State state = line.cord.save();
  ASSERT_EQ(state.medium_forces.size(), 41U);
  for (const Vec2 force : state.medium_forces) sum += force;
  EXPECT_GT(sum.x, 0.1);
  const double weight = def.mass_per_length * def.length * g;
  const Vec2 reaction = line.cord.reaction(0, gravity);
  EXPECT_NEAR(reaction.x, -sum.x, 1e-6 * sum.x);
  EXPECT_NEAR(reaction.y, weight - sum.y, 1e-6 * weight);
}

TEST(CordInMedium, ACordAsDenseAsTheWaterStaysWhereItIs) {
  CordDef def = rope_with_drag();
  def.displaced_area = round_area(def);
  def.mass_per_length = 1000.0 * def.displaced_area;
  def.positions = test_support::equally_spaced(def.points, {0.0, -5.0}, {0.08, -0.06});
  const Weather sea(water());
  InMedium floating{Cord(def), sea};
  floating.step(600);
  for (std::size_t p = 0; p < 41; ++p) EXPECT_LT(length(floating.cord.positions()[p] - def.positions[p]), 1e-9);
}

/// Archimedes: the share under water is the ratio of the densities.
TEST(CordInMedium, ALightCordFloatsAsDeepAsItIsHeavy) {
  for (const Accuracy& accuracy : presets) {
    for (const double ratio : {0.2, 0.5, 0.8}) {
      CordDef def = rope_with_drag();
      def.accuracy = accuracy;
      def.displaced_area = round_area(def);
      def.mass_per_length = ratio * 1000.0 * def.displaced_area;
      def.positions = test_support::equally_spaced(def.points, {0.0, -0.5}, {0.1, 0.0});
      const Weather sea(water());
      InMedium floating{Cord(def), sea};
      floating.step(1800);
      const double depth = -floating.cord.positions()[20].y / def.radius;  // of its middle, in radii
      const double share = 0.5 + (depth * std::sqrt(1.0 - depth * depth) + std::asin(depth)) / std::numbers::pi;
      EXPECT_NEAR(share, ratio, 0.02) << ratio;
      EXPECT_LT(floating.top_speed(), 0.02);
    }
  }
}

/// A rod that is held at its top sinks its lower part: the force on the pin falls steadily as the water rises.
TEST(CordInMedium, BuoyancyIsSmoothAcrossTheSurface) {
  CordDef def = rope_with_drag();
  def.points = 5;
  def.length = 1.0;
  def.drag_across = def.drag_along = 0.0;
  def.displaced_area = round_area(def);
  def.mass_per_length = 1.0;
  def.pins = {0};
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.25});
  double before = def.mass_per_length * g;
  for (double level = -1.2; level < 0.3; level += 0.02) {
    WeatherDef sea = water();
    sea.water_level = level;
    const Weather medium(sea);
    InMedium held{Cord(def), medium};
    held.step(2);
    const double force = held.cord.reaction(0, gravity).y;
    const double full = 0.02 * 1000.0 * def.displaced_area * g;  // of 2 cm more under water
    EXPECT_LE(force, before + 1e-9);
    EXPECT_GE(force, before - 1.5 * full) << level;
    before = force;
  }
  EXPECT_NEAR(before, (1.0 - 1000.0 * def.displaced_area) * g, 1e-9);
}

TEST(CordInMedium, DriftsWithTheCurrent) {
  CordDef def = rope_with_drag();
  def.displaced_area = round_area(def);
  def.mass_per_length = 500.0 * def.displaced_area;
  const Weather river(water({0.7, 0.0}));
  InMedium floating{Cord(def), river};
  floating.step(3600);
  EXPECT_NEAR(floating.momentum().x, 0.7 * def.mass_per_length * def.length, 0.03 * def.mass_per_length * def.length);
}

/// What declares no coefficient keeps its bits, and so does what is where nothing is.
TEST(CordInMedium, NothingActsOnWhatDeclaresNothing) {
  const Weather storm(wind({30.0, 5.0}));
  WeatherDef nothing;
  nothing.air_density = 0.0;
  nothing.wind = {30.0, 5.0};
  const Weather vacuum(nothing);
  for (const bool declares : {false, true}) {
    CordDef def = rope_with_drag();
    def.pins = {0};
    if (!declares) def.drag_across = def.drag_along = 0.0;
    Cord alone(def);
    InMedium blown{Cord(def), declares ? vacuum : storm};
    for (int k = 0; k < 120; ++k) {
      alone.step(dt, gravity);
      blown.step();
    }
    EXPECT_EQ(alone.save(), blown.cord.save());
  }
}

/// Wind sets a free cord in motion, at last as fast as itself, and never faster.
TEST(CordInMedium, GivesAFreeCordItsVelocity) {
  CordDef def = rope_with_drag();
  def.gravity_scale = 0.0;
  def.bending_stiffness = 10.0;
  const Weather blow(wind({0.0, 8.0}));
  InMedium blown{Cord(def), blow};
  for (int k = 0; k < 600; ++k) {
    blown.step();
    ASSERT_LT(blown.top_speed(), 8.0 + 1e-9);
  }
  const double rate = drag_across_of(def, air) / def.mass_per_length;   // 1/m
  const double expected = 8.0 - 8.0 / (1.0 + 8.0 * rate * blown.time);  // of dv/dt = rate·(8 − v)²
  EXPECT_NEAR(blown.cord.velocities()[20].y, expected, 1e-3);
}

/// The error falls with the square of the substeps.
TEST(CordInMedium, ConvergesWithSecondOrder) {
  const auto end_of = [](int substeps) {
    CordDef def = rope_with_drag(0.05);
    def.pins = {0};
    def.accuracy = {Integrator::tr_bdf2, substeps, 20, 1e-9};
    const Weather blow(wind({4.0, 0.0}));
    InMedium swinging{Cord(def), blow};
    swinging.cord.attach_mass(40, 2.0);
    swinging.step(30);
    return swinging.cord.positions()[40];
  };
  const Vec2 exact = end_of(64);
  const double coarse = length(end_of(2) - exact);
  const double fine = length(end_of(8) - exact);
  EXPECT_GT(coarse / fine, 10.0) << coarse << " m and " << fine << " m";
}

/// Light cords in storms: all steps are solved and stay finite, and nothing is longer or faster than it may be.
TEST(CordInMedium, StaysStableInAnyWind) {
  for (const Accuracy& accuracy : presets) {
    for (const double mass : {1e-4, 1e-3, 0.1}) {
      for (const double speed : {100.0, 1000.0}) {
        for (const double friction : {0.0, 0.005, 0.02, 50.0}) {
          CordDef def = rope_with_drag(mass);
          def.points = 21;
          def.drag_along = friction;
          def.pins = {0};
          def.accuracy = accuracy;
          WeatherDef storm = wind({speed, 0.1 * speed});
          storm.gusts = 1.0;
          const Weather medium(storm);
          InMedium blown{Cord(def), medium};
          for (int k = 0; k < 300; ++k) {
            blown.step();
            ASSERT_TRUE(blown.is_finite());
            if (friction == 0.0) continue;  // nothing draws it straight
            ASSERT_LT(blown.longest_link(), 0.2 * 1.005);
            ASSERT_LT(blown.top_speed(), 10.0 * speed) << "as the end of a whip";
          }
          EXPECT_LE(blown.total.unconverged, friction > 0.0 ? 0 : 30) << mass << ' ' << speed << ' ' << friction;
        }
      }
    }
  }
}

TEST(CordInMedium, ALightCordRisesThroughWaterWithoutAJump) {
  for (const Accuracy& accuracy : presets) {
    CordDef def = rope_with_drag(1e-3);
    def.accuracy = accuracy;
    def.displaced_area = round_area(def);
    def.positions = test_support::equally_spaced(def.points, {0.0, -3.0}, {0.1, 0.0});
    const Weather sea(water());
    InMedium rising{Cord(def), sea};
    const double terminal = std::sqrt(1000.0 * def.displaced_area * g / drag_across_of(def, 1000.0));
    for (int k = 0; k < 120; ++k) {
      rising.step();
      ASSERT_LT(rising.top_speed(), 1.3 * terminal) << k;
    }
    EXPECT_EQ(rising.total.unconverged, 0);
  }
}

/// A ribbon of cells, of several rows, has the same drag as a rope that is as thick as it is wide.
TEST(CordInMedium, ARibbonFallsAsARopeOfItsWidth) {
  for (const int rows : {2, 3, 5}) {
    CordDef def = rope_with_drag();
    def.points = 11;
    def.length = 1.0;
    def.rows = rows;
    def.width = 0.2;
    def.radius = 0.01;
    def.stretch_stiffness = 1e4;
    def.bending_stiffness = 10.0;
    def.mass_per_length = 1.0;
    const Weather still{WeatherDef{}};
    InMedium falling{Cord(def), still};
    falling.step(1800);
    const double terminal = std::sqrt(def.mass_per_length * g / (0.5 * air * across * 0.22));
    EXPECT_NEAR(-falling.momentum().y, terminal * def.mass_per_length, 2e-3 * terminal) << rows;
    EXPECT_EQ(falling.total.unconverged, 0);
  }
}

/// A medium of the user's own: a function of place and time.
class Whirl : public Medium {
 public:
  MediumSample at(Vec2 place, double /*half_height*/, double time) const override {
    MediumSample sample;
    sample.velocity = (time < 1.0 ? 2.0 : 0.0) * perp(place);
    sample.density = air;
    return sample;
  }
};

TEST(CordInMedium, FollowsAFunctionOfPlaceAndTime) {
  CordDef def = rope_with_drag(1e-3);
  def.gravity_scale = 0.0;
  def.bending_stiffness = 10.0;
  def.positions = test_support::equally_spaced(def.points, {-2.0, 0.0}, {0.1, 0.0});
  const Whirl whirl;
  InMedium turning{Cord(def), whirl};
  turning.step(50);
  const Vec2 end = turning.cord.velocities()[40];
  EXPECT_NEAR(length(end), 4.0, 0.15) << "2 rad/s at 2 m";
  EXPECT_NEAR(dot(end, turning.cord.positions()[40]), 0.0, 0.1);
  turning.step(120);
  EXPECT_LT(turning.top_speed(), 1.0) << "still since t = 1 s";
}

/// What is out of range counts as empty space.
class Broken : public Medium {
 public:
  explicit Broken(const MediumSample& sample) : sample_(sample) {}
  MediumSample at(Vec2 /*place*/, double /*half_height*/, double /*time*/) const override { return sample_; }

 private:
  MediumSample sample_;
};

TEST(CordInMedium, ABadSampleIsEmptySpace) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MediumSample& sample :
       {MediumSample{{nan, 0.0}, air}, MediumSample{{0.0, 1e7}, air}, MediumSample{{5.0, 0.0}, -1.0},
        MediumSample{{5.0, 0.0}, nan}, MediumSample{{5.0, 0.0}, 1e7}, MediumSample{{5.0, 0.0}, air, {0.0, nan}}}) {
    const Broken medium(sample);
    InMedium blown{Cord(rope_with_drag()), medium};
    Cord alone(rope_with_drag());
    blown.step(20);
    for (int k = 0; k < 20; ++k) alone.step(dt, gravity);
    EXPECT_EQ(blown.cord.save(), alone.save());
  }
}

TEST(CordInMedium, ContinuesFromASavedStateWithTheSameBits) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  WeatherDef gusty = wind({6.0, 0.0});
  gusty.gusts = 0.8;
  gusty.water_level = -2.0;
  def.displaced_area = round_area(def);
  const Weather medium(gusty);
  InMedium first{Cord(def), medium};
  first.step(37);
  InMedium second{Cord(def), medium};
  second.cord.restore(first.cord.save());
  second.time = first.time;
  first.step(50);
  second.step(50);
  EXPECT_EQ(first.cord.save(), second.cord.save());
  Cord::State bad = first.cord.save();
  bad.medium_forces.pop_back();
  EXPECT_THROW(second.cord.restore(bad), DefinitionError);
  bad = first.cord.save();
  bad.medium_forces[3].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(second.cord.restore(bad), DefinitionError);
}

TEST(CordInMedium, AllocatesNothingInASteadyStep) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  const Weather blow(wind({6.0, 1.0}));
  InMedium blown{Cord(def), blow};
  blown.step(3);
  const test_support::AllocationCount allocations;
  blown.step(60);
  EXPECT_EQ(allocations.so_far(), 0);
}

/// It sleeps in a steady wind, and wakes when that changes at its place.
TEST(CordInMedium, SleepsUntilTheWindChanges) {
  CordDef def = rope_with_drag(0.5);
  def.points = 11;
  def.length = 1.0;
  def.pins = {0};
  def.drag = 4.0;
  def.allow_sleep = true;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  const Weather steady(wind({3.0, 0.0}));
  const Weather stronger(wind({3.1, 0.0}));
  InMedium blown{Cord(def), steady};
  blown.step(1200);
  ASSERT_TRUE(blown.cord.is_asleep());
  const Cord::State asleep = blown.cord.save();
  blown.step(60);
  EXPECT_EQ(blown.cord.save(), asleep);
  InMedium changed{Cord(def), stronger};
  changed.cord.restore(asleep);
  changed.step();
  EXPECT_FALSE(changed.cord.is_asleep());

  WeatherDef gusty = wind({3.0, 0.0});
  gusty.gusts = 0.5;
  const Weather gusts(gusty);
  InMedium waving{Cord(def), gusts};
  waving.step(1800);
  EXPECT_FALSE(waving.cord.is_asleep());
}

/// The pieces of a cord go on with the forces that they had.
TEST(CordInMedium, APieceKeepsItsForces) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  const Weather blow(wind({6.0, 0.0}));
  InMedium blown{Cord(def), blow};
  blown.step(30);
  const Cord::State whole = blown.cord.save();
  const CutPieces pieces = cut(blown.cord, cut_at(blown.cord, 2.0));
  ASSERT_TRUE(pieces.first && pieces.second);
  EXPECT_EQ(pieces.first->save().medium_forces[3], whole.medium_forces[3]);
  EXPECT_EQ(pieces.second->save().medium_forces[3], whole.medium_forces[23]);
  EXPECT_EQ(pieces.second->def().drag_across, across);
}

TEST(CordInMedium, ItsErrorIsEstimated) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  const Weather blow(wind({3.0, 0.0}));
  Cord cord(def);
  std::array reports{CordReport{}};
  DirectSolver solver;
  ErrorProbe probe;
  double largest = 0.0;
  for (int k = 0; k < 60; ++k) {
    IslandCord member{&cord, {}, 1};
    member.surroundings.medium = &blow;
    member.surroundings.time = k * dt;
    probe.foresee({&member, 1}, {}, dt, gravity);
    solver.step({&member, 1}, {}, dt, gravity, reports);
    largest = std::max(largest, probe.error(0, cord));
  }
  EXPECT_LT(largest, 1e-3);
  EXPECT_GT(largest, 0.0);
}

TEST(CordInMedium, ChangesTheVelocityByNoMoreThanItSays) {
  test_support::Dice dice(7);
  for (int k = 0; k < 200; ++k) {
    CordDef def = rope_with_drag(std::pow(10.0, dice(-4.0, 0.0)));
    def.points = 3;
    def.length = 0.3;
    def.gravity_scale = 0.0;
    WeatherDef sea = water({dice(-3.0, 3.0), dice(-3.0, 3.0)});
    sea.wind = {dice(-100.0, 100.0), dice(-100.0, 100.0)};
    sea.air_density = air;
    sea.water_level = dice.coin() ? -100.0 : 100.0;
    if (dice.coin()) def.displaced_area = round_area(def);
    const Weather medium(sea);
    InMedium blown{Cord(def), medium};
    const double bound = medium_delta_v(blown.cord, medium, 0.0, dt, gravity);
    blown.step();
    EXPECT_LT(blown.top_speed(), 1.5 * bound + 1e-9) << k;
  }
  const Weather still{WeatherDef{}};
  EXPECT_EQ(medium_delta_v(Cord(CordDef{}), still, 0.0, dt, gravity), 0.0);
}

TEST(CordInMedium, RefusesWhatIsOutOfRange) {
  Cord cord(rope_with_drag());
  const Cord::State before = cord.save();
  Surroundings surroundings;
  surroundings.time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(test_support::starts_with(
      test_support::refusal<DefinitionError>([&] { cord.step(dt, gravity, surroundings); }), "time is "));
  EXPECT_EQ(cord.save(), before);
}

TEST(CordInMedium, TheThesisSolverRefusesIt) {
  ThesisCord cord{ThesisDef{}};
  const Weather still{WeatherDef{}};
  Surroundings surroundings;
  surroundings.medium = &still;
  const ThesisCord::State before = cord.save();
  EXPECT_TRUE(test_support::says(test_support::refusal<DefinitionError>([&] { cord.step(dt, gravity, surroundings); }),
                                 "medium"));
  EXPECT_EQ(cord.save(), before);
}

}  // namespace
}  // namespace ribbon
