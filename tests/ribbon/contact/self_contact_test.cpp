#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "ribbon/direct_solver.h"
#include "tests/support/constants.h"
#include "tests/support/contact_figures.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"

// Cords of the direct solver against themselves and each other.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
using std::numbers::pi;
using test_support::ContactWorld;

/// Four turns of a rope around the origin, with a pitch of 3 cm.
CordDef wound_rope(int points) {
  CordDef def;
  def.points = points;
  def.radius = 0.008;
  def.friction = 0.3;
  def.self_contact = true;
  def.length = 4.0;
  const double link = def.length / (points - 1);
  double turned = 0.0;
  double out = 0.13;
  for (int i = 0; i < points; ++i) {
    def.positions.push_back({out * std::cos(turned), out * std::sin(turned)});
    double step = link / out;
    for (int k = 0; k < 20; ++k) {
      const double further = out + 0.03 * step / (2.0 * pi);
      const Vec2 next{further * std::cos(turned + step), further * std::sin(turned + step)};
      step *= link / length(next - def.positions.back());
    }
    turned += step;
    out += 0.03 * step / (2.0 * pi);
  }
  return def;
}

TEST(CordSelfContact, WoundFourTimesAndPulledNeverCrossesItself) {
  CordDef def = wound_rope(61);
  def.pins = {0};
  ContactWorld world(def);
  world.add_peg({}, 0.1, 0.3);
  world.cord.set_load(60, {0.0, -30.0});
  for (int k = 0; k < 240; ++k) {
    world.step();
    ASSERT_EQ(test_support::self_crossings(world.cord.positions(), false), 0) << k;
  }
  EXPECT_LE(world.stretch(), 1e-4);
}

/// Without self-contact the rope crosses itself, and the check detects that.
TEST(CordSelfContact, ActsOnlyIfDeclared) {
  CordDef def = wound_rope(61);
  def.self_contact = false;
  def.pins = {0};
  ContactWorld world(def);
  world.add_peg({}, 0.1, 0.3);
  world.cord.set_load(60, {0.0, -30.0});
  int most = 0;
  for (int k = 0; k < 240; ++k) {
    world.step();
    most = std::max(most, test_support::self_crossings(world.cord.positions(), false));
  }
  EXPECT_GT(most, 0);
}

/// Edges whose rest distance is less than the thickness of the ribbon do not push each other apart: the whole outline
/// moves as without self-contact.
TEST(CordSelfContact, DoesNotChangeARibbonNarrowerThanItsThickness) {
  const auto swing = [](bool self_contact) {
    CordDef def;
    def.points = 11;
    def.rows = 3;
    def.length = 1.0;
    def.width = 0.04;
    def.radius = 0.03;
    def.stretch_stiffness = 1e5;
    def.bending_stiffness = 1.0;
    def.self_contact = self_contact;
    def.pins = {0, 1, 2};
    Cord cord(def);
    for (int k = 0; k < 30; ++k) EXPECT_EQ(cord.step(dt, gravity).unconverged, 0);
    return cord.save().positions;
  };
  const std::vector<Vec2> with = swing(true);
  const std::vector<Vec2> without = swing(false);
  for (std::size_t p = 0; p < with.size(); ++p) EXPECT_LT(length(with[p] - without[p]), 1e-9) << p;
}

TEST(CordSelfContact, DroppedIntoAPileDoesNotCrossItself) {
  CordDef def;
  def.points = 41;
  def.length = 2.0;
  def.radius = 0.01;
  def.friction = 0.4;
  def.drag = 0.5;
  def.self_contact = true;
  for (int i = 0; i < 41; ++i) def.positions.push_back({0.002 * ((i * 7) % 5), 0.1 + 0.05 * i * 0.999});
  ContactWorld world(def);
  world.add_edge(world.add_body({}, 0.0, 0.0), {-5.0, 0.0}, {5.0, 0.0}, 0.01, 0.5);
  for (int k = 0; k < 180; ++k) {
    world.step();
    ASSERT_EQ(test_support::self_crossings(world.cord.positions(), false), 0) << k;
  }
  for (const Vec2 x : world.cord.positions()) EXPECT_GT(x.y, 0.019);
}

/// A rope falls on another one that hangs between pins, and stays on it. With the flag on one of them only, it falls
/// through.
TEST(CordContactWithCords, ActsOnlyIfBothDeclareIt) {
  for (const bool both : {true, false}) {
    CordDef below;
    below.points = 21;
    below.length = 2.1;
    below.radius = 0.02;
    below.friction = 0.5;
    below.cord_contact = true;
    below.positions = test_support::arc({0.0, 0.0}, {2.0, 0.0}, 20, 0.105);
    below.pins = {0, 20};
    CordDef above;
    above.points = 9;
    above.length = 0.8;
    above.radius = 0.02;
    above.friction = 0.5;
    above.drag = 1.0;
    above.cord_contact = both;
    above.positions = test_support::equally_spaced(9, {0.6, 0.3}, {0.1, 0.0});
    Cord first(below);
    Cord second(above);
    DirectSolver solver;
    std::array<CordReport, 2> reports;
    for (int k = 0; k < 120; ++k) {
      const std::array<IslandCord, 2> cords = {IslandCord{&first, {}, 1}, IslandCord{&second, {}, 2}};
      solver.step(cords, {}, dt, gravity, reports);
    }
    const double lowest = second.positions()[4].y;
    if (both) {
      EXPECT_GT(lowest, -0.6);
      EXPECT_FALSE(first.touches().empty() && second.touches().empty());
    } else {
      EXPECT_LT(lowest, -5.0);
    }
  }
}

/// The momentum that one cord loses, the other one gains.
TEST(CordContactWithCords, ConservesTheirMomentum) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.radius = 0.02;
  def.mass_per_length = 0.5;
  def.friction = 0.3;
  def.cord_contact = true;
  def.positions = test_support::equally_spaced(11, {0.0, 0.0}, {0.1, 0.0});
  Cord still(def);
  for (Vec2& x : def.positions) x = {0.45 + x.y, 0.1 + x.x};
  def.mass_per_length = 2.0;
  Cord flying(def);
  for (int i = 0; i < 11; ++i) flying.set_velocity(i, {0.3, -2.0});
  const auto momentum = [](const Cord& cord) {
    Vec2 sum;
    for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)];
    return sum;
  };
  const Vec2 before = momentum(still) + momentum(flying);
  DirectSolver solver;
  std::array<CordReport, 2> reports;
  for (int k = 0; k < 120; ++k) {
    const std::array<IslandCord, 2> cords = {IslandCord{&still, {}, 1}, IslandCord{&flying, {}, 2}};
    solver.step(cords, {}, dt, {}, reports);
    ASSERT_LE(length(momentum(still) + momentum(flying) - before), 1e-9 * length(before)) << k;
  }
  EXPECT_GT(length(momentum(still)), 0.1);
}

}  // namespace
}  // namespace ribbon
