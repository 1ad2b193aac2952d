#include "ribbon/tie.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/linear/index.h"
#include "tests/ribbon/tied_cords.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"

// Cords that are tied to each other.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
using test_support::equally_spaced;
using test_support::hanging;
using test_support::refusal;

/// The ends of two pieces of a rope have half a point's mass each, so tied they are that point again.
TEST(TiedCords, OfACutRopeMoveAsTheRope) {
  for (const double stiffness : {std::numeric_limits<double>::infinity(), 2e3}) {
    CordDef def = hanging(21, 2.0);
    def.positions = equally_spaced(21, {0.0, 0.0}, {0.06, -0.08});
    def.stretch_stiffness = stiffness;
    def.accuracy.tolerance = 1e-10;
    def.pins = {0};
    Cord whole(def);
    CutPieces pieces = cut(whole, cut_at(whole, 0.8));
    TiedCords tied;
    tied.cords.push_back(std::move(*pieces.first));
    tied.cords.push_back(std::move(*pieces.second));
    tied.ties = {{0, 8, 1, 0}};
    for (int k = 0; k < 240; ++k) {
      whole.step(dt, gravity);
      tied.step();
      ASSERT_LT(length(whole.positions()[20] - tied.position(1, 12)), 1e-6) << "EA " << stiffness << ", tick " << k;
      ASSERT_EQ(tied.gap(), 0.0) << "tick " << k;
    }
    EXPECT_EQ(tied.solver.islands(), 1);
    EXPECT_EQ(tied.unconverged, 0);
  }
}

TEST(TiedCords, GetOneVelocityThatKeepsTheMomentum) {
  TiedCords tied;
  tied.cords.emplace_back(level_rope({-1.0, 0.0}));
  CordDef heavy = level_rope({0.0, 0.0});
  heavy.mass_per_length = 0.3;
  tied.cords.emplace_back(heavy);
  for (int p = 0; p < 11; ++p) {
    tied.cords[0].set_velocity(p, {2.0, 1.0});
    tied.cords[1].set_velocity(p, {-1.0, 0.0});
  }
  tied.ties = {{0, 10, 1, 0}};
  const Vec2 momentum = tied.momentum();
  const double energy = tied.energy();
  tied.step(30);
  const Vec2 fallen = momentum + (30 * dt * (0.1 + 0.3)) * gravity;
  EXPECT_NEAR(tied.momentum().x, fallen.x, 1e-12);
  EXPECT_NEAR(tied.momentum().y, fallen.y, 1e-12);
  EXPECT_LT(tied.energy(), energy);
  EXPECT_EQ(tied.gap(), 0.0);
  EXPECT_EQ(tied.unconverged, 0);
}

/// Two ropes carry a third with its load. With the forces of the statics of points: the horizontal parts cancel, and
/// the vertical ones carry 50 kg.
TEST(TiedCords, ShareALoadAsStaticsDemands) {
  TiedCords tied;
  CordDef left = level_rope({0.0, 0.0}, 6, 1.0);
  left.mass_per_length = 1e-6;
  left.positions = equally_spaced(6, {0.0, 0.0}, {0.6, -0.8});
  left.pins = {0};
  CordDef right = left;
  right.positions = equally_spaced(6, {6.0, 0.0}, {-0.6, -0.8});
  CordDef below = left;
  below.positions = equally_spaced(6, {3.0, -4.0}, {0.0, -1.0});
  below.pins = {};
  for (const CordDef& def : {left, right, below}) tied.cords.emplace_back(def);
  tied.cords[2].attach_mass(5, 50.0);
  tied.ties = {{0, 5, 1, 5}, {1, 5, 2, 0}};
  tied.step(10);
  const double weight = 50.0 * 9.81;
  for (const int cord : {0, 1}) EXPECT_NEAR(tied.cords[at(cord)].tensions()[2], 0.5 * weight / 0.8, 1e-3 * weight);
  EXPECT_NEAR(tied.cords[2].tensions()[2], weight, 1e-3 * weight);
  EXPECT_NEAR(holding_force(tied.cords[2], 0, gravity).y, weight, 1e-3 * weight);
  EXPECT_LT(tied.strain(), 1e-7);
}

TEST(TiedCords, DoNotStretchUnderALoadOfAMillionTimesTheirMass) {
  TiedCords tied;
  tied.cords.emplace_back(hanging(11, 1.0));
  for (int k = 1; k < 4; ++k) {
    CordDef def = hanging(11, 1.0);
    def.pins = {};
    for (Vec2& x : def.positions) x.y -= k;
    tied.cords.emplace_back(def);
    tied.ties.push_back({k - 1, 10, k, 0});
  }
  tied.cords[3].attach_mass(10, 4e5);
  tied.cords[3].set_velocity(10, {3.0, 0.0});
  tied.step(240);
  EXPECT_LT(tied.strain(), 1e-4);
  EXPECT_EQ(tied.gap(), 0.0);
  EXPECT_EQ(tied.unconverged, 0);
}

/// A net that hangs by its upper corners falls into its shape, with a load in its middle.
TEST(TiedCords, OfANetKeepTheirLengths) {
  constexpr int n = 8;
  constexpr double mesh = 0.2;
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced()}) {
    TiedCords net;
    for (int k = 0; k < 2 * n; ++k) {
      CordDef def;
      def.points = n;
      def.length = mesh * (n - 1);
      def.accuracy = accuracy;
      def.positions = k < n ? equally_spaced(n, {0.0, -mesh * k}, {mesh, 0.0})
                            : equally_spaced(n, {mesh * (k - n), 0.0}, {0.0, -mesh});
      if (k == 0) def.pins = {0, n - 1};
      net.cords.emplace_back(def);
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) net.ties.push_back({i, j, n + j, i});
    }
    net.cords[n / 2].attach_mass(n / 2, 20.0);
    net.step(300);
    EXPECT_LT(net.strain(), 1e-4);
    EXPECT_EQ(net.gap(), 0.0);
    EXPECT_EQ(net.unconverged, 0);
  }
}

TEST(TiedCords, FollowAPointThatIsPinnedDraggedOrHeld) {
  TiedCords tied;
  tied.cords.emplace_back(hanging(11, 1.0));
  CordDef def = hanging(11, 1.0);
  def.pins = {};
  for (Vec2& x : def.positions) x.y -= 1.0;
  tied.cords.emplace_back(def);
  tied.ties = {{0, 10, 1, 0}};
  tied.cords[1].constrain(0, {0.2, -0.8});
  tied.step(30);
  EXPECT_LT(length(tied.position(0, 10) - Vec2{0.2, -0.8}), 1e-9) << "pinned";
  tied.cords[1].release(0);
  for (int k = 1; k <= 30; ++k) {
    tied.cords[0].operate(10, {0.2 - 0.01 * k, -0.8});
    tied.step();
    ASSERT_LT(length(tied.position(1, 0) - Vec2{0.2 - 0.01 * k, -0.8}), 1e-9) << "dragged, tick " << k;
  }
  tied.cords[0].release(10);
  std::vector<RigidBody> bodies(1);
  bodies[0].position = tied.position(0, 10);
  const Grip hand{10, 0, {}};
  tied.step(30, bodies, {&hand, 1});
  EXPECT_LT(length(tied.position(1, 0) - bodies[0].position), 1e-9) << "held";
  EXPECT_LT(tied.gap(), 1e-9);
  EXPECT_EQ(tied.unconverged, 0);
}

/// Where they cross they lie in each other, nearer than the sum of their radii.
TEST(TiedCords, ThatCollideDoNotTouchAtTheTie) {
  TiedCords tied;
  CordDef def = hanging(21, 2.0);
  def.radius = 0.04;
  def.cord_contact = true;
  tied.cords.emplace_back(def);
  def = level_rope({-1.0, -1.0}, 21);
  def.radius = 0.04;
  def.cord_contact = true;
  def.pins = {0, 20};
  tied.cords.emplace_back(def);
  tied.ties = {{0, 10, 1, 10}};
  tied.step(60);
  EXPECT_LT(length(tied.position(0, 20) - Vec2{0.0, -2.0}), 1e-3);
  EXPECT_TRUE(tied.cords[0].touches().empty());
  EXPECT_TRUE(tied.cords[1].touches().empty());
  tied.ties.clear();
  for (Cord& cord : tied.cords) cord.wake();
  tied.step();
  EXPECT_FALSE(tied.cords[0].touches().empty() && tied.cords[1].touches().empty()) << "the test would see contacts";
}

/// The stiffness of contacts follows from the masses that press: here those of loads on other cords.
TEST(TiedCords, PressAgainstAPegWithAllThatHangsOnThem) {
  constexpr double reach = 0.3;  // m, from the middle of the peg to that of the cord
  TiedCords tied;
  CordDef over;
  over.points = 13;
  over.radius = 0.01;
  over.mass_per_length = 0.05;
  over.length = 0.0;
  for (int i = 0; i < over.points; ++i) {
    const double angle = std::numbers::pi * (1.0 - i / 12.0);
    over.positions.push_back({reach * std::cos(angle), reach * std::sin(angle)});
    if (i > 0) over.length += length(over.positions[at(i)] - over.positions[at(i - 1)]);
  }
  tied.cords.emplace_back(over);
  for (const double x : {-reach, reach}) {
    CordDef def = hanging(6, 1.0);
    def.pins = {};
    def.mass_per_length = 0.05;
    for (Vec2& p : def.positions) p.x += x;
    tied.cords.emplace_back(def);
    tied.cords.back().attach_mass(5, 500.0);
  }
  tied.ties = {{0, 0, 1, 0}, {0, 12, 2, 0}};
  std::vector<RigidBody> bodies(1);
  RigidCircle peg;
  peg.radius = reach - over.radius;
  std::vector<IslandCord> list;
  for (std::size_t k = 0; k < 3; ++k) list.push_back({&tied.cords[k], {bodies, {&peg, 1}}, k + 1});
  tied.reports.resize(3);
  double nearest = reach;
  for (int k = 0; k < 120; ++k) {
    tied.solver.step(list, bodies, dt, gravity, tied.reports, tied.ties);
    for (const Vec2 x : tied.cords[0].positions()) nearest = std::min(nearest, length(x));
  }
  EXPECT_GT(nearest, reach * std::cos(std::numbers::pi / 24.0) - 1e-3);
  EXPECT_LT(tied.strain(), 1e-3);
}

TEST(TiedCords, SleepAndWakeTogether) {
  TiedCords tied;
  CordDef def = hanging(11, 1.0);
  def.allow_sleep = true;
  tied.cords.emplace_back(def);
  def.pins = {};
  for (Vec2& x : def.positions) x.y -= 1.0;
  tied.cords.emplace_back(def);
  tied.ties = {{0, 10, 1, 0}};
  tied.step(120);
  ASSERT_TRUE(tied.cords[0].is_asleep() && tied.cords[1].is_asleep());
  tied.cords[1].wake();
  tied.step();
  EXPECT_FALSE(tied.cords[0].is_asleep());
}

TEST(TiedCords, AllocateNothingInASteadyTick) {
  TiedCords tied;
  for (int k = 0; k < 3; ++k) tied.cords.emplace_back(level_rope({1.0 * k, 0.0}));
  tied.cords[0].constrain(0, {0.0, 0.0});
  tied.ties = {{0, 10, 1, 0}, {1, 10, 2, 0}};
  tied.step(10);
  std::vector<IslandCord> list;
  for (std::size_t k = 0; k < 3; ++k) list.push_back({&tied.cords[k], {}, k + 1});
  const test_support::AllocationCount allocations;
  for (int k = 0; k < 60; ++k) tied.solver.step(list, {}, dt, gravity, tied.reports, tied.ties);
  EXPECT_EQ(allocations.so_far(), 0);
}

TEST(TiedCords, OfSeveralIslandsAreSolvedApart) {
  TiedCords tied;
  for (const double x : {0.0, 5.0, 10.0, 1.0, 6.0, 11.0}) tied.cords.emplace_back(level_rope({x, 0.0}));
  for (int k = 0; k < 3; ++k) tied.ties.push_back({5 - k, 0, 2 - k, 10});
  tied.step(20);
  EXPECT_EQ(tied.solver.islands(), 3);
  EXPECT_EQ(tied.gap(), 0.0);
}

TEST(Ties, ThatCannotBeAreRefused) {
  const std::vector<int> points{11, 5, 7};
  const auto refused = [&](std::vector<Tie> ties) {
    return refusal<DefinitionError>([&] { check_ties(ties, points); });
  };
  EXPECT_EQ(refused({{0, 0, 3, 0}}), "tie.other_cord is 3; accepted is 0 to 2");
  EXPECT_EQ(refused({{0, -1, 1, 0}}), "tie.point is -1; accepted is 0 to 10");
  EXPECT_EQ(refused({{0, 0, 1, 5}}), "tie.other_point is 5; accepted is 0 to 4");
  EXPECT_EQ(refused({{1, 0, 1, 4}}), "ties make points 0 and 4 of cord 1 one; accepted are ties of different cords");
  EXPECT_EQ(refused({{0, 1, 1, 0}, {1, 0, 2, 3}, {2, 3, 0, 9}}),
            "ties make points 1 and 9 of cord 0 one; accepted are ties of different cords");
  EXPECT_EQ(refused({{0, 1, 1, 0}, {1, 0, 2, 3}, {2, 3, 0, 1}}), "no error");

  TiedCords tied;
  tied.cords.emplace_back(hanging(11, 1.0));
  tied.ties = {{0, 0, 0, 10}};
  const Cord::State before = tied.cords[0].save();
  EXPECT_THROW(tied.step(), DefinitionError);
  EXPECT_EQ(tied.cords[0].save(), before);
}

}  // namespace
}  // namespace ribbon
