#include "ribbon/medium.h"

#include <gtest/gtest.h>

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

// Buoyancy of cords.

namespace ribbon {
namespace {

using constants::g;
using constants::gravity;

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
    const double force = ribbon::reaction(held.cord, 0, gravity).y;
    const double full = 0.02 * 1000.0 * def.displaced_area * g;  // of 2 cm more under water
    EXPECT_LE(force, before + 1e-9);
    EXPECT_GE(force, before - 1.5 * full) << level;
    before = force;
  }
  EXPECT_NEAR(before, (1.0 - 1000.0 * def.displaced_area) * g, 1e-9);
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

}  // namespace
}  // namespace ribbon
