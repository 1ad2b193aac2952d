#include "ribbon/rest_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "ribbon/cord.h"
#include "ribbon/layout.h"
#include "tests/support/constants.h"
#include "tests/support/reference_scenes.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

using constants::gravity;
using test_support::refusal;

/// Returns how far a point moves in a second, m, if steps are solved exactly.
double moved_in_a_second(CordDef def, Vec2 under = gravity) {
  def.accuracy.tolerance = 1e-9;
  def.accuracy.max_iterations = 30;
  Cord cord(def);
  double most = 0.0;
  for (int k = 0; k < 60; ++k) {
    cord.step(1.0 / 60.0, under);
    for (std::size_t p = 0; p < def.positions.size(); ++p) {
      most = std::max(most, length(cord.positions()[p] - def.positions[p]));
    }
  }
  return most;
}

/// A rope that is laid along two straight lines, and hangs in an arc.
CordDef slack_rope(double size = 1.0) {
  CordDef def;
  def.points = 41;
  lay_along(def, {{0.0, 0.0}, size * Vec2{3.6, -3.4}, size * Vec2{6.8, -0.8}});
  def.mass_per_length = 0.6;
  def.bending_stiffness = 2.0 * size * size * size;  // as much beside its weight at any size
  def.pins = {0, 40};
  return def;
}

TEST(RestShape, IsTheCatenaryOfItsPoints) {
  for (const test_support::Catenary& catenary : test_support::catenaries) {
    CordDef def = test_support::hanging_between_pins(catenary, 40);
    lay_at_rest(def, gravity);
    const double span = length(def.positions.back() - def.positions.front());
    const double sag = def.positions.front().y - def.positions[20].y;
    if (catenary.give == 0.0) {
      EXPECT_NEAR(sag / span, test_support::lumped_shape(catenary, 40).sag, 1e-6) << catenary.slackness;
    } else {
      EXPECT_NEAR(sag / span, catenary.sag, 2e-3 * catenary.sag) << catenary.slackness;
    }
  }
}

/// Before, the rope of 9 m swings by half a metre.
TEST(RestShape, DoesNotMoveAtAnySizeAndGravity) {
  ASSERT_GT(moved_in_a_second(slack_rope()), 0.3);
  for (const double size : {0.01, 1.0, 100.0}) {
    for (const Vec2 under : {Vec2{0.0, -9.81}, Vec2{0.0, -0.05}, Vec2{3.0, 9.81}, Vec2{}}) {
      CordDef def = slack_rope(size);
      lay_at_rest(def, under);
      EXPECT_LT(moved_in_a_second(def, under), 1e-6 * def.length) << size << " " << under.y;
    }
  }
}

/// From a horizontal line it falls to a vertical one, through large rotations.
TEST(RestShape, OfARopeWithOnePinHangsDown) {
  CordDef def;
  def.points = 41;
  lay_along(def, {{0.0, 0.0}, {6.0, 0.0}});
  def.pins = {0};
  lay_at_rest(def, gravity);
  EXPECT_LT(length(def.positions.back() - Vec2{0.0, -6.0}), 6e-6);
}

/// A trampoline, whose cells are stretched by its own weight alone.
TEST(RestShape, OfARibbonDoesNotMove) {
  CordDef def;
  def.points = 33;
  def.rows = 2;
  def.width = 0.3;
  lay_along(def, {{0.0, 0.0}, {9.6, 0.0}});
  def.mass_per_length = 1.25;
  def.stretch_stiffness = 6e4;
  def.bending_stiffness = 5.0;
  def.pins = {0, 1, 64, 65};
  ASSERT_GT(moved_in_a_second(def), 0.1);
  lay_at_rest(def, gravity);
  EXPECT_LT(moved_in_a_second(def), 1e-6 * def.length);
}

TEST(RestShape, RefusesWhatDoesNotHang) {
  const auto refused = [](CordDef def, Vec2 under) {
    const CordDef before = def;
    std::string words = refusal<DefinitionError>([&] { lay_at_rest(def, under); });
    EXPECT_EQ(def, before);
    return words;
  };
  CordDef loose = slack_rope();
  loose.pins.clear();
  EXPECT_EQ(refused(loose, gravity), "pins are empty; accepted is a cord that hangs from one point or more");
  CordDef nowhere;
  nowhere.pins = {0};
  EXPECT_EQ(refused(nowhere, gravity), "positions are empty; accepted are those of lay_along, or others");
  CordDef wrong = slack_rope();
  wrong.length = -1.0;
  EXPECT_FALSE(refused(wrong, gravity).empty());
  EXPECT_FALSE(refused(slack_rope(), {0.0, std::numeric_limits<double>::quiet_NaN()}).empty());
}

}  // namespace
}  // namespace ribbon
