#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/grip_table.h"
#include "tests/support/freed_body.h"

// Grips at any place of a cord of the direct solver, and what they do.

namespace engine {
namespace {

using ribbon::CallError;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::DefinitionError;
using ribbon::Vec2;

constexpr double dt = 1.0 / 60.0;
constexpr double g = 9.81;

struct World {
  void tick(int times = 1) {
    for (int k = 0; k < times; ++k) {
      coupling.tick(world, dt);
    }
  }
  b2Body* add_body(Vec2 position, double mass, b2BodyType type = b2_dynamicBody) {
    b2BodyDef definition;
    definition.type = type;
    definition.position = ribbon::box2d::to_float(position);
    definition.allowSleep = false;
    b2Body* body = world.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = static_cast<float>(mass / (3.14159265358979 * 0.04));
    fixture.filter.maskBits = 0;  // it holds cords, and meets nothing
    body->CreateFixture(&fixture);
    return body;
  }
  Vec2 place(ribbon::box2d::CordId cord, double arc) const {
    const Cord& direct = coupling.cord(cord).direct();
    const double link = direct.rest_length(0);
    const auto i = static_cast<std::size_t>(std::min(arc / link, direct.def().points - 2.0));
    const double share = arc / link - static_cast<double>(i);
    return direct.positions()[i] + share * (direct.positions()[i + 1] - direct.positions()[i]);
  }

  b2World world{b2Vec2(0.0F, -static_cast<float>(g))};
  ribbon::box2d::Coupling coupling;
};

CordDef hanging(double x = 0.0) {
  CordDef def;
  def.pins = {0};
  for (int i = 0; i < def.points; ++i) def.positions.push_back({x, -0.2 * i});
  return def;
}

/// Between two points, and off the body's centre: hand and cord stay together, and the cord pulls with the weight.
TEST(Grip, HoldsBetweenPointsWithTheBodysWeight) {
  for (const double mass : {0.1, 70.0, 1000.0}) {
    World scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -6.5}, mass);
    const ribbon::box2d::GripId grip =
        scene.coupling.hold(*body, {.cord = 0, .arc = 6.37, .local_anchor = {0.0F, 0.13F}});
    scene.tick(600);
    ASSERT_TRUE(scene.coupling.grip(grip).is_valid());
    const ribbon::box2d::GripState state = scene.coupling.grip(grip).state();
    EXPECT_NEAR(state.pull.y, g * static_cast<double>(body->GetMass()), 1e-3 * g * mass);
    EXPECT_NEAR(state.pull.x, 0.0, 1e-3 * g * mass);
    EXPECT_NEAR(state.arc, 6.37, 1e-9);
    EXPECT_NEAR(length(ribbon::box2d::to_double(body->GetWorldPoint({0.0F, 0.13F})) - scene.place(0, 6.37)), 0.0, 1e-5);
  }
}

/// A bar hung by both its ends from two cords carries itself level; the two pulls are its weight. One cord after the
/// other could not know what the other carries.
TEST(Grip, OneBodyHangsFromTwoCordsAndFromTwoPlacesOfOne) {
  World scene;
  scene.coupling.add(Cord(hanging(-0.5)));
  scene.coupling.add(Cord(hanging(0.5)));
  b2Body* bar = scene.add_body({0.0, -7.0}, 40.0);
  const ribbon::box2d::GripId left = scene.coupling.hold(*bar, {.cord = 0, .arc = 7.0, .local_anchor = {-0.5F, 0.0F}});
  const ribbon::box2d::GripId right = scene.coupling.hold(*bar, {.cord = 1, .arc = 7.0, .local_anchor = {0.5F, 0.0F}});
  scene.tick(300);
  const double weight = g * static_cast<double>(bar->GetMass());
  EXPECT_NEAR(scene.coupling.grip(left).state().pull.y, 0.5 * weight, 1e-3 * weight);
  EXPECT_NEAR(scene.coupling.grip(right).state().pull.y, 0.5 * weight, 1e-3 * weight);
  EXPECT_NEAR(bar->GetPosition().y, -7.0, 1e-4);
  EXPECT_NEAR(bar->GetAngle(), 0.0, 1e-4);

  const ribbon::box2d::GripId above = scene.coupling.hold(*bar, {.cord = 0, .arc = 6.9, .local_anchor = {-0.5F, 0.1F}});
  scene.tick(60);
  EXPECT_NEAR(scene.coupling.grip(left).state().pull.y + scene.coupling.grip(above).state().pull.y +
                  scene.coupling.grip(right).state().pull.y,
              weight, 1e-3 * weight);
  EXPECT_NEAR(bar->GetPosition().y, -7.0, 1e-3);
}

/// Arc length changes under load, at the speed asked for, and then rests.
TEST(Grip, ClimbsUnderLoad) {
  World scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -8.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 8.0});
  scene.tick(10);
  scene.coupling.grip(grip).climb(3.3, 1.5);
  for (int k = 0; k < 180; ++k) {
    scene.tick();
    EXPECT_NEAR(body->GetPosition().y, -8.0 + 1.5 * dt * (k + 1), 0.02);
  }
  scene.tick(120);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 3.3, 1e-9);
  EXPECT_NEAR(body->GetPosition().y, -3.3, 1e-3);
  EXPECT_NEAR(length(scene.coupling.velocity(*body)), 0.0, 1e-2);
}

/// Slides down with g − F/m, as it must, and stops being held at the cord's end.
TEST(Grip, SlipsAgainstItsStrength) {
  World scene;
  scene.coupling.add(Cord(hanging()));
  scene.coupling.cord(0).direct().attach_mass(50, 20.0);  // keeps the cord straight
  b2Body* body = scene.add_body({0.0, -3.0}, 70.0);
  const double mass = static_cast<double>(body->GetMass());
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 3.0, .strength = 500.0});
  scene.tick(48);
  const double fall = 0.5 * (g - 500.0 / mass) * 0.8 * 0.8;
  EXPECT_TRUE(scene.coupling.grip(grip).state().slips);
  EXPECT_NEAR(scene.coupling.grip(grip).state().pull.y, 500.0, 1.0);
  EXPECT_NEAR(body->GetPosition().y, -3.0 - fall, 1e-3);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 3.0 + fall, 1e-3);
}

/// A solve that is sent through the line search from its first step on finds the same: held and slipping, one body by
/// two cords.
TEST(Grip, SlipsTheSameByTheLineSearch) {
  const auto slid = [](int max_iterations, int& searches) {
    World scene;
    for (const double x : {-0.5, 0.5}) {
      CordDef def = hanging(x);
      def.accuracy.max_iterations = max_iterations;
      scene.coupling.add(Cord(def));
      scene.coupling.cord(scene.coupling.size() - 1).direct().attach_mass(50, 20.0);
    }
    b2Body* body = scene.add_body({0.0, -3.0}, 70.0);
    scene.coupling.hold(*body, {.cord = 0, .arc = 3.0, .local_anchor = {-0.5F, 0.0F}, .strength = 200.0});
    const ribbon::box2d::GripId other =
        scene.coupling.hold(*body, {.cord = 1, .arc = 3.0, .local_anchor = {0.5F, 0.0F}, .strength = 200.0});
    scene.tick(30);
    searches = scene.coupling.cord(0).island_total().searches;
    EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
    EXPECT_TRUE(scene.coupling.grip(other).state().slips);
    return scene.coupling.grip(other).state().arc;
  };
  int by_newton = 0;
  int by_search = 0;
  const double full = slid(8, by_newton);
  EXPECT_NEAR(full, 3.0 + 0.5 * (g - 400.0 / 70.0) * 0.5 * 0.5, 0.02);
  EXPECT_NEAR(slid(1, by_search), full, 1e-2);
  EXPECT_GT(by_search, by_newton + 20);
}

/// Hung from two ropes that cannot push, a bar that is thrown up rises as if there were none.
TEST(Grip, OfCordsThatOnlyPullDoesNotStopWhatRises) {
  World scene;
  for (const double x : {-0.5, 0.5}) {
    CordDef def = hanging(x);
    def.mass_per_length = 0.01;
    def.tension_only = true;
    scene.coupling.add(Cord(def));
  }
  b2Body* bar = scene.add_body({0.0, -10.0}, 40.0);
  scene.coupling.hold(*bar, {.cord = 0, .arc = 10.0, .local_anchor = {-0.5F, 0.0F}});
  scene.coupling.hold(*bar, {.cord = 1, .arc = 10.0, .local_anchor = {0.5F, 0.0F}});
  scene.tick(10);
  bar->SetLinearVelocity({0.0F, 3.0F});
  scene.tick(18);
  const double half_a_tick = 0.5 * g * dt;  // in the tick of the throw the cords begin taut and end slack
  EXPECT_NEAR(bar->GetLinearVelocity().y, 3.0 - g * 0.3, 1.1 * half_a_tick);
  EXPECT_NEAR(bar->GetPosition().y, -10.0 + 3.0 * 0.3 - 0.5 * g * 0.3 * 0.3, 0.05);
  EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
}

TEST(Grip, LetsGoAboveItsStrength) {
  World scene;
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

/// From one cord to the next in a swing: neither position nor velocity jumps.
TEST(Grip, GoesFromOneCordToAnotherWithoutAJolt) {
  World scene;
  scene.coupling.add(Cord(hanging()));
  scene.coupling.add(Cord(hanging(1.0)));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  scene.tick();
  body->ApplyLinearImpulseToCenter({static_cast<float>(70.0 * 2.0), 0.0F}, true);
  bool changed = false;
  Vec2 position = ribbon::box2d::to_double(body->GetPosition());
  Vec2 velocity = scene.coupling.velocity(*body);
  for (int k = 0; k < 60; ++k) {
    if (!changed && position.x > 0.9) {
      // Where the other cord is nearest.
      const Vec2 nearest = scene.place(1, -position.y);
      ASSERT_LT(length(nearest - position), 0.2);
      EXPECT_TRUE(scene.coupling.grip(grip).release());
      grip = scene.coupling.hold(*body, {.cord = 1, .arc = -position.y});
      changed = true;
    }
    scene.tick();
    const Vec2 now = ribbon::box2d::to_double(body->GetPosition());
    const Vec2 next = scene.coupling.velocity(*body);
    if (k > 1) {
      EXPECT_LT(length(next - velocity), 0.6) << k;  // 2 g in a tick is 0.3 m/s
    }
    EXPECT_LT(length(now - position), 0.06) << k;
    position = now;
    velocity = next;
  }
  EXPECT_TRUE(changed);
  EXPECT_EQ(scene.coupling.grip(grip).state().cord, 1);
}

TEST(Grip, AKinematicBodyCarriesTheCordAtAnyPlace) {
  World scene;
  CordDef def = hanging();
  def.pins = {};
  scene.coupling.add(Cord(def));
  b2Body* hand = scene.add_body({0.0, -1.1}, 0.0, b2_kinematicBody);
  scene.coupling.hold(*hand, {.cord = 0, .arc = 1.1});
  hand->SetLinearVelocity({0.5F, 0.0F});
  for (int k = 0; k < 120; ++k) {
    scene.tick();
    EXPECT_NEAR(length(scene.place(0, 1.1) - ribbon::box2d::to_double(hand->GetPosition())), 0.0, 1e-4);
  }
}

/// What nothing pushes presses on nothing, however it holds the cord: contacts are as firm as without it.
TEST(Grip, ABodyThatNothingPushesGripsACordThatTouches) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    World scene;
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.pins = {0, 20};
    scene.coupling.add(Cord(def));
    b2Body* hand = scene.add_body({1.03, 0.0}, 0.0, type);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*hand, {.cord = 0, .arc = 1.03});
    b2Body* ball = scene.add_body({0.5, 0.25}, 1.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
    int touched = 0;
    for (int k = 0; k < 60; ++k) {
      scene.tick();
      ASSERT_LT(scene.coupling.cord(0).island_report().iterations, 1000) << k;
      touched += scene.coupling.cord(0).touching().empty() ? 0 : 1;
    }
    EXPECT_GT(touched, 30);
    EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
    EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 1.03, 1e-9);
    EXPECT_NEAR(length(scene.place(0, 1.03) - ribbon::box2d::to_double(hand->GetPosition())), 0.0, 1e-4);
    EXPECT_GT(ball->GetPosition().y, 0.0F) << "it is carried";
  }
}

/// What hits a cord that nothing but static grips holds passes momentum on to them, as to pins: nothing is free to keep
/// it.
TEST(Grip, AStaticBodyTakesTheMomentumOfWhatHitsTheCord) {
  const auto hit = [](bool pinned) {
    World scene;
    scene.world.SetGravity({0.0F, 0.0F});
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    if (pinned) def.pins = {0, 20};
    scene.coupling.add(Cord(def));
    if (!pinned) {
      scene.coupling.hold(*scene.add_body({0.01, 0.0}, 0.0, b2_staticBody), {.cord = 0, .arc = 0.01});
      scene.coupling.hold(*scene.add_body({1.99, 0.0}, 0.0, b2_staticBody), {.cord = 0, .arc = 1.99});
    }
    b2Body* ball = scene.add_body({1.0, 0.3}, 2.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
    ball->SetLinearVelocity({0.0F, -3.0F});
    scene.tick(10);
    return scene.coupling.velocity(*ball).y;
  };
  EXPECT_GT(hit(true), -1.0) << "stopped, or thrown back";
  EXPECT_NEAR(hit(false), hit(true), 0.2);
}

TEST(Grip, ReelsAHangingBodyIn) {
  World scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -10.0}, 70.0);
  scene.coupling.hold(*body, {.cord = 0, .arc = 10.0});
  scene.tick(5);
  scene.coupling.cord(0).direct().reel(0, 50, 6.0, 2.0);
  scene.tick(180);
  EXPECT_NEAR(body->GetPosition().y, -6.0, 0.01);
}

TEST(Grip, RefusesWhatCannotBe) {
  World scene;
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
  refuses_call({.cord = 0, .arc = 5.0});  // there already
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
  scene.coupling.release(*scene.world.GetBodyList());
  EXPECT_FALSE(scene.coupling.grip(grip + 1).release());
  EXPECT_FALSE(scene.coupling.grip(grip + 1).is_valid());
  scene.tick(10);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 5.0, 1e-12);
}

/// A body that is destroyed without a word lets go; so does one whose numbers are none.
TEST(Grip, EndsWithItsBody) {
  World scene;
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
  for (const Vec2 x : scene.coupling.cord(0).positions()) EXPECT_TRUE(is_finite(x));
}

/// The grips of a tick were found by its gather: one that is gone by then pulls on nothing.
TEST(Grip, EndsInTheMiddleOfATick) {
  World scene;
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
  for (const Vec2 x : scene.coupling.cord(0).positions()) EXPECT_TRUE(is_finite(x));
  EXPECT_LT(other->GetLinearVelocity().y, 0.0F);
}

/// Between the end of a body and the next gather nothing looks into the memory where it was.
TEST(Grip, LetGoAfterItsBodysEndTouchesNothing) {
  const auto end = [](auto&& let_go) {
    World scene;
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

/// Destroys a body without telling the coupling, and has Box2D make another at the same address.
b2Body* make_anew(World& scene, b2Body* body, Vec2 position, double mass) {
  scene.world.DestroyBody(body);
  b2Body* next = scene.add_body(position, mass);
  EXPECT_EQ(next, body) << "Box2D likes to use the same address again";
  return next;
}

/// It stands before a body that was made after the other one, so it is new, and nothing of the other is its own.
TEST(Grip, ABodyMadeAnewAtTheSameAddressHoldsNothing) {
  const auto anew = [](auto&& ask) {
    World scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
    scene.add_body({50.0, 0.0}, 1.0);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
    body->SetLinearVelocity({20.0F, 0.0F});
    scene.tick(20);
    ASSERT_GT(length(scene.coupling.velocity(*body) - ribbon::box2d::to_double(body->GetLinearVelocity())), 0.1)
        << "carried";
    body = make_anew(scene, body, {10.0, 0.0}, 1.0);
    ask(scene, *body, grip);
    EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()), Vec2{});
    scene.tick();
    EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
    EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()).x, 0.0);
    EXPECT_NEAR(ribbon::box2d::to_double(body->GetLinearVelocity()).y, -g * dt, 1e-6);
  };
  anew([](World&, b2Body&, ribbon::box2d::GripId) {});
  anew([](World& scene, b2Body& body, ribbon::box2d::GripId) {
    EXPECT_EQ(scene.coupling.velocity(body), Vec2{});
    EXPECT_FALSE(scene.coupling.held_by(body));
  });
  anew([](World& scene, b2Body&, ribbon::box2d::GripId grip) { scene.coupling.grip(grip).release(); });
  anew([](World& scene, b2Body&, ribbon::box2d::GripId) { scene.coupling.cord(0).set_enabled(false); });
  anew([](World& scene, b2Body& body, ribbon::box2d::GripId) { EXPECT_FALSE(scene.coupling.release(body)); });
  anew([](World& scene, b2Body&, ribbon::box2d::GripId) {
    const ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    EXPECT_TRUE(state.grips.empty());
    EXPECT_TRUE(state.carries.empty());
  });
}

/// A body that is made anew and takes hold at once has its own grip and no other.
TEST(Grip, ABodyMadeAnewAtTheSameAddressCanTakeHold) {
  World scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  scene.add_body({50.0, 0.0}, 1.0);
  const ribbon::box2d::GripId before = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  scene.tick(5);
  body = make_anew(scene, body, {0.0, -9.0}, 70.0);
  ribbon::box2d::GripId after = 0;
  ASSERT_NO_THROW(after = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0}));
  scene.tick(5);
  EXPECT_FALSE(scene.coupling.grip(before).is_valid());
  EXPECT_TRUE(scene.coupling.grip(after).is_valid());
  scene.add_body({50.0, 5.0}, 1.0);
  scene.tick(5);
  body = make_anew(scene, body, {0.0, -5.0}, 70.0);
  scene.coupling.hold(0, 25, *body, b2Vec2_zero);
  scene.tick(5);
  EXPECT_FALSE(scene.coupling.grip(after).is_valid());
  ASSERT_TRUE(scene.coupling.held_by(*body));
  EXPECT_EQ(scene.coupling.held_by(*body)->point, 25);
}

/// Of whatever a solve that went wrong says of how far a grip slipped.
TEST(Grip, IsMovedToAPlaceOfItsCord) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int columns = 51;
  constexpr int rows = 2;
  const auto moved = [](double by) {
    ribbon::box2d::GripMemory grip;
    grip.point = 2 * 7 + 1;
    grip.along = 0.25;
    ribbon::box2d::set_column(grip, 7.25 + by, columns, rows);
    EXPECT_EQ(grip.point % rows, 1);
    EXPECT_GE(grip.along, 0.0);
    EXPECT_LT(grip.along, 1.0);
    const int column = grip.point / rows;
    return column + grip.along;
  };
  EXPECT_EQ(moved(3.5), 10.75);
  EXPECT_EQ(moved(-0.25), 7.0);
  for (const double far : {50.0, 1e10, 1e300, infinity}) {
    EXPECT_EQ(moved(far), 50.0) << far;
    EXPECT_EQ(moved(-far), 0.0) << far;
  }
  EXPECT_EQ(moved(std::numeric_limits<double>::quiet_NaN()), 7.25) << "where it was";
}

/// A user's own listener can say what the order of the world's list cannot: that the newest body is another one.
TEST(Grip, EndsWithItsBodyWhereAListenerSaysSo) {
  struct Listener : b2DestructionListener {
    void SayGoodbye(b2Joint* /*joint*/) override {}
    void SayGoodbye(b2Fixture* fixture) override { coupling->forget(*fixture->GetBody()); }
    ribbon::box2d::Coupling* coupling = nullptr;
  };
  World scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  body->SetLinearVelocity({20.0F, 0.0F});
  scene.tick(20);
  Listener listener;
  listener.coupling = &scene.coupling;
  scene.world.SetDestructionListener(&listener);
  body = make_anew(scene, body, {10.0, 0.0}, 1.0);
  EXPECT_FALSE(scene.coupling.held_by(*body));
  EXPECT_EQ(scene.coupling.velocity(*body), Vec2{});
  scene.tick();
  EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
  EXPECT_EQ(ribbon::box2d::to_double(body->GetLinearVelocity()).x, 0.0);
}

/// What a grip does that turns so fast is any, but it stays on its cord, and no tick throws.
TEST(Grip, StaysOnItsCordHoweverItSlips) {
  for (const float turning : {1e4F, 1e5F, 1e7F, 1e9F}) {
    World scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -3.05}, 70.0);
    std::vector<ribbon::box2d::GripId> grips;
    grips.push_back(
        scene.coupling.hold(*body, {.cord = 0, .arc = 3.05, .local_anchor = {0.0F, 0.1F}, .strength = 5.0}));
    grips.push_back(
        scene.coupling.hold(*body, {.cord = 0, .arc = 3.55, .local_anchor = {0.1F, 0.0F}, .strength = 5.0}));
    scene.coupling.cord(0).direct().reel(0, 50, 5.0, 10.0);
    for (int k = 0; k < 20; ++k) {
      body->SetAngularVelocity(turning);
      ASSERT_NO_THROW(scene.tick()) << turning << " " << k;
      for (const ribbon::box2d::GripId grip : grips) {
        ASSERT_TRUE(scene.coupling.grip(grip).is_valid());
        EXPECT_GE(scene.coupling.grip(grip).state().arc, 0.0);
        EXPECT_LE(scene.coupling.grip(grip).state().arc, 10.0);
      }
      for (const Vec2 x : scene.coupling.cord(0).positions()) ASSERT_TRUE(is_finite(x)) << turning << " " << k;
      ASSERT_NO_THROW(scene.coupling.restore(scene.coupling.save(scene.world), scene.world)) << turning << " " << k;
    }
  }
}

struct GathersInside : b2ContactListener {
  void BeginContact(b2Contact* /*contact*/) override {
    EXPECT_THROW(scene->coupling.gather(scene->world, dt), CallError);
    EXPECT_THROW(scene->coupling.hold(*body, {.cord = 0, .arc = 1.0}), CallError);
    ++calls;
  }
  World* scene = nullptr;
  b2Body* body = nullptr;
  int calls = 0;
};

TEST(Grip, ALockedWorldIsRefused) {
  World scene;
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

/// Begins with the impulse that stops the ball, and ends when it has gone.
TEST(TouchEvents, TellWhoBeginsAndCeasesToTouch) {
  World scene;
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  scene.coupling.add(Cord(def));
  b2Body* ball = scene.add_body({1.0, 0.6}, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  std::vector<ribbon::box2d::TouchEvent> events;
  for (int k = 0; k < 60; ++k) {
    scene.tick();
    events.insert(events.end(), scene.coupling.touch_events().begin(), scene.coupling.touch_events().end());
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
  ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
  EXPECT_FALSE(scene.coupling.touch_events()[0].begins);
  EXPECT_EQ(scene.coupling.touch_events()[0].fixture, ball->GetFixtureList()) << "far away it is still there";
}

/// Of one that is destroyed by the coupling after the tick the events are there and the fixture is not.
TEST(TouchEvents, OfAFixtureThatIsDestroyedAfterTheTickHaveNone) {
  World scene;
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  scene.coupling.add(Cord(def));
  b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  for (int k = 0; k < 60 && scene.coupling.touch_events().empty(); ++k) scene.tick();
  ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
  const std::uint64_t number = scene.coupling.cord(0).touching()[0].fixture;
  EXPECT_EQ(scene.coupling.fixture(number), ball->GetFixtureList());
  scene.coupling.destroy(scene.world, *ball);
  ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
  EXPECT_EQ(scene.coupling.touch_events()[0].fixture, nullptr);
  EXPECT_EQ(scene.coupling.fixture(number), nullptr);
}

/// What destroys otherwise may say so, or whoever asks may ask in the world.
TEST(TouchEvents, OfAFixtureThatBox2DDestroysAreFoundByNumberOrForgotten) {
  for (const bool forgets : {true, false}) {
    World scene;
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.pins = {0, 20};
    scene.coupling.add(Cord(def));
    b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
    for (int k = 0; k < 60 && scene.coupling.touch_events().empty(); ++k) scene.tick();
    ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
    const std::uint64_t number = scene.coupling.touch_events()[0].number;
    EXPECT_EQ(scene.coupling.fixture(number, scene.world), ball->GetFixtureList());
    if (forgets) scene.coupling.forget(*ball->GetFixtureList());
    ball->DestroyFixture(ball->GetFixtureList());
    EXPECT_EQ(scene.coupling.fixture(number, scene.world), nullptr);
    EXPECT_EQ(scene.coupling.touch_events()[0].fixture == nullptr, forgets);
    const ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    ASSERT_EQ(state.events.size(), 1U);
    EXPECT_EQ(state.events[0].fixture, 0U);
    scene.tick();
    ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
    EXPECT_EQ(scene.coupling.touch_events()[0].fixture, nullptr);
    EXPECT_EQ(scene.coupling.touch_events()[0].number, 0U);
  }
}

/// Two fixtures of one body: one that takes the older one's address is another one.
TEST(TouchEvents, OfAFixtureMadeAnewAtTheSameAddressAreItsOwn) {
  World scene;
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  scene.coupling.add(Cord(def));
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

/// A fixture of a body that was made anew at the same address has another number, and touches anew.
TEST(TouchEvents, OfABodyMadeAnewAtTheSameAddressAreItsOwn) {
  World scene;
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  scene.coupling.add(Cord(def));
  b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  scene.add_body({50.0, 0.0}, 1.0);
  scene.tick(120);
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  const std::uint64_t number = scene.coupling.cord(0).touching()[0].fixture;
  const Vec2 place = ribbon::box2d::to_double(ball->GetPosition());
  ball = make_anew(scene, ball, place, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  scene.tick();
  ASSERT_EQ(scene.coupling.cord(0).touching().size(), 1U);
  EXPECT_NE(scene.coupling.cord(0).touching()[0].fixture, number);
  ASSERT_EQ(scene.coupling.touch_events().size(), 2U);
  EXPECT_EQ(scene.coupling.touch_events()[0].fixture, nullptr);
  EXPECT_TRUE(scene.coupling.touch_events()[1].begins);
}

/// Of what is destroyed nothing is told but that it ceased to touch.
TEST(TouchEvents, OfAFixtureThatIsNoMoreHaveNone) {
  World scene;
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  scene.coupling.add(Cord(def));
  b2Body* ball = scene.add_body({1.0, 0.2}, 2.0);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  for (int k = 0; k < 60 && scene.coupling.touch_events().empty(); ++k) scene.tick();
  ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
  scene.world.DestroyBody(ball);
  scene.tick();
  ASSERT_EQ(scene.coupling.touch_events().size(), 1U);
  EXPECT_FALSE(scene.coupling.touch_events()[0].begins);
  EXPECT_EQ(scene.coupling.touch_events()[0].fixture, nullptr);
}

}  // namespace
}  // namespace engine
