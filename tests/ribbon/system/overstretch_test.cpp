#include "ribbon/system/overstretch.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "ribbon/cord.h"
#include "tests/support/constants.h"

// Inextensible ropes that something impossible has stretched.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

/// A straight rope of 20 links of 0.1 m, pinned at one end.
CordDef pinned_rope() {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0};
  for (int p = 0; p < def.points; ++p) def.positions.push_back({0.1 * p, 0.0});
  return def;
}

double length_of(const Cord& cord) {
  double sum = 0.0;
  for (std::size_t p = 1; p < cord.positions().size(); ++p) {
    sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  }
  return sum;
}

double highest_speed(const Cord& cord) {
  double highest = 0.0;
  for (const Vec2 v : cord.velocities()) highest = std::max(highest, length(v));
  return highest;
}

/// Drags the free end 20 m away, ten times the rope's length, lets it go and returns the rope.
Cord dragged_away(const CordDef& def) {
  Cord cord(def);
  for (int k = 1; k <= 60; ++k) {
    cord.operate(20, {2.0 + 0.3 * k, 0.0});
    cord.step(dt, gravity);
  }
  cord.release(20);
  return cord;
}

TEST(Overstretch, IsTakenBackByAQuarterOfItInAStep) {
  Cord cord = dragged_away(pinned_rope());
  double before = length_of(cord);
  ASSERT_GT(before, 15.0);
  for (int k = 0; k < 10; ++k) {
    cord.step(dt, gravity);
    EXPECT_NEAR(length_of(cord) - 2.0, 0.75 * (before - 2.0), 1e-3) << "step " << k;
    before = length_of(cord);
  }
  for (int k = 10; k < 60; ++k) cord.step(dt, gravity);
  EXPECT_NEAR(length_of(cord), 2.0, 1e-3);
}

/// The last tick of the drag moves the point at 18 m/s.
TEST(Overstretch, LeavesNoSpeed) {
  Cord cord = dragged_away(pinned_rope());
  for (int k = 1; k <= 60; ++k) {
    cord.step(dt, gravity);
    EXPECT_LE(highest_speed(cord), 18.0 + 9.81 * dt * k + 1e-9) << "step " << k;
  }
}

TEST(Overstretch, BeginsAboveATwentiethOfALink) {
  for (const double strain : {0.04, 0.06}) {
    CordDef def = pinned_rope();
    for (int p = 11; p < def.points; ++p) def.positions[static_cast<std::size_t>(p)].x += 0.1 * strain;
    Cord cord(def);
    EXPECT_NEAR(regained_length(cord.parts()), strain > 0.05 ? 0.25 * 0.1 * strain : 0.0, 1e-15);
    cord.step(dt, {});
    EXPECT_NEAR(length_of(cord) - 2.0, strain > 0.05 ? 0.75 * 0.1 * strain : 0.0, 1e-6);
  }
}

TEST(Overstretch, IsNoneOfWhatMayStretch) {
  CordDef soft = pinned_rope();
  soft.stretch_stiffness = 1e3;
  CordDef ribbon = pinned_rope();
  ribbon.rows = 2;
  ribbon.width = 0.05;
  ribbon.stretch_stiffness = 1e3;
  ribbon.positions.clear();
  for (const CordDef& def : {soft, ribbon}) {
    Cord cord(def);
    cord.operate(cord.size() - 1, {4.0, 0.0});
    cord.step(dt, {});
    EXPECT_EQ(regained_length(cord.parts()), 0.0);
  }
}

/// The rest lengths in a step are those of a winch that pays out what is missing; afterwards they are the cord's own.
TEST(Overstretch, LeavesTheRestLengthsThatReelsSet) {
  Cord cord = dragged_away(pinned_rope());
  cord.reel(0, 20, 1.0, 0.6);
  for (int k = 1; k <= 150; ++k) {
    cord.step(dt, gravity);
    double rest = 0.0;
    for (int link = 0; link < 20; ++link) rest += cord.rest_length(link);
    EXPECT_NEAR(rest, std::max(1.0, 2.0 - 0.01 * k), 1e-12) << "step " << k;
  }
  EXPECT_NEAR(length_of(cord), 1.0, 1e-3);
}

TEST(Overstretch, IsSavedAndRestored) {
  Cord cord = dragged_away(pinned_rope());
  for (int k = 0; k < 3; ++k) cord.step(dt, gravity);
  Cord other(pinned_rope());
  other.restore(cord.save());
  for (int k = 0; k < 30; ++k) {
    cord.step(dt, gravity);
    other.step(dt, gravity);
    ASSERT_TRUE(std::equal(cord.positions().begin(), cord.positions().end(), other.positions().begin())) << k;
  }
}

}  // namespace
}  // namespace ribbon
