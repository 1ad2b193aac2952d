#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/freed_body.h"
#include "tests/support/points.h"

// The ends of grips, refusals, and bodies at the address of a destroyed one.

namespace engine {
namespace {

using ribbon::CallError;
using ribbon::DefinitionError;
using test_support::all_finite;

TEST(Grip, IsReleasedAboveItsStrength) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -5.0}, 70.0);
  const ribbon::box2d::GripId strong =
      scene.coupling.hold(*body, {.cord = 0, .arc = 5.0, .strength = 800.0, .lets_go = true});
  scene.tick(60);
  EXPECT_TRUE(scene.coupling.grip(strong).is_valid());
  body->ApplyLinearImpulseToCenter({0.0F, -400.0F}, true);
  scene.tick(60);
  EXPECT_FALSE(scene.coupling.grip(strong).is_valid());
  EXPECT_LT(body->GetPosition().y, -6.0);
}

TEST(Grip, RefusesInvalidArguments) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -5.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 5.0});
  const auto refuses = [&](const ribbon::box2d::GripDef& def) {
    EXPECT_THROW(scene.coupling.hold(*body, def), DefinitionError);
  };
  const auto refuses_call = [&](const ribbon::box2d::GripDef& def) {
    EXPECT_THROW(scene.coupling.hold(*body, def), CallError);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refuses_call({.cord = 0, .arc = 5.0});  // exists already
  refuses_call({.cord = 0, .point = 25});
  refuses_call({.cord = 1, .arc = 5.0});
  refuses_call({.cord = -1, .arc = 5.0});
  refuses({.cord = 0, .point = 51});
  refuses({.cord = 0, .point = -1});
  refuses({.cord = 0, .arc = 10.01});
  refuses({.cord = 0, .arc = -0.01});
  refuses({.cord = 0, .arc = nan});
  refuses({.cord = 0, .arc = 1.0, .row = 1});
  refuses({.cord = 0, .arc = 1.0, .strength = -1.0});
  refuses({.cord = 0, .arc = 1.0, .strength = nan});
  refuses({.cord = 0, .arc = 1.0, .local_anchor = {static_cast<float>(nan), 0.0F}});
  const ribbon::box2d::CordId thesis = scene.coupling.add(ribbon::ThesisCord(ribbon::ThesisDef{}));
  refuses_call({.cord = thesis, .arc = 1.0});
  refuses_call({.cord = thesis, .strength = 5.0, .point = 0});
  refuses({.cord = thesis, .point = 1000});
  EXPECT_THROW(scene.coupling.grip(grip + 1).climb(3.0, 1.0), CallError);
  EXPECT_THROW(scene.coupling.grip(grip + 1).state(), CallError);
  EXPECT_THROW(scene.coupling.grip(grip + 1).move_anchor(b2Vec2_zero), CallError);
  EXPECT_THROW(scene.coupling.grip(grip).climb(11.0, 1.0), DefinitionError);
  EXPECT_THROW(scene.coupling.grip(grip).climb(3.0, 0.0), DefinitionError);
  scene.coupling.add(ribbon::ThesisCord(ribbon::ThesisDef{}));
  scene.coupling.hold(1, 0, *scene.add_body({}, 1.0), b2Vec2_zero);
  EXPECT_THROW(scene.coupling.grip(grip + 1).climb(0.1, 1.0), CallError);  // the hold's number, of another solver
  scene.coupling.body(*scene.world.GetBodyList()).release();
  EXPECT_FALSE(scene.coupling.grip(grip + 1).release());
  EXPECT_FALSE(scene.coupling.grip(grip + 1).is_valid());
  scene.tick(10);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 5.0, 1e-12);
}

/// A body that is destroyed without a call of the coupling releases its grips; so does one with NaN velocity.
TEST(Grip, EndsWithItsBody) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -5.0}, 70.0);
  b2Body* mad = scene.add_body({0.0, -7.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 5.0});
  const ribbon::box2d::GripId other = scene.coupling.hold(*mad, {.cord = 0, .arc = 7.0});
  scene.tick(5);
  scene.world.DestroyBody(body);
  mad->SetLinearVelocity({std::numeric_limits<float>::quiet_NaN(), 0.0F});
  scene.coupling.gather(scene.world, dt);
  EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
  EXPECT_FALSE(scene.coupling.grip(other).is_valid());
  scene.coupling.step();
  scene.coupling.apply();
  EXPECT_TRUE(all_finite(scene.coupling.cord(0).positions()));
}

/// gather collects the grips of a tick. A grip that is released after that does not pull.
TEST(Grip, EndsInTheMiddleOfATick) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -5.0}, 70.0);
  b2Body* other = scene.add_body({0.0, -7.0}, 70.0);
  scene.coupling.hold(*body, {.cord = 0, .arc = 5.0});
  const ribbon::box2d::GripId grip = scene.coupling.hold(*other, {.cord = 0, .arc = 7.0});
  scene.tick(5);
  scene.coupling.gather(scene.world, dt);
  EXPECT_TRUE(scene.coupling.grip(grip).release());
  scene.coupling.step();
  scene.coupling.destroy(scene.world, *body);
  scene.coupling.apply();
  scene.tick(5);
  EXPECT_TRUE(all_finite(scene.coupling.cord(0).positions()));
  EXPECT_LT(other->GetLinearVelocity().y, 0.0F);
}

/// Between the destruction of a body and the next gather nothing accesses its memory.
TEST(Grip, ReleasedAfterItsBodysEndAccessesNoFreedMemory) {
  const auto end = [](auto&& let_go) {
    GripWorld scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -5.0}, 70.0);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 5.0});
    const ribbon::box2d::GripId other = scene.coupling.hold(*body, {.cord = 0, .arc = 5.5});
    scene.tick(5);
    scene.world.DestroyBody(body);
    {
      const test_support::FreedBody freed(body);
      let_go(scene.coupling, grip, other);
    }
    EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
    scene.tick(5);
    EXPECT_FALSE(scene.coupling.grip(other).is_valid());
  };
  end([](ribbon::box2d::Coupling& coupling, ribbon::box2d::GripId grip, ribbon::box2d::GripId other) {
    EXPECT_TRUE(coupling.grip(grip).release());
    EXPECT_TRUE(coupling.grip(other).release());
  });
  end([](ribbon::box2d::Coupling& coupling, ribbon::box2d::GripId grip, ribbon::box2d::GripId /*other*/) {
    EXPECT_TRUE(coupling.grip(grip).release());
  });
  end([](ribbon::box2d::Coupling& coupling, ribbon::box2d::GripId, ribbon::box2d::GripId) {
    coupling.cord(0).replace(Cord(hanging()));
  });
  end([](ribbon::box2d::Coupling& coupling, ribbon::box2d::GripId, ribbon::box2d::GripId) {
    coupling.cord(0).set_enabled(false);
  });
}

/// In the world's list the body is before one that was created later than the old body. So it is new, and has nothing
/// of the old body.
TEST(Grip, ANewBodyAtTheSameAddressHoldsNothing) {
  const auto after_recreation = [](auto&& ask) {
    GripWorld scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
    scene.add_body({50.0, 0.0}, 1.0);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
    body->SetLinearVelocity({20.0F, 0.0F});
    scene.tick(20);
    ASSERT_GT(length(scene.coupling.body(*body).velocity() - ribbon::box2d::to_double(body->GetLinearVelocity())), 0.1)
        << "carried";
    body = recreate(scene, body, {10.0, 0.0}, 1.0);
    ask(scene, *body, grip);
    EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()), Vec2{});
    scene.tick();
    EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
    EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()).x, 0.0);
    EXPECT_NEAR(ribbon::box2d::to_double(body->GetLinearVelocity()).y, -g * dt, 1e-6);
  };
  after_recreation([](GripWorld&, b2Body&, ribbon::box2d::GripId) {});
  after_recreation([](GripWorld& scene, b2Body& body, ribbon::box2d::GripId) {
    EXPECT_EQ(scene.coupling.body(body).velocity(), Vec2{});
    EXPECT_FALSE(scene.coupling.body(body).held_place());
  });
  after_recreation([](GripWorld& scene, b2Body&, ribbon::box2d::GripId grip) { scene.coupling.grip(grip).release(); });
  after_recreation([](GripWorld& scene, b2Body&, ribbon::box2d::GripId) { scene.coupling.cord(0).set_enabled(false); });
  after_recreation(
      [](GripWorld& scene, b2Body& body, ribbon::box2d::GripId) { EXPECT_FALSE(scene.coupling.body(body).release()); });
  after_recreation([](GripWorld& scene, b2Body&, ribbon::box2d::GripId) {
    const ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    EXPECT_TRUE(state.grips.empty());
    EXPECT_TRUE(state.carries.empty());
  });
}

/// A new body at an old address that takes hold at once has its own grip and no other.
TEST(Grip, ANewBodyAtTheSameAddressCanHold) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  scene.add_body({50.0, 0.0}, 1.0);
  const ribbon::box2d::GripId before = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  scene.tick(5);
  body = recreate(scene, body, {0.0, -9.0}, 70.0);
  ribbon::box2d::GripId after = 0;
  ASSERT_NO_THROW(after = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0}));
  scene.tick(5);
  EXPECT_FALSE(scene.coupling.grip(before).is_valid());
  EXPECT_TRUE(scene.coupling.grip(after).is_valid());
  scene.add_body({50.0, 5.0}, 1.0);
  scene.tick(5);
  body = recreate(scene, body, {0.0, -5.0}, 70.0);
  scene.coupling.hold(0, 25, *body, b2Vec2_zero);
  scene.tick(5);
  EXPECT_FALSE(scene.coupling.grip(after).is_valid());
  ASSERT_TRUE(scene.coupling.body(*body).held_place());
  EXPECT_EQ(scene.coupling.body(*body).held_place()->point, 25);
}

/// A user's destruction listener reports what the order of the world's list cannot show: that the newest body is new.
TEST(Grip, EndsWhenAListenerReportsTheEndOfItsBody) {
  struct Listener : b2DestructionListener {
    void SayGoodbye(b2Joint* /*joint*/) override {}
    void SayGoodbye(b2Fixture* fixture) override { coupling->forget(*fixture->GetBody()); }
    ribbon::box2d::Coupling* coupling = nullptr;
  };
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  body->SetLinearVelocity({20.0F, 0.0F});
  scene.tick(20);
  Listener listener;
  listener.coupling = &scene.coupling;
  scene.world.SetDestructionListener(&listener);
  body = recreate(scene, body, {10.0, 0.0}, 1.0);
  EXPECT_FALSE(scene.coupling.body(*body).held_place());
  EXPECT_EQ(scene.coupling.body(*body).velocity(), Vec2{});
  scene.tick();
  EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
  EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()).x, 0.0);
}

struct GathersInside : b2ContactListener {
  void BeginContact(b2Contact* /*contact*/) override {
    EXPECT_THROW(scene->coupling.gather(scene->world, dt), CallError);
    EXPECT_THROW(scene->coupling.hold(*body, {.cord = 0, .arc = 1.0}), CallError);
    ++calls;
  }
  GripWorld* scene = nullptr;
  b2Body* body = nullptr;
  int calls = 0;
};

TEST(Grip, ALockedWorldIsRefused) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* a = scene.add_body({5.0, 0.0}, 1.0);
  b2Body* b = scene.add_body({5.1, 0.0}, 1.0);
  for (b2Body* body : {a, b}) body->GetFixtureList()->SetFilterData(b2Filter());
  GathersInside listener;
  listener.scene = &scene;
  listener.body = a;
  scene.world.SetContactListener(&listener);
  scene.tick(2);
  EXPECT_GT(listener.calls, 0);
}

}  // namespace
}  // namespace engine
