#include "ribbon/medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/weather.h"
#include "tests/ribbon/in_medium.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"
#include "tests/support/towed_line.h"

// Drag of cords in a medium.

namespace ribbon {
namespace {

using constants::dt;
using constants::g;
using constants::gravity;

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
  const Vec2 reaction = ribbon::reaction(line.cord, 0, gravity);
  EXPECT_NEAR(reaction.x, -sum.x, 1e-6 * sum.x);
  EXPECT_NEAR(reaction.y, weight - sum.y, 1e-6 * weight);
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

}  // namespace
}  // namespace ribbon
