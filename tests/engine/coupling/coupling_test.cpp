#include "ribbon/box2d/coupling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ribbon/box2d/convert.h"
#include "tests/engine/coupling/thesis_coupling.h"
#include "tests/support/allocations.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"
#include "tests/support/thesis_scenes.h"

namespace engine {
namespace {

using ribbon::ThesisCord;
using test_support::filter;
using test_support::step_cords;

Vec2 momentum(const b2Body* body) {
  return static_cast<double>(body->GetMass()) * ribbon::box2d::to_double(body->GetLinearVelocity());
}

/// Bodies in single precision and a cord in double precision exchange momentum without loss.
TEST(Coupling, CordAndCirclesConserveLinearMomentum) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* light = add_circle(world, {1.0, 0.8}, 0.3, b2_dynamicBody, 0.7);
  b2Body* heavy = add_circle(world, {3.1, -0.9}, 0.25, b2_dynamicBody, 40.0);
  light->SetLinearVelocity({0.37F, -2.0F});
  heavy->SetLinearVelocity({-0.21F, 1.3F});
  heavy->SetAngularVelocity(3.0F);
  const auto total = [&] {
    return test_support::momentum(coupling.cord(0).thesis()) + momentum(light) + momentum(heavy);
  };
  const Vec2 before = total();
  int contacts = 0;
  for (int k = 0; k < 600; ++k) {
    tick(coupling, world);
    contacts += coupling.cord(0).thesis_report().circle_contacts;
    ASSERT_EQ(coupling.cord(0).thesis_report().motion_limited, 0);
    EXPECT_NEAR(length(total() - before), 0.0, 1e-9 * length(before)) << "tick " << k;
  }
  EXPECT_GT(contacts, 20);
  EXPECT_GT(length(test_support::momentum(coupling.cord(0).thesis())), 0.1);  // the cord is hit
}

TEST(Coupling, ACircleFallsOntoACordAndIsCarried) {
  b2World world({0.0F, -9.81F});
  ribbon::box2d::Coupling coupling;
  ThesisDef def = pinned_at_both_ends();
  def.drag = 1.0;
  coupling.add(ThesisCord(def));
  b2Body* ball = add_circle(world, {2.0, 1.0}, 0.3);
  for (int k = 0; k < 1200; ++k) tick(coupling, world);
  EXPECT_GT(y_of(ball), -1.0);
  EXPECT_LT(static_cast<double>(ball->GetLinearVelocity().Length()), 0.02);
  EXPECT_GT(coupling.cord(0).thesis_report().circle_contacts, 0);
}

TEST(Coupling, AFixtureOffItsBodysCentreCollidesWhereItIs) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  // A dumbbell: two circles on one body, 1 m to both sides of its centre, which is far from the cord.
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = {2.0F, 1.25F};
  definition.angle = 0.5F * b2_pi;  // the local x axis points up
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = 0.2F;
  for (const float x : {-1.0F, 1.0F}) {
    shape.m_p = {x, 0.0F};
    body->CreateFixture(&shape, 1.0F);
  }
  body->SetLinearVelocity({0.0F, -1.0F});
  int contacts = 0;
  for (int k = 0; k < 30; ++k) {
    tick(coupling, world);
    contacts += coupling.cord(0).thesis_report().circle_contacts;
  }
  EXPECT_GT(contacts, 0);
  EXPECT_GT(static_cast<double>(body->GetLinearVelocity().y), -0.95);
}

TEST(Coupling, AHitOffCentreTurnsABody) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = {2.0F, 0.45F};
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = 0.2F;
  for (const float x : {-0.9F, 0.9F}) {
    shape.m_p = {x, x < 0.0F ? 0.0F : 1.0F};  // only the left one reaches the cord
    body->CreateFixture(&shape, 1.0F);
  }
  body->SetLinearVelocity({0.0F, -2.0F});
  for (int k = 0; k < 10; ++k) tick(coupling, world);
  EXPECT_LT(static_cast<double>(body->GetAngularVelocity()), -0.1);  // pushed up on the left: clockwise
}

TEST(Coupling, StaticAndKinematicCirclesMoveTheCordAndAreNotMoved) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* resting = add_circle(world, {0.5, 0.35}, 0.3, b2_staticBody);  // overlaps by 5 cm
  b2Body* rising = add_circle(world, {3.0, -0.5}, 0.3, b2_kinematicBody);
  rising->SetLinearVelocity({0.0F, 1.0F});
  for (int k = 0; k < 60; ++k) tick(coupling, world);
  EXPECT_EQ(y_of(resting), static_cast<double>(0.35F));
  EXPECT_NEAR(y_of(rising), 0.5, 1e-5);
  EXPECT_EQ(rising->GetLinearVelocity(), b2Vec2(0.0F, 1.0F));
  for (const Vec2 p : coupling.cord(0).thesis().positions()) {
    EXPECT_GT(length(p - Vec2{0.5, 0.35}), 0.3 - 2e-3);
    EXPECT_GT(length(p - Vec2{3.0, y_of(rising)}), 0.3 - 2e-2);
  }
  EXPECT_GT(coupling.cord(0).thesis().positions()[30].y, 0.1);  // carried up
}

struct FilterCase {
  const char* name;
  b2Filter cord;
  b2Filter circle;
  bool meet;
};

TEST(Coupling, FilterBitsActAsBetweenTwoFixtures) {
  const FilterCase cases[] = {
      {"both want", filter(2, 0xFFFF), filter(1, 0xFFFF), true},
      {"the cord's mask leaves it out", filter(2, 0xFFFE), filter(1, 0xFFFF), false},
      {"the circle's mask leaves it out", filter(2, 0xFFFF), filter(1, 0xFFFD), false},
      {"a positive group joins", filter(2, 0, 3), filter(1, 0, 3), true},
      {"a negative group parts", filter(2, 0xFFFF, -3), filter(1, 0xFFFF, -3), false},
      {"different groups leave it to the bits", filter(2, 0xFFFF, -3), filter(1, 0xFFFF, -4), true},
  };
  for (const FilterCase& c : cases) {
    b2World world({0.0F, 0.0F});
    ribbon::box2d::Coupling coupling;
    coupling.add(ThesisCord(cord_def()), c.cord);
    add_circle(world, {2.0, 0.3}, 0.3, b2_staticBody, 1.0, c.circle);
    tick(coupling, world);
    EXPECT_EQ(coupling.cord(0).thesis_report().circle_contacts > 0, c.meet) << c.name;
  }
}

TEST(Coupling, SensorsAndDisabledBodiesAreIgnored) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  add_circle(world, {2.0, 0.3}, 0.3, b2_staticBody, 1.0, {}, true);
  b2Body* disabled = add_circle(world, {3.0, 0.3}, 0.3, b2_staticBody);
  disabled->SetEnabled(false);
  tick(coupling, world);
  EXPECT_EQ(coupling.cord(0).thesis_report().circle_contacts, 0);
  disabled->SetEnabled(true);
  tick(coupling, world);
  EXPECT_GT(coupling.cord(0).thesis_report().circle_contacts, 0);
}

TEST(Coupling, ABodyWithoutContactIsMovedByBox2D) {
  const auto fall = [](bool with_cord) {
    b2World world({0.0F, -9.81F});
    ribbon::box2d::Coupling coupling;
    if (with_cord) coupling.add(ThesisCord(pinned_at_both_ends({0.0, -40.0})));
    b2Body* ball = add_circle(world, {2.0, 1.0}, 0.3);
    for (int k = 0; k < 60; ++k) tick(coupling, world);
    return ball->GetPosition();
  };
  EXPECT_EQ(fall(true), fall(false));
}

TEST(Coupling, ASleepingCircleIsWokenOnlyWhenPushed) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* near = add_circle(world, {1.0, 0.55}, 0.3);
  b2Body* touching = add_circle(world, {3.0, 0.35}, 0.3);
  near->SetAwake(false);
  touching->SetAwake(false);
  step_cords(coupling, world, dt);
  EXPECT_FALSE(near->IsAwake());
  EXPECT_TRUE(touching->IsAwake());
}

TEST(Coupling, BodiesCanBeAddedAndRemovedBetweenTicks) {
  b2World world({0.0F, -9.81F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(pinned_at_both_ends()));
  b2Body* ball = add_circle(world, {2.0, 0.4}, 0.3);
  for (int k = 0; k < 30; ++k) tick(coupling, world);
  EXPECT_GT(coupling.cord(0).thesis_report().circle_contacts, 0);
  world.DestroyBody(ball);  // while it touches
  tick(coupling, world);
  EXPECT_EQ(coupling.cord(0).thesis_report().circle_contacts, 0);
  ball = add_circle(world, {2.0, 0.4}, 0.3);
  ball->DestroyFixture(ball->GetFixtureList());
  for (int k = 0; k < 10; ++k) tick(coupling, world);
  EXPECT_TRUE(test_support::all_finite(coupling.cord(0).thesis()));
}

TEST(Coupling, TwoCordsAndABallBetweenThemConserveMomentum) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  coupling.add(ThesisCord(cord_def({0.0, 1.0})));
  b2Body* ball = add_circle(world, {2.0, 0.5}, 0.42);  // 2 cm into either
  ball->SetLinearVelocity({0.1F, 3.0F});
  const auto total = [&] {
    return test_support::momentum(coupling.cord(0).thesis()) + test_support::momentum(coupling.cord(1).thesis()) +
           momentum(ball);
  };
  const Vec2 before = total();
  for (int k = 0; k < 300; ++k) {
    tick(coupling, world);
    ASSERT_NEAR(length(total() - before), 0.0, 1e-9 * length(before)) << "tick " << k;
  }
  EXPECT_GT(coupling.cord(0).thesis_total().circle_contacts, 0);
  EXPECT_GT(coupling.cord(1).thesis_total().circle_contacts, 0);
}

TEST(Coupling, ADynamicBodyWithoutMassIsIgnored) {
  b2World world({0.0F, -9.81F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(pinned_at_both_ends()));
  b2Body* empty = add_circle(world, {2.0, 0.3}, 0.3, b2_dynamicBody, 0.0);
  coupling.hold(0, 20, *empty, {0.0F, 0.0F});
  for (int k = 0; k < 30; ++k) tick(coupling, world);
  EXPECT_EQ(coupling.cord(0).thesis_total().circle_contacts, 0);
  EXPECT_TRUE(test_support::all_finite(coupling.cord(0).thesis()));
}

TEST(Coupling, ABodyWithoutGravityIsNotPredictedToFallIntoContact) {
  for (const float scale : {0.0F, 1.0F}) {
    b2World world({0.0F, -9.81F});
    ribbon::box2d::Coupling coupling;
    coupling.add(ThesisCord(pinned_at_both_ends()));
    // Half a millimetre above the pinned end, less than it falls in a tick.
    b2Body* ball = add_circle(world, {0.1, 0.1 + 0.3 + 5e-4}, 0.3);
    ball->SetGravityScale(scale);
    tick(coupling, world);
    EXPECT_EQ(coupling.cord(0).thesis_report().circle_contacts > 0, scale > 0.0F);
  }
}

TEST(Coupling, ADrivenPointCollides) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  add_circle(world, {4.0, 2.0}, 0.3, b2_staticBody);
  coupling.cord(0).thesis().operate(41, {4.0, 1.9});
  tick(coupling, world);
  EXPECT_GT(coupling.cord(0).thesis_report().circle_contacts, 0);
}

TEST(Coupling, AllocatesNothingWhenTheFirstCircleComesNear) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* ball = add_circle(world, {2.0, 3.0}, 0.3);
  ball->SetLinearVelocity({0.0F, -3.0F});
  tick(coupling, world);
  long taken = 0;
  for (int k = 0; k < 120; ++k) {
    const test_support::AllocationCount count;
    step_cords(coupling, world, dt);
    taken += count.so_far();
    world.Step(static_cast<float>(dt), 8, 3);
  }
  EXPECT_GT(coupling.cord(0).thesis_total().circle_contacts, 0);
  EXPECT_EQ(taken, 0);
}

/// The user chooses a body's origin; only the inertia about the centre of mass matters.
TEST(Coupling, ABodysOriginMakesNoDifference) {
  const auto hit = [](Vec2 origin) {
    b2World world({0.0F, 0.0F});
    ribbon::box2d::Coupling coupling;
    coupling.add(ThesisCord(cord_def()));
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = ribbon::box2d::to_float(origin);
    b2Body* body = world.CreateBody(&definition);
    b2CircleShape shape;
    shape.m_radius = 0.25F;
    for (const Vec2 center : {Vec2{1.0, 0.25}, Vec2{2.5, 1.0}}) {  // the first is 10 cm into the cord
      shape.m_p = ribbon::box2d::to_float(center - origin);
      body->CreateFixture(&shape, 1.0F);
    }
    body->SetLinearVelocity({0.0F, -2.0F});
    body->SetAngularVelocity(0.0F);
    step_cords(coupling, world, dt);
    return std::pair{ribbon::box2d::to_double(body->GetLinearVelocity()),
                     static_cast<double>(body->GetAngularVelocity())};
  };
  const auto [velocity, turning] = hit({1.75, 0.625});  // the centre of mass
  const auto [far_velocity, far_turning] = hit({-1.0, 5.0});
  EXPECT_LT(turning, -0.1);
  EXPECT_NEAR(length(far_velocity - velocity), 0.0, 1e-4 * length(velocity));
  EXPECT_NEAR(far_turning, turning, 1e-4 * std::abs(turning));
}

/// A fixture may have any friction, and an extent beyond all coordinates of a cord.
TEST(Coupling, AFixtureWithAnyNumbersCollidesOrIsIgnored) {
  b2World world(b2Vec2(0.0F, -9.81F));
  ribbon::box2d::Coupling coupling;
  ribbon::CordDef def;
  def.points = 11;
  def.length = 2.0;
  def.friction = 0.5;
  def.pins = {0, 10};
  coupling.add(ribbon::Cord(def));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float number : {nan, -1.0F, 1e30F, std::numeric_limits<float>::infinity()}) {
    b2Body* ball = add_circle(world, {1.0, 0.15}, 0.1);
    ball->GetFixtureList()->SetFriction(number);
    ball->GetFixtureList()->SetRestitution(number);
  }
  add_circle(world, {0.0, -3e9}, 2e9, b2_staticBody);
  for (int k = 0; k < 5; ++k) tick(coupling, world);
  EXPECT_TRUE(test_support::all_finite(coupling.cord(0).positions()));
}

/// A refused tick changes nothing.
TEST(Coupling, RefusesAnInvalidTickAndChangesNothing) {
  b2World world(b2Vec2(0.0F, -9.81F));
  ribbon::box2d::Coupling coupling;
  coupling.add(ribbon::Cord(ribbon::CordDef{}));
  EXPECT_THROW(coupling.step(), ribbon::CallError);  // without a gather
  const ribbon::Cord::State before = coupling.cord(0).direct().save();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {nan, 0.0, -dt, 1e-10, 1.1}) {
    EXPECT_THROW(coupling.gather(world, bad), ribbon::DefinitionError) << bad;
  }
  world.SetGravity({0.0F, -std::numeric_limits<float>::infinity()});
  EXPECT_THROW(coupling.gather(world, dt), ribbon::DefinitionError);
  EXPECT_EQ(coupling.cord(0).direct().save(), before);
}

/// Two cords that are pinned in the same place overlap, with an energy that is not a number.
TEST(Coupling, OverlappingCordsCanBeSavedAndRestored) {
  b2World world(b2Vec2(0.0F, -9.81F));
  ribbon::box2d::Coupling coupling;
  ribbon::CordDef def;
  def.stretch_stiffness = 1e3;
  def.cord_contact = true;
  def.pins = {0};
  def.accuracy = ribbon::Accuracy::fast();
  for (const int points : {5, 2}) {
    def.points = points;
    def.length = points == 5 ? 1.5 : 1.3;
    def.radius = points == 5 ? 0.05 : 0.01;
    coupling.add(ribbon::Cord(def));
  }
  for (int k = 0; k < 3; ++k) {
    tick(coupling, world);
    for (const int cord : {0, 1}) {
      ASSERT_NO_THROW(coupling.cord(cord).direct().restore(coupling.cord(cord).direct().save())) << "tick " << k;
    }
  }
}

TEST(Coupling, RefusesToDragAnUnknownCord) {
  ribbon::box2d::Coupling coupling;
  EXPECT_THROW(coupling.cord(0).drag(0, {}), ribbon::CallError);
  coupling.add(ThesisCord(cord_def()));
  EXPECT_THROW(coupling.cord(1).drag(0, {}), ribbon::CallError);
  EXPECT_THROW(coupling.cord(-1).free(0), ribbon::CallError);
}

}  // namespace
}  // namespace engine
