#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Cords that fall asleep with their bodies: CordDef::allow_sleep.

namespace engine {
namespace {

using ribbon::CordDef;
using ribbon::Vec2;

constexpr int long_enough = 3000;  // ticks

struct SleepyWorld : test_support::ShapeWorld {
  /// Adds a body that may sleep.
  b2Body& ball_of(double mass, Vec2 position) {
    b2Body& body = *add_ball(position, 0.1, mass);
    body.SetSleepingAllowed(true);
    body.SetAngularDamping(2.0F);
    return body;
  }
  bool falls_asleep(ribbon::box2d::CordId index = 0) {
    for (int k = 0; k < long_enough && !coupling.cord(index).direct().is_asleep(); ++k) tick();
    return coupling.cord(index).direct().is_asleep();
  }
};

CordDef rope_def(bool allow_sleep) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.radius = 0.02;
  def.drag = 1.0;
  def.damping = 0.05;
  def.bending_stiffness = 0.05;
  def.stretch_stiffness = 2000.0;
  def.friction = 0.5;
  def.allow_sleep = allow_sleep;
  return def;
}

/// A lamp of 1 kg on a rope that hangs down from the origin.
struct Lamp : SleepyWorld {
  explicit Lamp(bool allow_sleep = true) {
    CordDef def = rope_def(allow_sleep);
    def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
    def.pins = {0};
    coupling.add(ribbon::Cord(def));
    lamp = &ball_of(1.0, {0.0, -2.1});
    grip = coupling.hold(*lamp, {.cord = 0, .arc = 2.0, .local_anchor = {0.0F, 0.1F}});
  }
  b2Body* lamp;
  ribbon::box2d::GripId grip;
};

/// A rope between two pins whose distance is a little less than its length, and a ball in its middle.
struct Hammock : SleepyWorld {
  explicit Hammock(bool allow_sleep = true) {
    CordDef def = rope_def(allow_sleep);
    def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.095, 0.0});
    def.pins = {0, 20};
    coupling.add(ribbon::Cord(def));
    ball = &ball_of(0.3, {0.95, 0.1});
  }
  b2Body* ball;
};

TEST(CouplingSleep, ASleepingLampAndItsRopeDoNotMove) {
  Lamp there;
  ASSERT_TRUE(there.falls_asleep());
  EXPECT_FALSE(there.lamp->IsAwake());
  const b2Vec2 place = there.lamp->GetPosition();
  const auto& x = there.coupling.cord(0).positions();
  const std::vector<Vec2> points(x.begin(), x.end());
  const Vec2 pull = there.coupling.grip(there.grip).state().pull;
  for (int k = 0; k < 600; ++k) {
    there.tick();
    ASSERT_EQ(there.coupling.cord(0).island_report().stages, 0);
  }
  EXPECT_EQ(there.lamp->GetPosition(), place);
  EXPECT_EQ(std::vector<Vec2>(x.begin(), x.end()), points);
  EXPECT_EQ(there.coupling.grip(there.grip).state().pull, pull);
  EXPECT_NEAR(pull.y, 9.81 * static_cast<double>(there.lamp->GetMass()), 0.02 * 9.81);
  EXPECT_LT(length(ribbon::box2d::to_double(there.lamp->GetWorldPoint({0.0F, 0.1F})) - x[20]), 1e-5)
      << "the hand is where it was";
}

/// After a ball hits it, the lamp swings as one that did not sleep.
TEST(CouplingSleep, AnImpactWakesALampAndItSwingsAsIfItHadNotSlept) {
  const auto swing = [](bool allow_sleep) {
    Lamp there(allow_sleep);
    for (int k = 0; k < long_enough; ++k) there.tick();
    EXPECT_EQ(there.lamp->IsAwake(), !allow_sleep);
    b2Body& ball = there.ball_of(0.3, {-1.0, -2.1});
    ball.SetGravityScale(0.0F);
    ball.SetLinearVelocity({5.0F, 0.0F});
    float furthest = 0.0F;
    for (int k = 0; k < 60; ++k) {
      there.tick();
      furthest = std::max(furthest, there.lamp->GetPosition().x);
    }
    EXPECT_FALSE(there.coupling.cord(0).direct().is_asleep());
    return furthest;
  };
  const float awake = swing(false);
  EXPECT_GT(awake, 0.3F);
  EXPECT_NEAR(swing(true), awake, 0.02F * awake);
}

TEST(CouplingSleep, ASleepingBallStaysInContactWithItsRope) {
  Hammock there;
  ASSERT_TRUE(there.falls_asleep());
  EXPECT_FALSE(there.ball->IsAwake());
  for (int k = 0; k < 60; ++k) {
    there.tick();
    ASSERT_TRUE(there.coupling.last_step().touch_events().empty());
    ASSERT_EQ(there.coupling.cord(0).touching().size(), 1U);
    ASSERT_EQ(there.coupling.cord(0).island_report().stages, 0);
  }
  EXPECT_NEAR(there.coupling.cord(0).touching()[0].impulse,
              9.81 * SleepyWorld::dt * static_cast<double>(there.ball->GetMass()), 0.05 * 9.81 * SleepyWorld::dt);
  there.ball->ApplyLinearImpulseToCenter({0.0F, 1.0F}, true);
  there.tick(10);
  EXPECT_GT(there.coupling.cord(0).island_report().stages, 0);
  EXPECT_GT(there.ball->GetPosition().y, 0.0F);
}

/// A body that falls on a sleeping rope wakes it in time: it penetrates no deeper than into a rope that never sleeps.
TEST(CouplingSleep, ABodyThatApproachesWakesARopeInTime) {
  const auto lowest_gap = [](bool allow_sleep) {
    SleepyWorld there;
    CordDef def = rope_def(allow_sleep);
    def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.095, 0.0});
    def.pins = {0, 20};
    there.coupling.add(ribbon::Cord(def));
    there.tick(long_enough);
    EXPECT_EQ(there.coupling.cord(0).direct().is_asleep(), allow_sleep);
    b2Body& ball = there.ball_of(0.3, {0.95, 4.0});
    double least = 1.0;
    for (int k = 0; k < 120; ++k) {
      there.tick();
      const Vec2 center = ribbon::box2d::to_double(ball.GetPosition());
      if (const auto place = there.coupling.nearest_place(center, 10.0)) {
        least = std::min(least, place->distance - 0.12);
      }
    }
    EXPECT_GT(ball.GetPosition().y, -2.0F) << "it is carried";
    return least;
  };
  EXPECT_NEAR(lowest_gap(true), lowest_gap(false), 1e-3);
}

TEST(CouplingSleep, ABodyThatLosesItsCordWakes) {
  const std::vector<std::function<void(SleepyWorld&)>> ways = {
      [](SleepyWorld& there) { there.coupling.cord(0).set_enabled(false); },
      [](SleepyWorld& there) {
        CordDef def = rope_def(true);
        def.positions = test_support::equally_spaced(def.points, {100.0, 0.0}, {0.1, 0.0});
        there.coupling.cord(0).replace(ribbon::Cord(def));
      },
  };
  for (const auto& take_away : ways) {
    Hammock hammock;
    ASSERT_TRUE(hammock.falls_asleep());
    take_away(hammock);
    const ribbon::box2d::Coupling::State state = hammock.coupling.save(hammock.world);
    hammock.coupling.restore(state, hammock.world);
    hammock.tick(60);
    EXPECT_LT(hammock.ball->GetPosition().y, -4.0F);

    Lamp lamp;
    ASSERT_TRUE(lamp.falls_asleep());
    take_away(lamp);
    lamp.tick(60);
    EXPECT_LT(lamp.lamp->GetPosition().y, -6.0F);
  }
  for (const bool by_grip : {true, false}) {
    Lamp lamp;
    ASSERT_TRUE(lamp.falls_asleep());
    by_grip ? lamp.coupling.grip(lamp.grip).release() : lamp.coupling.body(*lamp.lamp).release();
    lamp.tick(60);
    EXPECT_LT(lamp.lamp->GetPosition().y, -6.0F);
  }
}

/// As in Box2D, where the end of a contact wakes both bodies.
TEST(CouplingSleep, ABodyThatNoLongerCollidesWithItWakes) {
  Hammock there;
  ASSERT_TRUE(there.falls_asleep());
  b2Filter none;
  none.maskBits = 0;
  there.ball->GetFixtureList()->SetFilterData(none);
  there.tick(60);
  EXPECT_LT(there.ball->GetPosition().y, -4.0F);
}

TEST(CouplingSleep, AChangeOfTheCordWakesItAndItsBody) {
  Lamp there;
  ASSERT_TRUE(there.falls_asleep());
  const float low = there.lamp->GetPosition().y;
  there.coupling.cord(0).direct().reel(0, 20, 1.0, 1.0);
  there.tick(120);
  EXPECT_NEAR(there.lamp->GetPosition().y, low + 1.0F, 0.05F);
  ASSERT_TRUE(there.falls_asleep());
  there.coupling.grip(there.grip).climb(0.5, 0.5);
  there.tick(120);
  EXPECT_GT(there.lamp->GetPosition().y, low + 1.3F);
}

TEST(CouplingSleep, DoesNotIncludeBodiesThatMayNotSleep) {
  Lamp sleepless;
  sleepless.lamp->SetSleepingAllowed(false);
  EXPECT_FALSE(sleepless.falls_asleep());
  Lamp in_a_world_without;
  in_a_world_without.world.SetAllowSleeping(false);
  EXPECT_FALSE(in_a_world_without.falls_asleep());
  Lamp with_thesis_cord;
  ribbon::ThesisDef thesis;
  thesis.w = 60;
  thesis.pins = {0, 1};
  with_thesis_cord.coupling.add(ribbon::ThesisCord(thesis));
  EXPECT_FALSE(with_thesis_cord.falls_asleep());
  EXPECT_GT(with_thesis_cord.coupling.cord(1).near_count(), 0);
}

}  // namespace
}  // namespace engine
