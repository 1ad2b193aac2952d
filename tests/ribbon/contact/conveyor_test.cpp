#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/direct_solver.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"

// Surfaces that move along themselves: RigidCircle::tangent_speed.

namespace ribbon {
namespace {

using constants::g;
using test_support::ContactWorld;
std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double thickness = 0.03;  // m, of the rope's axis above the axis of the edge

Accuracy soft(Accuracy accuracy) {
  accuracy.soft_contacts = true;
  return accuracy;
}
const std::vector<Accuracy> all_accuracies{Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate(),
                                           soft(Accuracy::balanced())};

/// A rope of 2 m that lies on a straight belt, in the direction `along`.
struct Belt {
  Belt(double friction, const Accuracy& accuracy, Vec2 direction = {1.0, 0.0}, bool sleeps = false)
      : along(direction), world(def(friction, accuracy, direction, sleeps)) {
    ground = world.add_body(-thickness * perp(along), 0.0, 0.0);
    world.add_edge(ground, -30.0 * along, 60.0 * along, 0.01, friction);
  }
  static CordDef def(double friction, const Accuracy& accuracy, Vec2 along, bool sleeps) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.friction = friction;
    def.accuracy = accuracy;
    def.allow_sleep = sleeps;
    for (int i = 0; i < def.points; ++i) def.positions.push_back(0.1 * i * along);
    return def;
  }
  void run(double speed, int steps) {
    for (RigidSegment& segment : world.segments) segment.tangent_speed = speed;
    for (RigidCircle& circle : world.circles) circle.tangent_speed = speed;
    for (int k = 0; k < steps; ++k) world.step();
  }
  double speed() const { return dot(world.cord.velocities()[10], along); }
  double place() const { return dot(world.cord.positions()[10], along); }

  Vec2 along;
  ContactWorld world;
  int ground;
};

/// It accelerates by μ·g up to the belt's speed v, after v/(μ·g), and by then is v²/(2·μ·g) behind.
TEST(Conveyor, CarriesARopeByCoulombsLaw) {
  constexpr double friction = 0.4;
  for (const Accuracy& accuracy : all_accuracies) {
    for (const double v : {8.0, -8.0}) {
      Belt belt(friction, accuracy);
      belt.run(0.0, 60);
      const double start = belt.place();
      const double duration = std::abs(v) / (friction * g);  // 2.04 s
      const int ticks = static_cast<int>(duration / belt.world.dt);
      belt.run(v, ticks);
      EXPECT_NEAR(belt.speed() / v * duration / (ticks * belt.world.dt), 1.0, 0.01);
      belt.run(v, 2);
      EXPECT_NEAR(belt.speed() / v, 1.0, 0.01) << "not yet reached";
      belt.run(v, 60);
      EXPECT_NEAR(belt.speed(), v, 1e-3);
      const double total = (ticks + 62) * belt.world.dt;
      EXPECT_NEAR((belt.place() - start) / (v * (total - 0.5 * duration)), 1.0, 0.01);
    }
  }
}

/// On a slope of 1 in 2 a belt that runs upwards carries what friction can carry: by g·(μ·cos − sin) up to its speed.
TEST(Conveyor, CarriesARopeUpASlopeIfFrictionSuffices) {
  constexpr Vec2 down{0.89442719099991586, -0.44721359549995793};
  for (const Accuracy& accuracy : all_accuracies) {
    for (const double friction : {0.8, 0.3}) {
      Belt belt(friction, accuracy, down);
      const double acceleration = g * (friction * down.x + down.y);  // upwards
      belt.run(0.0, 60);
      belt.run(-2.0, 6);
      const double before = belt.speed();
      belt.run(-2.0, 24);
      EXPECT_NEAR((before - belt.speed()) / (24 * belt.world.dt * acceleration), 1.0, 0.01) << friction;
      belt.run(-2.0, 90);
      if (friction > 0.5) {
        EXPECT_NEAR(belt.speed(), -2.0, 1e-3);
      } else {
        EXPECT_GT(belt.speed(), 3.0) << "it slides down";
      }
    }
  }
}

/// A belt whose speed grows by a twentieth of what friction can give slips by nothing: at the start of a
/// tick the speed jumps, and the rope follows in a part of it.
TEST(Conveyor, CarriesARopeWithoutSlipWithinTheFrictionCone) {
  for (const Accuracy& accuracy : all_accuracies) {
    Belt belt(0.4, accuracy);
    belt.run(0.0, 60);
    const double start = belt.place();
    double moved = 0.0;
    double v = 0.0;
    for (int k = 0; k < 60; ++k) {
      v += 0.05 * 0.4 * g * belt.world.dt;
      belt.run(v, 1);
      moved += v * belt.world.dt;
    }
    belt.run(v, 60);
    moved += v * 60 * belt.world.dt;
    EXPECT_NEAR(belt.speed(), v, 1e-6);
    EXPECT_NEAR(belt.place() - start, moved, 1e-3);
  }
}

/// A belt acts as the same edge does that moves along itself.
TEST(Conveyor, IsTheSameAsAMovingEdge) {
  for (const Accuracy& accuracy : all_accuracies) {
    Belt belt(0.4, accuracy);
    Belt moved(0.4, accuracy);
    moved.world.body(moved.ground).velocity = {1.5, 0.0};
    for (int k = 0; k < 90; ++k) {
      belt.run(1.5, 1);
      moved.run(0.0, 1);
      ASSERT_NEAR(belt.place(), moved.place(), 1e-6) << k;
    }
    EXPECT_NEAR(belt.speed(), 1.5, 1e-2);
  }
}

/// A round surface that moves along itself acts as a wheel that turns clockwise.
TEST(Conveyor, IsTheSameAsATurningWheel) {
  for (const Accuracy& accuracy : all_accuracies) {
    for (const double radius : {0.3, 3.0}) {  // touched by links, and by points
      const auto make = [&](double speed) {
        CordDef def = Belt::def(0.5, accuracy, {1.0, 0.0}, false);
        for (Vec2& x : def.positions) x += {-0.9, radius + def.radius};  // more on the right
        ContactWorld world(def);
        world.add_peg({0.0, 0.0}, radius, 0.5);
        world.circles[0].tangent_speed = speed;
        return world;
      };
      const double speed = -1.0;
      ContactWorld belt = make(speed);
      ContactWorld wheel = make(0.0);
      wheel.bodies[0].angular_velocity = -speed / (radius + 0.02);
      ContactWorld still = make(0.0);
      for (int k = 0; k < 40; ++k) {
        belt.step();
        wheel.step();
        still.step();
      }
      for (int p = 0; p < belt.cord.size(); ++p) {
        EXPECT_LE(length(belt.cord.positions()[at(p)] - wheel.cord.positions()[at(p)]), 1e-5) << radius << " " << p;
      }
      EXPECT_LT(belt.cord.positions()[10].x, still.cord.positions()[10].x - 0.05);
    }
  }
}

/// Eight ropes, one behind the other, are a heap: with soft contacts its step is linearised once.
struct Heap {
  Heap() {
    for (int k = 0; k < 8; ++k) {
      CordDef def = Belt::def(0.4, Accuracy::fast(), {1.0, 0.0}, false);
      def.cord_contact = true;
      for (Vec2& x : def.positions) x.x += 2.05 * k;
      cords.emplace_back(def);
    }
    bodies[0].position = {0.0, -thickness};
  }
  void step() {
    std::vector<IslandCord> members;
    Surroundings surroundings;
    surroundings.segments = segments;
    for (Cord& cord : cords) members.push_back({&cord, surroundings, 100U + members.size()});
    std::vector<CordReport> reports(cords.size());
    solver.step(members, bodies, 1.0 / 60.0, {0.0, -g}, reports);
  }
  std::vector<Cord> cords;
  std::vector<RigidBody> bodies = std::vector<RigidBody>(1);
  std::vector<RigidSegment> segments{{0, {-10.0, 0.0}, {60.0, 0.0}, 0.01, 0.4, 0.0, 1}};
  DirectSolver solver;
};

TEST(Conveyor, CarriesAHeapThatIsLinearised) {
  Heap belt;
  Heap moved;
  belt.segments[0].tangent_speed = 1.0;
  moved.bodies[0].velocity = {1.0, 0.0};
  for (int k = 0; k < 60; ++k) {
    belt.step();
    moved.step();
    moved.bodies[0].position += (1.0 / 60.0) * moved.bodies[0].velocity;
    ASSERT_EQ(belt.solver.islands(), 1);
    ASSERT_NEAR(belt.cords[3].positions()[10].x, moved.cords[3].positions()[10].x, 1e-4) << k;
  }
  for (const Cord& cord : belt.cords) EXPECT_NEAR(cord.velocities()[10].x, 1.0, 0.01);
}

/// The presets for scenery carry too, to the accuracy of their friction.
TEST(Conveyor, CarriesWithTheFastPreset) {
  Belt belt(0.4, Accuracy::fast());
  belt.run(0.0, 60);
  belt.run(8.0, 122);
  EXPECT_NEAR(belt.speed() / 8.0, 1.0, 0.1);
  belt.run(8.0, 60);
  EXPECT_NEAR(belt.speed(), 8.0, 1e-3);
}

TEST(Conveyor, KeepsARopeAwakeWhileItRuns) {
  Belt belt(0.4, Accuracy::balanced(), {1.0, 0.0}, true);
  belt.world.circles.clear();  // the ends of the edge, which run too
  belt.run(0.001, 200);
  EXPECT_FALSE(belt.world.cord.is_asleep());
  EXPECT_NEAR(belt.speed(), 0.001, 1e-6);
  belt.run(0.0, 200);
  EXPECT_TRUE(belt.world.cord.is_asleep());
  const double before = belt.place();
  belt.run(0.5, 60);
  EXPECT_FALSE(belt.world.cord.is_asleep());
  EXPECT_GT(belt.place(), before + 0.3);
}

/// A belt without friction does nothing, to the last bit.
TEST(Conveyor, NeedsFriction) {
  Belt belt(0.0, Accuracy::balanced());
  Belt still(0.0, Accuracy::balanced());
  belt.run(5.0, 60);
  still.run(0.0, 60);
  EXPECT_NEAR(belt.place(), still.place(), 1e-12);
}

}  // namespace
}  // namespace ribbon
