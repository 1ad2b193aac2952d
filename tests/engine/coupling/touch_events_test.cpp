#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/engine/coupling/grip_world.h"

// Events of contacts with a cord that begin and end.

namespace engine {
namespace {

/// A ball above a taut cord.
struct FallingBall : GripWorld {
  explicit FallingBall(double height = 0.2) {
    coupling.add(Cord(taut()));
    ball = add_body({1.0, height}, 2.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
  }
  void fall_on_cord() {
    for (int k = 0; k < 60 && coupling.last_step().touch_events().empty(); ++k) tick();
    ASSERT_EQ(coupling.last_step().touch_events().size(), 1U);
  }
  b2Body* ball;
};

/// The begin event has the impulse that stops the ball; the end event follows when the ball is away.
TEST(TouchEvents, ReportTheBeginAndTheEndOfAContact) {
  FallingBall scene(0.6);
  b2Body* ball = scene.ball;
  std::vector<ribbon::box2d::TouchEvent> events;
  for (int k = 0; k < 60; ++k) {
    scene.tick();
    events.insert(events.end(), scene.coupling.last_step().touch_events().begin(),
                  scene.coupling.last_step().touch_events().end());
  }
  ASSERT_FALSE(events.empty());
  EXPECT_TRUE(events[0].begins);
  EXPECT_EQ(events[0].fixture, ball->GetFixtureList());
  EXPECT_GT(events[0].impulse, 0.5);  // some 2 kg at 3 m/s
  EXPECT_LT(events[0].impulse, 10.0);
  EXPECT_NEAR(events[0].point.x, 1.0, 0.05);
  EXPECT_GT(events[0].normal.y, 0.9);
  events.clear();
  ball->SetTransform({1.0F, 5.0F}, 0.0F);
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
  EXPECT_FALSE(scene.coupling.last_step().touch_events()[0].begins);
  EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, ball->GetFixtureList())
      << "far away it is still there";
}

/// If the coupling destroys a body after the tick, its events remain, without the fixture.
TEST(TouchEvents, OfAFixtureThatIsDestroyedAfterTheTickHaveNone) {
  FallingBall scene;
  b2Body* ball = scene.ball;
  scene.fall_on_cord();
  const std::uint64_t number = scene.coupling.cord(0).touching()[0].fixture;
  EXPECT_EQ(scene.coupling.fixture(number), ball->GetFixtureList());
  scene.coupling.destroy(scene.world, *ball);
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
  EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, nullptr);
  EXPECT_EQ(scene.coupling.fixture(number), nullptr);
}

/// If Box2D destroys a fixture, the user can report that, or can look up the fixture in the world.
TEST(TouchEvents, OfAFixtureThatBox2DDestroysAreFoundByNumberOrForgotten) {
  for (const bool forgets : {true, false}) {
    FallingBall scene;
    b2Body* ball = scene.ball;
    scene.fall_on_cord();
    const std::uint64_t number = scene.coupling.last_step().touch_events()[0].number;
    EXPECT_EQ(scene.coupling.fixture(number, scene.world), ball->GetFixtureList());
    if (forgets) scene.coupling.forget(*ball->GetFixtureList());
    ball->DestroyFixture(ball->GetFixtureList());
    EXPECT_EQ(scene.coupling.fixture(number, scene.world), nullptr);
    EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture == nullptr, forgets);
    const ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    ASSERT_EQ(state.events.size(), 1U);
    EXPECT_EQ(state.events[0].fixture, 0U);
    scene.tick();
    ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
    EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, nullptr);
    EXPECT_EQ(scene.coupling.last_step().touch_events()[0].number, 0U);
  }
}

/// A body with two fixtures: a new fixture at the address of a destroyed one is a different one.
TEST(TouchEvents, OfANewFixtureAtTheSameAddressAreItsOwn) {
  GripWorld scene;
  scene.coupling.add(Cord(taut()));
  b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
  b2Fixture* first = ball->GetFixtureList();
  first->SetFilterData(b2Filter());
  b2CircleShape second;
  second.m_radius = 0.01F;
  ball->CreateFixture(&second, 0.0F);
  scene.tick(120);
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  const std::uint64_t number = scene.coupling.cord(0).touching()[0].fixture;
  ASSERT_EQ(scene.coupling.fixture(number, scene.world), first);
  b2CircleShape circle;
  circle.m_radius = 0.2F;
  ball->DestroyFixture(first);
  ASSERT_EQ(ball->CreateFixture(&circle, 10.0F), first) << "Box2D likes to use the same address again";
  EXPECT_EQ(scene.coupling.fixture(number, scene.world), nullptr);
  scene.tick();
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  EXPECT_NE(scene.coupling.cord(0).touching()[0].fixture, number);
}

/// The fixture of a new body at the same address has another number, and its contact begins again.
TEST(TouchEvents, OfANewBodyAtTheSameAddressAreItsOwn) {
  GripWorld scene;
  scene.coupling.add(Cord(taut()));
  b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  scene.add_body({50.0, 0.0}, 1.0);
  scene.tick(120);
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  const std::uint64_t number = scene.coupling.cord(0).touching()[0].fixture;
  const Vec2 place = ribbon::box2d::to_double(ball->GetPosition());
  ball = recreate(scene, ball, place, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  scene.tick();
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  EXPECT_NE(scene.coupling.cord(0).touching()[0].fixture, number);
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 2U);
  EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, nullptr);
  EXPECT_TRUE(scene.coupling.last_step().touch_events()[1].begins);
}

/// A destroyed fixture has only an end event.
TEST(TouchEvents, OfADestroyedFixtureHaveNone) {
  FallingBall scene;
  b2Body* ball = scene.ball;
  scene.fall_on_cord();
  scene.world.DestroyBody(ball);
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().touch_events().size(), 1U);
  EXPECT_FALSE(scene.coupling.last_step().touch_events()[0].begins);
  EXPECT_EQ(scene.coupling.last_step().touch_events()[0].fixture, nullptr);
}

}  // namespace
}  // namespace engine
