#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "ribbon/cord.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"

// A cord of the direct solver against circles and edges: rest, edges, momentum, ribbons, state.

namespace ribbon {
namespace {

using constants::infinity;
using test_support::bridge_def;
using test_support::bridge_mass;
using test_support::ContactWorld;
using test_support::copy;
using test_support::max_distance;

class CordBridge : public testing::TestWithParam<double> {};

/// Steps a bridge, with its bodies damped, until it is in equilibrium.
void settle(ContactWorld& world, int ticks) {
  for (int k = 0; k < ticks; ++k) {
    world.step();
    for (RigidBody& body : world.bodies) {
      body.velocity = 0.9 * body.velocity;
      body.angular_velocity *= 0.9;
    }
  }
}

TEST_P(CordBridge, ABallRestsOnItWithoutDriftOrJitter) {
  const double mass = GetParam() * bridge_mass;
  CordDef def = bridge_def();
  def.drag = 5.0;
  def.accuracy.tolerance = 1e-9;
  ContactWorld settled(def);
  settled.add_ball(def.positions[20] + Vec2{0.0, 0.28}, 0.25, mass, 0.5);
  settle(settled, 1800);

  def.drag = 0.0;
  def.accuracy = {};
  def.positions = copy(settled.cord.positions());
  ContactWorld world(def);
  world.add_ball(settled.body(0).position, 0.25, mass, 0.5);
  const Vec2 start = world.body(0).position;
  const std::vector<Vec2> shape = copy(world.cord.positions());
  double drift = 0.0;
  double jitter = 0.0;
  double depth = 0.0;
  for (int k = 0; k < 600; ++k) {
    const Vec2 before = world.body(0).position;
    world.step();
    jitter = std::max(jitter, length(world.body(0).position - before));
    drift = std::max({drift, length(world.body(0).position - start), max_distance(shape, world.cord.positions())});
    depth = std::max(depth, world.depth());
  }
  EXPECT_LE(drift, 1e-4);
  EXPECT_LE(jitter, 1e-4);
  EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3);
  EXPECT_GT(depth, 0.0);  // the cord carries the ball
  EXPECT_EQ(world.total.unconverged, 0);
  RecordProperty("drift", std::to_string(drift));
  RecordProperty("depth", std::to_string(depth));
}

INSTANTIATE_TEST_SUITE_P(MassRatios, CordBridge, testing::Values(0.01, 0.1, 1.0, 10.0, 100.0));

/// A cord of 50 points falls over 20 circles in a valley, and comes to rest on them.
/// A body near a cord falls as any other one.
TEST(CordContact, LeavesABallThatDoesNotTouchItAlone) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    CordDef def = bridge_def();
    def.accuracy = accuracy;
    ContactWorld world(def);
    world.add_ball(def.positions[20] + Vec2{0.0, 0.28}, 0.25, 1.0, 0.5);
    world.body(0).velocity = {0.3, 0.5};
    int solved = 0;  // with the cord
    for (int k = 1; k <= 6; ++k) {
      world.step();
      solved += world.body(0).solved ? 1 : 0;
      EXPECT_LE(length(world.body(0).velocity - Vec2{0.3, 0.5 - 9.81 * k * world.dt}), 1e-12) << k;
    }
    EXPECT_GE(solved, 3);
    EXPECT_TRUE(world.cord.touches().empty());
  }
}

/// Also of a contact that begins and ends within a step.
TEST(CordContact, ReportsWhereABallWasHit) {
  int parted = 0;
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    CordDef def = bridge_def();
    def.accuracy = accuracy;
    for (const double mass : {0.01, 0.1, 1.0}) {
      ContactWorld world(def);
      world.add_ball(def.positions[20] + Vec2{0.0, 0.5}, 0.25, mass, 0.5);
      world.circles[0].restitution = 0.8;
      for (int k = 0; k < 120; ++k) {
        world.step();
        for (const Touch& touch : world.cord.touches()) {
          parted += touch.force == 0.0 ? 1 : 0;
          EXPECT_NEAR(length(touch.normal), 1.0, 1e-12);
          EXPECT_NEAR(length(touch.point - world.body(0).position), 0.25, 0.1) << k;
        }
      }
    }
  }
  EXPECT_GT(parted, 0) << "no contact began and ended within a step";
}

TEST(CordContact, ComesToRestOverTwentyCircles) {
  CordDef def;
  def.points = 50;
  def.length = 5.0;
  def.radius = 0.01;
  def.drag = 2.0;
  for (int i = 0; i < 50; ++i) def.positions.push_back({-2.5 + 5.0 * i / 49, 1.6});
  for (const double friction : {0.0, 0.4}) {
    def.friction = friction;
    ContactWorld world(def);
    for (int k = 0; k < 20; ++k) {
      const double x = -2.9 + 5.8 * k / 19;
      world.add_peg({x, 0.15 * x * x + (k % 2 == 0 ? 0.05 : 0.0)}, 0.17, 0.4);
    }
    double depth = 0.0;
    for (int k = 0; k < 1200; ++k) {
      world.step();
      depth = std::max(depth, world.depth());
    }
    double drift = 0.0;
    for (int k = 0; k < 60; ++k) {
      const std::vector<Vec2> before = copy(world.cord.positions());
      world.step();
      drift = std::max(drift, max_distance(before, world.cord.positions()));
    }
    EXPECT_LE(drift, 1e-6) << friction;
    EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3) << friction;
    EXPECT_EQ(world.total.unconverged, 0) << friction;
    EXPECT_GE(world.cord.touches().size(), 6U);
  }
}

TEST(CordContact, IsPushedByAKinematicCircle) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.radius = 0.02;
  def.pins = {0};
  def.positions = test_support::equally_spaced(41, {0.0, 0.0}, {0.0, -0.1});
  ContactWorld world(def);
  const int pusher = world.add_peg({-0.5, -2.0}, 0.2, 0.3);
  world.body(pusher).velocity = {1.0, 0.0};
  double depth = 0.0;
  for (int k = 0; k < 90; ++k) {
    world.step();
    depth = std::max(depth, world.depth());
  }
  EXPECT_GT(world.cord.positions()[20].x, 1.0);
  EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3);
  EXPECT_EQ(world.total.unconverged, 0);
}

TEST(CordContact, RestsOnFlatGroundAtItsRadius) {
  for (const double edge_radius : {0.0, 0.01}) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.drag = 1.0;
    def.positions = test_support::equally_spaced(21, {0.0, 0.3}, {0.1, 0.01});
    def.length = 20 * length(def.positions[1] - def.positions[0]);
    ContactWorld world(def);
    world.add_edge(world.add_body({}, 0.0, 0.0), {-5.0, 0.0}, {5.0, 0.0}, edge_radius, 0.5);
    for (int k = 0; k < 300; ++k) world.step();
    for (const Vec2 x : world.cord.positions()) EXPECT_NEAR(x.y, def.radius + edge_radius, 1e-4);
    EXPECT_EQ(world.total.unconverged, 0);
  }
}

/// A cord between a heavy body and the ground carries the weight of the body too.
TEST(CordContact, IsNotPushedIntoTheGroundByAHeavyBall) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.radius = 0.02;
  def.mass_per_length = 0.05;
  def.friction = 0.5;
  def.positions = test_support::equally_spaced(21, {0.0, 0.02}, {0.1, 0.0});
  ContactWorld world(def);
  world.add_edge(world.add_body({}, 0.0, 0.0), {-5.0, 0.0}, {5.0, 0.0}, 0.0, 0.5);
  const int ball = world.add_ball({1.0, 0.39}, 0.25, 1000.0, 0.5);
  for (int k = 0; k < 60; ++k) {
    world.step();
    for (const Vec2 x : world.cord.positions()) ASSERT_GT(x.y, 0.02 - 1e-3) << "tick " << k;
  }
  EXPECT_EQ(world.total.unconverged, 0);
  EXPECT_NEAR(world.body(ball).position.y, 0.29, 1e-4);
}

/// The cord keeps its radius at the sharp corner of a box that is static, and of one that rises.
TEST(CordContact, HangsOverACornerWithoutTunnelling) {
  for (const double speed : {0.0, 0.3}) {
    CordDef def;
    def.points = 41;
    def.length = 4.0;
    def.radius = 0.02;
    def.friction = 0.5;
    def.pins = {0};
    def.positions = test_support::equally_spaced(41, {-0.6, 0.53}, {0.1, 0.0});
    ContactWorld world(def);
    const int box = world.add_body({1.0, 0.0}, 0.0, 0.0);
    world.add_box(box, {1.0, 0.5}, 0.005, 0.5);
    world.body(box).velocity = {0.0, speed};
    double depth = 0.0;
    for (int k = 0; k < 300; ++k) {
      if (k == 60) world.body(box).velocity = {};
      world.step();
      depth = std::max(depth, world.depth());
    }
    EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3) << speed;
    const Vec2 middle = world.body(box).position;
    for (const Vec2 x : world.cord.positions()) {
      EXPECT_FALSE(std::abs(x.x - middle.x) < 1.0 && std::abs(x.y - middle.y) < 0.5) << x.x << " " << x.y;
    }
    EXPECT_LT(world.cord.positions()[40].y, -0.3);  // it hangs
    EXPECT_EQ(world.total.unconverged, 0);
  }
}

TEST(CordContact, ABoxRestsOnABridge) {
  CordDef def = bridge_def();
  def.drag = 5.0;
  def.accuracy.tolerance = 1e-9;
  const auto add_box = [](ContactWorld& world, Vec2 position) {
    constexpr double mass = 3.0;
    world.add_box(world.add_body(position, mass, mass * (0.36 + 0.16) / 12.0), {0.3, 0.2}, 0.005, 0.5);
  };
  ContactWorld settled(def);
  add_box(settled, def.positions[20] + Vec2{0.0, 0.24});
  settle(settled, 1800);
  def.drag = 0.0;
  def.accuracy = {};
  def.positions = copy(settled.cord.positions());
  ContactWorld world(def);
  add_box(world, settled.body(0).position);
  const Vec2 start = world.body(0).position;
  double drift = 0.0;
  double depth = 0.0;
  for (int k = 0; k < 600; ++k) {
    world.step();
    drift = std::max(drift, length(world.body(0).position - start));
    depth = std::max(depth, world.depth());
  }
  EXPECT_LE(drift, 1e-4);
  EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3);
  EXPECT_GT(depth, 0.0);
}

TEST(CordContact, ConservesMomentumWithBallsInFreeFlight) {
  Accuracy accuracy = Accuracy::accurate();
  accuracy.tolerance = 1e-9;
  ContactWorld world = test_support::free_flight(accuracy, 0.0);
  const Vec2 before = world.momentum();
  const double angular = world.angular_momentum();
  int touched = 0;
  for (int k = 0; k < 600; ++k) {
    world.step();
    touched += world.cord.touches().empty() ? 0 : 1;
    ASSERT_LE(length(world.momentum() - before), 1e-9 * length(before)) << k;
    ASSERT_LE(std::abs(world.angular_momentum() / angular - 1.0), 1e-3) << k;
  }
  EXPECT_GT(touched, 50);
}

int inverted_cells(const Cord& cord) {
  const auto x = cord.positions();
  const auto at = [&](int i, int j) { return x[static_cast<std::size_t>(cord.index(i, j))]; };
  int count = 0;
  for (int i = 0; i + 1 < cord.def().points; ++i) {
    for (int j = 0; j + 1 < cord.def().rows; ++j) {
      const std::array<Vec2, 4> corners = {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
      for (std::size_t k = 0; k < 4; ++k) {
        if (cross(corners[(k + 1) % 4] - corners[k], corners[(k + 3) % 4] - corners[k]) <= 0.0) ++count;
      }
    }
  }
  return count;
}

TEST(CordContact, ARibbonDrapedOnCirclesKeepsItsCells) {
  for (const int rows : {2, 3}) {
    CordDef def;
    def.points = 31;
    def.rows = rows;
    def.length = 3.0;
    def.width = 0.1;
    def.radius = 0.01;
    def.mass_per_length = 1.0;
    def.friction = 0.3;
    def.drag = 2.0;
    def.damping = 0.01;
    solid(1e6, 0.3, 0.01, 0.1).apply_to(def);
    for (int i = 0; i < 31; ++i) {
      for (int j = 0; j < rows; ++j) def.positions.push_back({-1.5 + 0.1 * i, 0.6 + 0.1 * j / (rows - 1)});
    }
    ContactWorld world(def);
    for (const Vec2 peg : {Vec2{-1.0, 0.2}, Vec2{-0.2, 0.0}, Vec2{0.9, 0.1}}) world.add_peg(peg, 0.2, 0.5);
    int inverted = 0;
    double depth = 0.0;
    for (int k = 0; k < 600; ++k) {
      world.step();
      inverted += inverted_cells(world.cord);
      depth = std::max(depth, world.depth());
    }
    EXPECT_EQ(inverted, 0) << rows;
    EXPECT_LE(depth, 0.01 * 2.0 * def.radius + 1e-3) << rows;
    EXPECT_GE(world.cord.touches().size(), 3U) << rows;
    EXPECT_EQ(world.total.unconverged, 0) << rows;
  }
}

/// A bridge that a ball falls on, with a peg and an edge underneath.
ContactWorld busy() {
  ContactWorld world(bridge_def());
  world.add_ball({1.7, 0.5}, 0.2, 2.0, 0.5);
  world.add_ball({2.6, 1.0}, 0.15, 0.2, 0.5);
  world.add_peg({2.1, -0.9}, 0.1, 0.5);
  world.add_edge(world.add_body({1.0, -0.8}, 0.0, 0.0), {-0.5, 0.0}, {0.5, 0.1}, 0.01, 0.5);
  return world;
}

TEST(CordContact, AStepAfterTheFirstContactAllocatesNothing) {
  ContactWorld world = busy();
  for (int k = 0; k < 120; ++k) world.step();
  int touching = 0;
  for (int k = 0; k < 300; ++k) {
    const test_support::AllocationCount count;
    world.step();
    ASSERT_EQ(count.so_far(), 0) << k;
    touching += world.cord.touches().empty() ? 0 : 1;
  }
  EXPECT_GT(touching, 50);
}

TEST(CordContact, RestoredDuringContactContinuesWithTheSameBits) {
  ContactWorld world = busy();
  int touching = 0;
  for (int k = 0; k < 120; ++k) {
    touching += world.cord.touches().empty() ? 0 : 1;
    ContactWorld other(world.cord.def());
    other.bodies = world.bodies;
    other.circles = world.circles;
    other.segments = world.segments;
    other.cord.restore(world.cord.save());
    other.step();
    world.step();
    ASSERT_EQ(other.cord.save(), world.cord.save()) << k;
    for (std::size_t b = 0; b < world.bodies.size(); ++b) {
      ASSERT_EQ(other.bodies[b].position, world.bodies[b].position) << k;
      ASSERT_EQ(other.bodies[b].angular_velocity, world.bodies[b].angular_velocity) << k;
    }
  }
  EXPECT_GT(touching, 20);
}

TEST(CordContact, RefusesFrictionAndRestitutionOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1e-9, 10.0 + 1e-9, nan, infinity}) {
    CordDef def;
    def.friction = bad;
    EXPECT_THROW(Cord{def}, DefinitionError) << bad;
  }
  for (const double bad : {-1e-9, 1.0 + 1e-9, nan, infinity}) {
    CordDef def;
    def.restitution = bad;
    EXPECT_THROW(Cord{def}, DefinitionError) << bad;
  }
  CordDef def;
  def.friction = 10.0;
  def.restitution = 1.0;
  EXPECT_NO_THROW(Cord{def});
}

}  // namespace
}  // namespace ribbon
