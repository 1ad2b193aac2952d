#include "ribbon/box2d/world_snapshot.h"

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <vector>

#include "ribbon/definition.h"
#include "tests/engine/coupling/saved_world.h"
#include "tests/support/allocations.h"

// What WorldSnapshot puts back, and what a world does after it. That of cords is tested in
// tests/game/simulation/going_back_test.cpp.

namespace engine::snapshots {
namespace {

using ribbon::box2d::WorldSnapshot;

/// Bodies and touching contacts in the order of the lists of the world, as numbers.
std::vector<float> picture(const b2World& world) {
  std::vector<float> numbers;
  const auto add = [&numbers](std::initializer_list<float> values) { numbers.insert(numbers.end(), values); };
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    add({body->GetPosition().x, body->GetPosition().y, body->GetAngle(), body->GetLinearVelocity().x,
         body->GetLinearVelocity().y, body->GetAngularVelocity(), static_cast<float>(body->GetType()),
         body->IsAwake() ? 1.0F : 0.0F, body->IsEnabled() ? 1.0F : 0.0F});
  }
  for (const b2Contact* contact = world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    if (!contact->IsTouching()) continue;
    const b2Vec2 place = contact->GetFixtureB()->GetBody()->GetPosition();
    const b2Manifold& manifold = *contact->GetManifold();
    add({place.x, place.y, static_cast<float>(manifold.pointCount), contact->GetFriction(), contact->GetRestitution(),
         contact->GetRestitutionThreshold(), contact->GetTangentSpeed()});
    for (int k = 0; k < manifold.pointCount; ++k) {
      const b2ManifoldPoint& point = manifold.points[k];
      add({point.localPoint.x, point.localPoint.y, point.normalImpulse, point.tangentImpulse});
    }
  }
  return numbers;
}

TEST(WorldSnapshot, PutsBodiesAndContactsBack) {
  SavedWorld world;
  b2Body& box = add_box(world.world, {0.0F, 0.7F});
  b2Body& lid = add_box(world.world, {0.1F, 1.8F});
  b2Body& wheel = add_ball(world.world, {4.0F, 0.4F}, {3.0F, 0.0F});
  world.tick(30);
  for (b2Contact* contact = world.world.GetContactList(); contact != nullptr; contact = contact->GetNext()) {
    contact->SetFriction(0.7F);
    contact->SetRestitution(0.1F);
    contact->SetRestitutionThreshold(0.6F);
    contact->SetTangentSpeed(0.5F);
  }
  world.tick();
  const std::vector<float> expected = picture(world.world);
  ASSERT_GT(expected.size(), 4U * 9U + 3U * 11U) << "three contacts touch";
  for (int k = 0; k < back; ++k) {
    world.tick(1, [&] {
      lid.ApplyLinearImpulseToCenter({0.6F, 0.3F}, true);
      if (k == 2) wheel.SetType(b2_kinematicBody);
      if (k == 3) box.SetEnabled(false);
      if (k == 4) wheel.SetAwake(false);
    });
  }
  ASSERT_NE(picture(world.world), expected);
  world.go_back();
  EXPECT_EQ(picture(world.world), expected);
}

/// The contacts of boxes on the floor: the oldest and one in the middle were destroyed since then.
TEST(WorldSnapshot, PutsTheOrderOfContactsBack) {
  SavedWorld world;
  std::vector<b2Body*> boxes;
  for (int k = 0; k < 6; ++k) boxes.push_back(&add_box(world.world, {2.0F * static_cast<float>(k), 0.5F}));
  world.tick(10);
  const std::vector<float> expected = picture(world.world);
  world.tick(back, [&boxes] {
    boxes[0]->SetTransform({-9.0F, 5.0F}, 0.0F);
    boxes[3]->SetTransform({-6.0F, 5.0F}, 0.0F);
  });
  world.go_back();
  EXPECT_EQ(picture(world.world), expected);
}

/// While contacts are created again, a filter of the snapshot is used; then that of the game again, which also decides
/// about pairs that did not collide.
TEST(WorldSnapshot, KeepsTheFilterAndTheListenerOfTheGame) {
  struct Filter : b2ContactFilter {
    bool ShouldCollide(b2Fixture* a, b2Fixture* b) override {
      return a->GetBody()->GetType() == b2_staticBody || b->GetBody()->GetType() == b2_staticBody;
    }
  } filter;
  struct Listener : b2ContactListener {
    void BeginContact(b2Contact*) override { ++calls; }
    void EndContact(b2Contact*) override { ++calls; }
    void PreSolve(b2Contact*, const b2Manifold*) override { ++calls; }
    int calls = 0;
  } listener;
  SavedWorld world;
  world.world.SetContactFilter(&filter);
  world.world.SetContactListener(&listener);
  b2Body& first = add_box(world.world, {0.0F, 0.5F});
  add_box(world.world, {0.3F, 0.5F});
  world.tick(10);
  ASSERT_EQ(world.world.GetContactCount(), 2);
  world.tick(back, [&first] { first.SetTransform({-9.0F, 5.0F}, 0.0F); });
  const int calls = listener.calls;
  ASSERT_GT(calls, 0);
  world.go_back();
  EXPECT_EQ(world.world.GetContactCount(), 2) << "the boxes overlap";
  EXPECT_EQ(listener.calls, calls);
  EXPECT_EQ(world.world.GetContactManager().m_contactFilter, &filter);
  EXPECT_EQ(world.world.GetContactManager().m_contactListener, &listener);
}

/// A game asks b2Contact::IsTouching, and its listener waits for the change of the flag.
TEST(WorldSnapshot, TouchingFlagsAreThoseOfTheLastStep) {
  struct Listener : b2ContactListener {
    void BeginContact(b2Contact*) override { ++begins; }
    int begins = 0;
  } listener;
  SavedWorld world;
  world.world.SetContinuousPhysics(false);
  world.world.SetContactListener(&listener);
  b2Body& ball = add_ball(world.world, {0.0F, 1.3F});
  while (ball.GetPosition().y > 0.4F) world.tick();
  ASSERT_EQ(listener.begins, 0) << "the ball is in the floor, and the next step finds out";
  const int touches = world.ticks;
  world.tick(back);
  ASSERT_EQ(listener.begins, 1);
  world.go_back();
  ASSERT_EQ(world.ticks, touches);
  EXPECT_FALSE(ball.GetContactList()->contact->IsTouching());
  world.tick();
  EXPECT_EQ(listener.begins, 2) << "once in each of the two futures";

  world.tick(back - 1);
  world.at(touches).restore(world.world);
  EXPECT_TRUE(ball.GetContactList()->contact->IsTouching()) << "that of the saved positions, without the tick before";
}

/// A fast ball touches the floor within a step, and is above it at the start of the step.
TEST(WorldSnapshot, PutsTouchingFlagsOfContinuousCollisionBack) {
  SavedWorld world;
  b2Body& ball = add_ball(world.world, {0.0F, 5.0F}, {0.0F, -20.0F});
  const auto touches = [&ball] {
    return ball.GetContactList() != nullptr && ball.GetContactList()->contact->IsTouching();
  };
  while (!touches()) world.tick();
  const std::vector<float> expected = picture(world.world);
  world.tick(back);
  world.go_back();
  EXPECT_TRUE(touches());
  EXPECT_EQ(picture(world.world), expected);
}

/// The game moved a box onto the floor, and no step has found the contact yet. In the other future it got impulses.
TEST(WorldSnapshot, AContactThatWasNotThereStartsWithoutImpulses) {
  SavedWorld world;
  b2Body& box = add_box(world.world, {0.0F, 9.0F});
  world.tick(10);
  box.SetTransform({0.0F, 0.5F}, 0.0F);
  world.tick(back);
  ASSERT_GT(box.GetContactList()->contact->GetManifold()->points[0].normalImpulse, 0.0F);
  world.at(10).restore(world.world);
  EXPECT_EQ(box.GetContactList()->contact->GetManifold()->points[0].normalImpulse, 0.0F);
}

/// A listener, or a step of continuous collision, may disable a contact until it is updated again.
TEST(WorldSnapshot, PutsDisabledContactsBack) {
  SavedWorld world;
  const b2Body& box = add_box(world.world, {0.0F, 0.5F});
  world.tick(10);
  box.GetContactList()->contact->SetEnabled(false);
  WorldSnapshot snapshot;
  snapshot.save(world.world);
  world.tick();
  ASSERT_TRUE(box.GetContactList()->contact->IsEnabled());
  snapshot.restore(world.world);
  EXPECT_FALSE(box.GetContactList()->contact->IsEnabled());
}

TEST(WorldSnapshot, PutsSleepBack) {
  SavedWorld world;
  b2Body& box = add_box(world.world, {0.0F, 0.5F});
  while (box.IsAwake()) world.tick();
  const std::vector<float> asleep = picture(world.world);
  world.tick(back, [&box] { box.ApplyLinearImpulseToCenter({3.0F, 3.0F}, true); });
  ASSERT_TRUE(box.IsAwake());
  world.go_back();
  EXPECT_FALSE(box.IsAwake());
  EXPECT_EQ(picture(world.world), asleep);

  SavedWorld other;
  b2Body& falling = add_box(other.world, {0.0F, 0.9F});
  other.tick(back);
  const std::vector<float> awake = picture(other.world);
  other.tick(back, [&falling] { falling.SetAwake(false); });
  ASSERT_FALSE(falling.IsAwake());
  other.go_back();
  EXPECT_EQ(picture(other.world), awake);
}

/// A world that is built anew has no contacts, and its first solve would start without impulses.
TEST(WorldSnapshot, InAnEqualWorldContinuesWithTheSameBits) {
  const auto build = [](SavedWorld& world) {
    for (int k = 0; k < 4; ++k)
      add_box(world.world, {0.1F * static_cast<float>(k), 0.6F + 1.1F * static_cast<float>(k)});
  };
  SavedWorld world;
  build(world);
  world.tick(40);
  SavedWorld other;
  build(other);
  other.tick();
  world.at(39).restore(other.world, &world.at(38));
  other.world.Step(dt, 8, 3);
  EXPECT_EQ(picture(other.world), picture(world.world));
  for (int k = 0; k < back; ++k) {
    world.tick();
    other.world.Step(dt, 8, 3);
  }
  EXPECT_EQ(picture(other.world), picture(world.world));
}

TEST(WorldSnapshot, OfAnotherWorldIsRefused) {
  SavedWorld world;
  b2Body& box = add_box(world.world, {0.0F, 0.5F});
  world.tick(10);
  b2CircleShape circle;
  circle.m_radius = 0.1F;
  b2Fixture* fixture = box.CreateFixture(&circle, 0.0F);
  const std::vector<float> before = picture(world.world);
  EXPECT_THROW(world.at(9).restore(world.world), ribbon::DefinitionError);
  box.DestroyFixture(fixture);
  b2Body& second = add_ball(world.world, {9.0F, 9.0F});
  EXPECT_THROW(world.at(9).restore(world.world), ribbon::DefinitionError);
  WorldSnapshot with_second;
  with_second.save(world.world);
  EXPECT_THROW(with_second.restore(world.world, &world.at(9)), ribbon::DefinitionError) << "the tick before too";
  world.world.DestroyBody(&second);
  EXPECT_EQ(picture(world.world), before);
  world.at(9).restore(world.world, &world.at(8));
}

TEST(WorldSnapshot, ALockedWorldIsRefused) {
  struct Listener : b2ContactListener {
    void BeginContact(b2Contact*) override {
      EXPECT_THROW(snapshot.save(*world), ribbon::CallError);
      EXPECT_THROW(snapshot.restore(*world), ribbon::CallError);
      ++calls;
    }
    b2World* world = nullptr;
    WorldSnapshot snapshot;
    int calls = 0;
  } listener;
  SavedWorld world;
  add_box(world.world, {0.0F, 0.5F});
  listener.world = &world.world;
  listener.snapshot.save(world.world);
  world.world.SetContactListener(&listener);
  world.tick(5);
  EXPECT_EQ(listener.calls, 1);
}

TEST(WorldSnapshot, AllocatesNothingAgain) {
  SavedWorld world;
  drop_boxes(world, 12);
  world.tick(60);
  world.go_back();
  world.tick(back);
  const test_support::AllocationCount count;
  for (int k = 0; k < 5; ++k) {
    world.go_back();
    for (int t = 0; t < back; ++t) {
      world.at(world.ticks).save(world.world);
      ++world.ticks;
    }
  }
  EXPECT_EQ(count.so_far(), 0);
}

/// No function of the public state can be exact: two worlds have the same public state, and differ later. In one of
/// them the box has been at rest for 20 ticks; in the other its rest was just interrupted.
TEST(WorldSnapshot, CannotBeExactBecauseTheRestTimeIsPrivate) {
  SavedWorld rested;
  SavedWorld woken;
  b2Body& box = add_box(rested.world, {0.0F, 0.5F});
  b2Body& same_box = add_box(woken.world, {0.0F, 0.5F});
  rested.tick(20);
  woken.tick(20);
  same_box.SetAwake(true);
  ASSERT_EQ(picture(rested.world), picture(woken.world));
  rested.tick(15);
  woken.tick(15);
  EXPECT_FALSE(box.IsAwake());
  EXPECT_TRUE(same_box.IsAwake());
}

}  // namespace
}  // namespace engine::snapshots
