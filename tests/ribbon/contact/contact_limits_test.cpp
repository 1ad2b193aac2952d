#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/cord.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"

// Contact of the direct solver: cases that once failed.

namespace ribbon {
namespace {

using std::numbers::pi;
using test_support::ContactWorld;

CordDef elastic_metre() {
  CordDef def;
  def.points = 21;
  def.length = 1.0;
  def.mass_per_length = 0.5;
  def.stretch_stiffness = 1e4;
  return def;
}

/// The direction does not depend on the side of the links that the wheel is on.
TEST(CordContactLimits, ARotatingCirclePullsItByFriction) {
  for (const double friction : {0.0, 0.8}) {
    CordDef def;
    def.points = 61;
    def.length = 3.0;
    def.radius = 0.01;
    def.friction = friction;
    constexpr double reach = 0.51;
    for (int i = 0; i < 61; ++i) {  // over the wheel, both ends hang down
      const double s = 0.05 * (i - 30);
      const double turned = std::clamp(s / reach, -0.5 * pi, 0.5 * pi);
      const double hanging = std::abs(s) - 0.5 * pi * reach;
      def.positions.push_back({reach * std::sin(turned), hanging > 0.0 ? -hanging : reach * std::cos(turned)});
    }
    ContactWorld world(def);
    const int wheel = world.add_peg({}, 0.5, friction);
    for (int k = 0; k < 30; ++k) world.step();
    world.body(wheel).angular_velocity = -1.0;
    const double before = world.cord.positions()[60].y;
    for (int k = 0; k < 30; ++k) world.step();
    const double way = before - world.cord.positions()[60].y;
    if (friction == 0.0) {
      EXPECT_NEAR(way, 0.0, 1e-3);
    } else {
      EXPECT_NEAR(way / (0.5 * reach), 1.0, 0.1);  // it has to accelerate first
    }
    EXPECT_LE(world.depth(), 1e-3);
  }
}

TEST(CordContactLimits, ConservesMomentumToTheDefaultTolerance) {
  for (const Accuracy& accuracy : {Accuracy::balanced(), Accuracy::accurate()}) {
    for (const double friction : {0.0, 0.5}) {
      ContactWorld world = test_support::free_flight(accuracy, friction);
      const Vec2 before = world.momentum();
      const double angular = world.angular_momentum();
      double linear_off = 0.0;
      double angular_off = 0.0;
      for (int k = 0; k < 600; ++k) {
        world.step();
        linear_off = std::max(linear_off, length(world.momentum() - before) / length(before));
        angular_off = std::max(angular_off, std::abs(world.angular_momentum() / angular - 1.0));
      }
      EXPECT_LE(linear_off, 1e-9) << accuracy.substeps << " " << friction;
      EXPECT_LE(angular_off, 1e-3) << accuracy.substeps << " " << friction;
    }
  }
}

TEST(CordContactLimits, AHeavyBallOnATautCordThatDoesNotStretchGainsNoEnergy) {
  for (const double mass : {50.0, 100.0, 1000.0}) {
    CordDef def;
    def.points = 41;
    def.length = 4.2;
    def.radius = 0.02;
    def.friction = 0.5;
    def.pins = {0, 40};
    ContactWorld world(def);
    world.add_ball({1.89, 1.5}, 0.25, mass, 0.5);
    const double before = world.energy();
    double gain = 0.0;
    for (int k = 0; k < 180; ++k) {
      world.step();
      gain = std::max(gain, world.energy() - before);
    }
    EXPECT_LE(gain, 1e-3 * 9.81 * mass * def.length) << mass;
  }
}

/// A ball that was moved into the cord between two steps is depenetrated in the next step without a large velocity. The
/// energy that so stiff a contact could return grows as the substeps get shorter.
TEST(CordContactLimits, APenetratingBallGainsLittleSpeed) {
  for (const int substeps : {1, 4, 64, 256}) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.05;
    def.pins = {0};
    def.accuracy.substeps = substeps;
    ContactWorld world(def);
    world.gravity = {};
    constexpr double in = 1e-3;  // m
    const int ball = world.add_ball({1.05, 0.25 - in}, 0.2, 0.5, 0.0);
    for (int k = 0; k < 3; ++k) {
      world.step();
      EXPECT_LE(length(world.body(ball).velocity), 0.2 * in / world.dt) << substeps;  // the cord is lighter
      EXPECT_LE(world.fastest(), 3.0 * in / world.dt) << substeps;
      EXPECT_LE(world.depth(), 1e-6) << substeps;
    }
    EXPECT_EQ(world.total.unconverged, 0);
  }
}

TEST(CordContactLimits, ASnappingStringDoesNotGoThroughAPeg) {
  for (const int substeps : {1, 4}) {
    CordDef def;
    def.points = 41;
    def.length = 2.0;
    def.radius = 0.02;
    def.stretch_stiffness = 1e4;
    def.pins = {0, 40};
    def.accuracy.substeps = substeps;
    ContactWorld world(def);
    for (int k = 1; k <= 20; ++k) {
      world.cord.operate(20, {1.0, -0.05 * k});
      world.step();
    }
    for (int k = 0; k < 60; ++k) world.step();
    const Vec2 peg{1.03, 0.2};
    world.add_peg(peg, 0.1, 0.0);
    world.cord.release(20);
    for (int k = 0; k < 60; ++k) {
      world.step();
      bool below = true;
      for (std::size_t p = 1; p < world.cord.positions().size(); ++p) {
        const Vec2 a = world.cord.positions()[p - 1];
        const Vec2 b = world.cord.positions()[p];
        if ((a.x <= peg.x) == (b.x <= peg.x)) continue;
        if (a.y + (b.y - a.y) * (peg.x - a.x) / (b.x - a.x) > peg.y) below = !below;
      }
      ASSERT_TRUE(below) << substeps << " " << k;
    }
  }
}

/// A cord that falls flat on the ground, and a ball that falls on a cord that cannot give way, have restitution e.
TEST(CordContactLimits, ImpactsHaveTheirRestitution) {
  for (const double restitution : {0.0, 0.5, 0.9}) {
    for (const double speed : {1.0, 10.0}) {
      for (const bool ball_falls : {false, true}) {
        CordDef def;
        def.points = 11;
        def.length = 1.0;
        def.radius = 0.02;
        def.restitution = restitution;
        def.positions = test_support::equally_spaced(11, {0.0, ball_falls ? 0.0 : 0.2}, {0.1, 0.0});
        if (ball_falls) {
          for (int i = 0; i < 11; ++i) def.pins.push_back(i);
        }
        ContactWorld world(def);
        world.gravity = {};
        if (ball_falls) {
          world.add_ball({0.5, 0.37}, 0.1, 2.0, 0.0);
          world.body(0).velocity = {0.0, -speed};
        } else {
          world.add_edge(world.add_body({}, 0.0, 0.0), {-5.0, 0.0}, {5.0, 0.0}, 0.01, 0.0);
          for (int i = 0; i < 11; ++i) world.cord.set_velocity(i, {0.0, -speed});
        }
        const double before = world.energy();
        double gain = 0.0;
        for (int k = 0; k < 40; ++k) {
          world.step();
          gain = std::max(gain, world.energy() - before);
        }
        const double after = ball_falls ? world.body(0).velocity.y : world.cord.velocities()[5].y;
        EXPECT_NEAR(after / speed, restitution, 0.1) << "e " << restitution << " at " << speed << " " << ball_falls;
        EXPECT_LE(gain, 1e-3 * before);
      }
    }
  }
}

/// Every step of a cord converges that is pulled over a circle by its ends.
TEST(CordContactLimits, ACapstansStepsConverge) {
  constexpr double turn = 2.0 * pi / 32;
  for (const int turned : {16, 32}) {
    CordDef def;
    def.radius = 0.01;
    const double l = 2.0 * 0.51 * std::tan(0.5 * turn);
    def.points = turned + 13;
    def.length = l * (def.points - 1);
    def.friction = 0.3;
    Vec2 x{-5.5 * l, 0.51};
    double heading = 0.0;
    for (int i = 0; i < def.points; ++i) {
      def.positions.push_back(x);
      if (i >= 6 && i < 6 + turned) heading -= turn;
      x += l * Vec2{std::cos(heading), std::sin(heading)};
    }
    ContactWorld world(def);
    world.gravity = {};
    world.add_peg({}, 0.5, 0.3);
    world.cord.set_load(0, {-10.0, 0.0});
    for (int k = 0; k < 1500; ++k) {
      world.cord.set_load(def.points - 1, ((1.0 + k * 1e-3) * 10.0) * Vec2{std::cos(heading), std::sin(heading)});
      world.step();
    }
    EXPECT_EQ(world.total.unconverged, 0) << turned;
  }
}

/// The tolerance for scenery is a fifth of these links: within it a link that turns fast could stretch by a twentieth.
TEST(CordContactLimits, ShortLinksDoNotStretchWithinALargeTolerance) {
  for (const double speed : {0.0, 5.0, 10.0, 20.0}) {
    CordDef def;
    def.points = 41;
    def.length = 2.0;
    def.pins = {0};
    def.accuracy = Accuracy::fast();
    for (int i = 0; i < def.points; ++i) def.positions.push_back({i / 20.0, 0.0});
    ContactWorld world(def);
    const int ball = world.add_ball({0.7, -0.5}, 0.1, 1.0, 0.3);
    world.body(ball).velocity = {0.0, speed};
    world.add_peg({0.4, -0.4}, 0.05, 0.3);
    double most = 0.0;
    for (int k = 0; k < 120; ++k) {
      world.step();
      const auto& x = world.cord.positions();
      for (std::size_t i = 1; i < x.size(); ++i) most = std::max(most, std::abs(20.0 * length(x[i] - x[i - 1]) - 1.0));
    }
    EXPECT_LE(most, 5e-3) << speed;
    EXPECT_EQ(world.total.unconverged, 0) << speed;
  }
}

/// No penetration increases, and a ball that separates is free.
TEST(CordContactLimits, ABallThatStartsWithItsCentreOnACordIsDepenetrated) {
  for (const double along : {0.5, 0.525, 0.51}) {
    for (const double radius : {5e-6, 5e-4, 0.05}) {
      const CordDef def = elastic_metre();
      ContactWorld world(def);
      world.gravity = {};
      const int ball = world.add_ball({along, 0.0}, radius, 0.5, 0.3);
      for (int k = 0; k < 120; ++k) world.step();
      EXPECT_EQ(world.total.unconverged, 0) << along << ", " << radius;
      EXPECT_LT(world.depth(), 0.01 * (radius + def.radius)) << along << ", " << radius;
      EXPECT_LT(length(world.body(ball).velocity), 1.0) << along << ", " << radius;
    }
  }
}

/// Depenetration by a tenth of the depth per step would throw the ball if the steps were as short as that.
TEST(CordContactLimits, DepenetrationIsNoFasterInShortSteps) {
  for (const double dt : {1e-2, 1e-3, 1e-4, 1e-5}) {
    CordDef def;
    def.points = 21;
    def.length = 1.0;
    def.mass_per_length = 0.5;
    ContactWorld world(def);
    world.gravity = {};
    world.dt = dt;
    world.add_ball({0.5, 0.02}, 0.05, 0.5, 0.0);
    double fastest = 0.0;
    for (int k = 0; k < 50; ++k) {
      world.step();
      fastest = std::max(fastest, world.fastest());
    }
    EXPECT_EQ(world.total.unconverged, 0) << dt;
    EXPECT_LT(fastest, 3.0) << dt;
  }
}

/// A straight cord with short links inside a large circle penetrates it at all points. With one contact per minimum of
/// the distance the cord was held in the middle, then in two places, then in more, and thrown.
TEST(CordContactLimits, ACordThatStartsDeepInALargeCircleIsDepenetratedUndamaged) {
  for (const double radius : {0.5, 5.0, 50.0}) {  // 10 links and more
    for (const double depth : {1e-3, 0.05}) {
      const CordDef def = elastic_metre();
      ContactWorld world(def);
      world.gravity = {};
      world.add_peg({0.5, radius + def.radius - depth}, radius, 0.0);
      double fastest = 0.0;
      for (int k = 0; k < 120; ++k) {
        world.step();
        fastest = std::max(fastest, world.fastest());
      }
      EXPECT_EQ(world.total.unconverged, 0) << radius << ", " << depth;
      EXPECT_LT(world.depth(), 1e-3) << radius << ", " << depth;
      EXPECT_LT(fastest, 0.2 + 60.0 * 0.25 * depth) << radius << ", " << depth;  // a quarter of the depth per step
    }
  }
}

/// On a drum with a radius of forty links, a half turn holds e^(μπ) times the weight of the other end.
TEST(CordContactLimits, ALargeDrumHoldsByFrictionLikeASmallOne) {
  const auto slid = [](double ratio) {
    CordDef def;
    def.points = 201;
    def.length = 10.0;
    def.mass_per_length = 0.01;
    def.radius = 0.01;
    def.friction = 0.3;
    constexpr double reach = 2.0;
    for (int i = 0; i < 201; ++i) {
      const double s = 0.05 * (i - 100);
      const double turned = std::clamp(s / reach, -0.5 * pi, 0.5 * pi);
      const double hanging = std::abs(s) - 0.5 * pi * reach;
      const double side = turned < 0.0 ? -reach : reach;
      def.positions.push_back(hanging > 0.0 ? Vec2{side, -hanging}
                                            : Vec2{reach * std::sin(turned), reach * std::cos(turned)});
    }
    ContactWorld world(def);
    world.add_peg({}, reach - def.radius, 0.3);
    world.cord.attach_mass(0, 1.0);
    world.cord.attach_mass(200, ratio);
    const double before = world.cord.positions()[200].y;
    for (int k = 0; k < 60; ++k) world.step();
    return before - world.cord.positions()[200].y;
  };
  const double holds = std::exp(0.3 * pi);  // Euler–Eytelwein
  EXPECT_LT(slid(0.95 * holds), 0.01);
  EXPECT_GT(slid(1.1 * holds), 0.05);
}

/// A ball falls on a bridge. With the limits of four substeps each step of many ends as one linearised step, which is
/// the same whatever their number.
TEST(CordContactLimits, GrowWithTheNumberOfSubsteps) {
  for (const int substeps : {64, 128}) {
    CordDef def = test_support::bridge_def();
    def.accuracy.substeps = substeps;
    def.accuracy.tolerance = 1e-6;
    ContactWorld world(def);
    world.add_ball({0.0, 0.2}, 0.3, 5.0, 0.5);
    for (int k = 0; k < 60; ++k) world.step();
    EXPECT_GT(world.body(0).position.y, -2.0) << "it lies on the bridge: in a free fall it would be at -4.7";
    EXPECT_EQ(world.total.posed, 0) << substeps;
    EXPECT_EQ(world.total.unconverged, 0) << substeps;
  }
}

}  // namespace
}  // namespace ribbon
