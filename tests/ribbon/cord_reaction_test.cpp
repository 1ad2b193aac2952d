#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

// reaction: the forces of pins.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

CordDef rope() {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.mass_per_length = 0.3;
  def.drag = 5.0;
  def.pins = {0};
  return def;
}

CordDef ribbon(int rows, Elements elements) {
  CordDef def = rope();
  def.rows = rows;
  def.elements = elements;
  def.width = 0.1;
  def.stretch_stiffness = 2e3;
  def.bending_stiffness = elements == Elements::cells ? 0.02 : 0.0;
  def.damping = 0.002;
  def.pins = {0, rows - 1};
  return def;
}

struct Case {
  const char* name;
  CordDef def;
};

std::vector<Case> cases() {
  CordDef elastic = rope();
  elastic.stretch_stiffness = 500.0;
  elastic.damping = 0.01;
  CordDef stiff = rope();
  stiff.bending_stiffness = 0.05;
  CordDef squashed = ribbon(3, Elements::cells);
  squashed.area_stiffness = 1.0;
  CordDef balloon = ribbon(2, Elements::cells);
  balloon.gravity_scale = -0.5;
  CordDef between = rope();
  between.pins = {0, 10};
  between.positions = test_support::equally_spaced(11, {}, {0.08, 0.0});
  return {{"inextensible rope", rope()},
          {"elastic rope", elastic},
          {"rope that resists bending", stiff},
          {"rope between two pins", between},
          {"ribbon that rises", balloon},
          {"ribbon of bars", ribbon(3, Elements::bars)},
          {"ribbon of one row of cells", ribbon(2, Elements::cells)},
          {"ribbon of two rows of cells and a spine", ribbon(3, Elements::cells)},
          {"ribbon with area stiffness", squashed}};
}

Vec2 total_reaction(const Cord& cord) {
  Vec2 sum{};
  for (const int pin : cord.def().pins) sum += ribbon::reaction(cord, pin, gravity);
  return sum;
}

Vec2 momentum(const Cord& cord) {
  Vec2 sum{};
  for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
  return sum;
}

TEST(CordReaction, PinsCarryTheWeightOfTheHangingCord) {
  for (const Case& tested : cases()) {
    Cord cord(tested.def);
    cord.attach_mass(cord.size() - 1 - tested.def.rows, 0.5);
    cord.attach_mass(0, 0.2);
    cord.set_load(cord.size() / 2, {0.4, -0.3});
    for (int k = 0; k < 1800; ++k) cord.step(dt, gravity);
    const double mass = tested.def.mass_per_length * tested.def.length + 0.7;
    const double weight = mass * 9.81 * tested.def.gravity_scale;
    const Vec2 sum = total_reaction(cord);
    EXPECT_NEAR(sum.x, -0.4, 1e-3 * std::abs(weight)) << tested.name;
    EXPECT_NEAR(sum.y, weight + 0.3, 1e-3 * std::abs(weight)) << tested.name;
  }
}

/// In a swing the momentum changes by the impulses of gravity and of the pins. Reactions are those at the end of a
/// step, so the impulse is their trapezoidal sum.
TEST(CordReaction, IsTheChangeOfMomentumOfASwing) {
  for (Case& tested : cases()) {
    if (tested.def.pins.back() == 10) continue;  // does not swing
    tested.def.drag = 0.0;
    Cord cord(tested.def);
    constexpr double small = 1.0 / 960.0;
    const double weight = tested.def.mass_per_length * tested.def.length * 9.81 * std::abs(tested.def.gravity_scale);
    for (int k = 0; k < 48; ++k) cord.step(small, gravity);
    Vec2 impulse{};
    double largest = 0.0;
    const Vec2 start = momentum(cord);
    constexpr int steps = 500;
    for (int k = 0; k < steps; ++k) {
      const Vec2 before = total_reaction(cord);
      cord.step(small, gravity);
      const Vec2 after = total_reaction(cord);
      impulse += (0.5 * small) * (before + after);
      largest = std::max(largest, length(after));
    }
    const Vec2 gained = momentum(cord) - start;
    double mass = 0.0;
    for (int p = 0; p < cord.size(); ++p) mass += cord.mass(p);
    const Vec2 expected = gained - (steps * small * mass * tested.def.gravity_scale) * gravity;
    EXPECT_NEAR(length(impulse - expected), 0.0, 0.01 * weight * steps * small) << tested.name;
    EXPECT_GT(largest, 1.2 * weight) << tested.name;
  }
}

TEST(CordReaction, IsTheSameAsleepAndRestored) {
  CordDef def = rope();
  def.stretch_stiffness = 500.0;
  def.damping = 0.01;
  def.allow_sleep = true;
  def.positions = test_support::equally_spaced(11, {}, {0.0, -0.1});
  Cord cord(def);
  for (int k = 0; k < 1800 && !cord.is_asleep(); ++k) cord.step(dt, gravity);
  ASSERT_TRUE(cord.is_asleep());
  const Vec2 reaction = ribbon::reaction(cord, 0, gravity);
  const double weight = def.mass_per_length * def.length * 9.81;
  EXPECT_NEAR(reaction.y, weight, 1e-2 * weight) << "the rest of the motion may be a little";
  Cord other(def);
  other.restore(cord.save());
  EXPECT_EQ(ribbon::reaction(other, 0, gravity), reaction);
}

TEST(CordReaction, IsZeroAtAFreePoint) {
  Cord cord(rope());
  for (int k = 0; k < 10; ++k) cord.step(dt, gravity);
  EXPECT_EQ(ribbon::reaction(cord, 5, gravity), Vec2{});
  cord.release(0);
  EXPECT_EQ(ribbon::reaction(cord, 0, gravity), Vec2{});
}

TEST(CordReaction, IncludesTheDragOfAPointThatIsMoved) {
  CordDef def = rope();
  def.points = 2;
  def.pins = {};
  Cord cord(def);
  for (int k = 1; k <= 600; ++k) {
    const double x = 0.5 * dt * k;
    cord.operate(0, {x, 0.0});
    cord.operate(1, {x + 1.0, 0.0});
    cord.step(dt, {});
  }
  const double mass = def.mass_per_length * def.length;
  EXPECT_NEAR(ribbon::reaction(cord, 0, {}).x + ribbon::reaction(cord, 1, {}).x, def.drag * mass * 0.5, 1e-9);
}

TEST(CordReaction, AnUnknownPointIsRefused) {
  const Cord cord(rope());
  EXPECT_THROW((void)ribbon::reaction(cord, -1, gravity), DefinitionError);
  EXPECT_THROW((void)ribbon::reaction(cord, 11, gravity), DefinitionError);
}

}  // namespace
}  // namespace ribbon
