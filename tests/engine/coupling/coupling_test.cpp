#include "ribbon/box2d/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"
#include "tests/support/thesis_scenes.h"

namespace engine {
namespace {

using ribbon::ThesisCord;
using ribbon::ThesisDef;
using ribbon::Vec2;

constexpr double dt = 1.0 / 60.0;

/// A cord of 4 m along +x, its middle line through `left`, 0.2 m wide, 1 kg.
ThesisDef cord_def(Vec2 left = {0.0, 0.0}) {
  ThesisDef def;
  def.w = 21;
  def.spacing = 0.2;
  def.point_mass = 1.0 / 42.0;
  def.spring_stiffness = 2e4;
  def.bar_damping = 20.0;
  def.positions = ribbon::lay_along(std::array{left, left + Vec2{1.0, 0.0}}, def.w, def.h, def.spacing);
  return def;
}

ThesisDef pinned_at_both_ends(Vec2 left = {0.0, 0.0}) {
  ThesisDef def = cord_def(left);
  def.pins = {0, 1, 40, 41};
  return def;
}

b2Body* add_circle(b2World& world, Vec2 center, double radius, b2BodyType type = b2_dynamicBody, double density = 1.0,
                   b2Filter filter = {}, bool sensor = false) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = ribbon::box2d::to_float(center);
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(radius);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = static_cast<float>(density);
  fixture.filter = filter;
  fixture.isSensor = sensor;
  body->CreateFixture(&fixture);
  return body;
}

void tick(ribbon::box2d::Coupling& coupling, b2World& world) { coupling.tick(world, dt); }

double y_of(const b2Body* body) { return static_cast<double>(body->GetPosition().y); }

Vec2 momentum(const b2Body* body) {
  return static_cast<double>(body->GetMass()) * ribbon::box2d::to_double(body->GetLinearVelocity());
}

/// Box2D's bodies in single precision and the cord in double lose nothing between them.
TEST(Coupling, CordAndCirclesKeepTheirLinearMomentum) {
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
  EXPECT_GT(length(test_support::momentum(coupling.cord(0).thesis())), 0.1);  // it was hit
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

TEST(Coupling, AFixtureOffItsBodysCentreIsMetWhereItIs) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  // A dumbbell: two circles on one body, 1 m either side of its centre, which itself is far from the cord.
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

b2Filter filter(std::uint16_t category, std::uint16_t mask, std::int16_t group = 0) {
  b2Filter result;
  result.categoryBits = category;
  result.maskBits = mask;
  result.groupIndex = group;
  return result;
}

TEST(Coupling, FilterBitsDecideAsBetweenTwoFixtures) {
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

TEST(Coupling, ABodyThatNothingTouchesIsLeftToBox2D) {
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
  coupling.gather(world, dt);
  coupling.step();
  coupling.apply();
  EXPECT_FALSE(near->IsAwake());
  EXPECT_TRUE(touching->IsAwake());
}

TEST(Coupling, BodiesComeAndGoBetweenTicks) {
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

// --- holding ---------------------------------------------------------------------------------------------------------

TEST(Coupling, TwoCordsAndABallBetweenThemKeepTheirMomentum) {
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

TEST(Coupling, ADynamicBodyWithoutMassIsLeftOut) {
  b2World world({0.0F, -9.81F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(pinned_at_both_ends()));
  b2Body* empty = add_circle(world, {2.0, 0.3}, 0.3, b2_dynamicBody, 0.0);
  coupling.hold(0, 20, *empty, {0.0F, 0.0F});
  for (int k = 0; k < 30; ++k) tick(coupling, world);
  EXPECT_EQ(coupling.cord(0).thesis_total().circle_contacts, 0);
  EXPECT_TRUE(test_support::all_finite(coupling.cord(0).thesis()));
}

TEST(Coupling, ABodyThatGravityDoesNotPullDoesNotPress) {
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

TEST(Coupling, ADrivenPointMeetsWhatItIsDrivenInto) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  add_circle(world, {4.0, 2.0}, 0.3, b2_staticBody);
  coupling.cord(0).thesis().operate(41, {4.0, 1.9});
  tick(coupling, world);
  EXPECT_GT(coupling.cord(0).thesis_report().circle_contacts, 0);
}

TEST(Coupling, TakesNoHeapMemoryWhenTheFirstCircleComesNear) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* ball = add_circle(world, {2.0, 3.0}, 0.3);
  ball->SetLinearVelocity({0.0F, -3.0F});
  tick(coupling, world);
  long taken = 0;
  for (int k = 0; k < 120; ++k) {
    const test_support::AllocationCount count;
    coupling.gather(world, dt);
    coupling.step();
    coupling.apply();
    taken += count.so_far();
    world.Step(static_cast<float>(dt), 8, 3);
  }
  EXPECT_GT(coupling.cord(0).thesis_total().circle_contacts, 0);
  EXPECT_EQ(taken, 0);
}

/// Where a body has its origin is the user's affair: what counts is the inertia about the centre of mass.
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
    coupling.gather(world, dt);
    coupling.step();
    coupling.apply();
    return std::pair{ribbon::box2d::to_double(body->GetLinearVelocity()),
                     static_cast<double>(body->GetAngularVelocity())};
  };
  const auto [velocity, turning] = hit({1.75, 0.625});  // the centre of mass
  const auto [far_velocity, far_turning] = hit({-1.0, 5.0});
  EXPECT_LT(turning, -0.1);
  EXPECT_NEAR(length(far_velocity - velocity), 0.0, 1e-4 * length(velocity));
  EXPECT_NEAR(far_turning, turning, 1e-4 * std::abs(turning));
}

/// A cord that hangs from (0, 0) and a body of `mass` at its end, which holds the end's first point.
struct Hanging {
  b2World world{{0.0F, -9.81F}};
  ribbon::box2d::Coupling coupling;
  b2Body* body = nullptr;
  ribbon::box2d::CordId held = 0;
  ribbon::box2d::GripId grip = 0;

  /// With `others`, there are cords far away, one added before it and one after.
  explicit Hanging(double mass, double drag = 0.5, bool others = false) {
    if (others) coupling.add(ThesisCord(pinned_at_both_ends({-50.0, 0.0})));
    ThesisDef def = cord_def();
    def.drag = drag;
    def.substeps = 16;
    def.positions = ribbon::lay_along(std::array{Vec2{0.0, 0.0}, Vec2{0.0, -1.0}}, def.w, def.h, def.spacing);
    def.pins = {0, 1};
    b2Filter nothing;
    nothing.maskBits = 0;
    held = coupling.add(ThesisCord(def), nothing);
    if (others) coupling.add(ThesisCord(pinned_at_both_ends({50.0, 0.0})));
    body = add_circle(world, end(), 0.1, b2_dynamicBody, mass / (std::numbers::pi * 0.01));
    grip = coupling.hold(held, 40, *body, {0.0F, 0.0F});
  }
  Vec2 end() const { return coupling.cord(held).thesis().positions()[40]; }
  void run(int ticks) {
    for (int k = 0; k < ticks; ++k) tick(coupling, world);
  }
};

TEST(CouplingHold, TheCordCarriesTheBodyAndPullsWithItsWeight) {
  Hanging hanging(1.0, 2.0);
  hanging.run(1800);
  EXPECT_NEAR(y_of(hanging.body), -4.0, 0.2);
  EXPECT_LT(static_cast<double>(hanging.body->GetLinearVelocity().Length()), 0.01);
  EXPECT_NEAR(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetPosition())), 0.0, 1e-3);
  // The impulse of one more tick holds against gravity.
  const b2Vec2 before = hanging.body->GetLinearVelocity();
  hanging.coupling.gather(hanging.world, dt);
  hanging.coupling.step();
  hanging.coupling.apply();
  const double gain = static_cast<double>(hanging.body->GetLinearVelocity().y - before.y);
  EXPECT_NEAR(gain / dt, 9.81, 0.1);
}

/// Swings a hanging body; its widest excursions to the right, one a period.
std::vector<double> excursions(Hanging& hanging, int ticks) {
  std::vector<double> widest;
  double last_speed = 0.0;
  for (int k = 0; k < ticks; ++k) {
    hanging.run(1);
    const double speed = hanging.coupling.velocity(*hanging.body).x;
    if (last_speed > 0.0 && speed <= 0.0) widest.push_back(static_cast<double>(hanging.body->GetPosition().x));
    last_speed = speed;
  }
  return widest;
}

/// Whatever other cords there are.
TEST(CouplingHold, SwingsOnLikeAPendulum) {
  Hanging alone(5.0, 0.0);
  Hanging hanging(5.0, 0.0, true);
  alone.run(300);
  hanging.run(300);
  EXPECT_EQ(hanging.body->GetPosition(), alone.body->GetPosition());
  hanging.body->SetLinearVelocity({4.0F, 0.0F});
  const std::vector<double> widest = excursions(hanging, 2400);
  ASSERT_GE(widest.size(), 9U);
  EXPECT_GT(widest[0], 1.8);
  EXPECT_LT(widest[0], 2.45);  // what 4 m/s is good for on 4 m
  for (std::size_t k = 1; k < widest.size(); ++k) {
    EXPECT_LT(widest[k], 1.002 * widest[k - 1]);
    EXPECT_GT(widest[k], 0.98 * widest[k - 1]);  // without what is carried on: 0.945
  }
}

TEST(CouplingHold, AHolderThatHitsAWallOrStandsOnTheGroundGainsNothing) {
  for (const bool wall : {true, false}) {
    Hanging hanging(5.0, 0.0);
    hanging.run(120);
    b2BodyDef definition;
    definition.position = wall ? b2Vec2(1.2F, -4.0F) : b2Vec2(0.0F, -4.65F);
    b2PolygonShape box;
    box.SetAsBox(wall ? 0.5F : 20.0F, wall ? 20.0F : 0.5F);
    hanging.world.CreateBody(&definition)->CreateFixture(&box, 0.0F);
    hanging.body->SetLinearVelocity({6.0F, wall ? 0.0F : -6.0F});
    const double start = y_of(hanging.body);
    double fastest = 0.0;
    double highest = start;
    for (int k = 0; k < 1200; ++k) {
      hanging.run(1);
      fastest = std::max(fastest, length(hanging.coupling.velocity(*hanging.body)));
      highest = std::max(highest, y_of(hanging.body));
    }
    EXPECT_LT(fastest, 8.6) << wall;
    EXPECT_LT(highest, start + 72.0 / (2.0 * 9.81) + 0.2) << wall;
    EXPECT_TRUE(test_support::all_finite(hanging.coupling.cord(0).thesis()));
  }
}

TEST(CouplingHold, HeldOffCentreABodyHangsWithItsCentreBelowTheHand) {
  Hanging hanging(2.0, 2.0);
  hanging.body->SetTransform(ribbon::box2d::to_float(hanging.end() + Vec2{0.3, 0.0}), 0.0F);
  hanging.body->SetAngularDamping(1.0F);
  hanging.coupling.grip(hanging.grip).move_anchor({-0.3F, 0.0F});
  hanging.run(1800);
  const Vec2 hand = ribbon::box2d::to_double(hanging.body->GetWorldPoint({-0.3F, 0.0F}));
  const Vec2 center = ribbon::box2d::to_double(hanging.body->GetWorldCenter());
  EXPECT_NEAR(center.x - hand.x, 0.0, 5e-3);
  EXPECT_NEAR(center.y - hand.y, -0.3, 5e-3);
  EXPECT_NEAR(static_cast<double>(hanging.body->GetAngularVelocity()), 0.0, 0.02);
  EXPECT_NEAR(length(hanging.end() - hand), 0.0, 2e-3);
}

TEST(CouplingHold, AHandThatMovesOnItsBodyArrivesWithinTheTick) {
  Hanging hanging(5.0);
  hanging.run(120);
  hanging.coupling.grip(hanging.grip).move_anchor({0.05F, 0.1F});
  hanging.run(1);
  EXPECT_NEAR(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetWorldPoint({0.05F, 0.1F}))), 0.0, 5e-3);
}

TEST(CouplingHold, LetGoTheBodyKeepsItsVelocity) {
  Hanging hanging(2.0);
  hanging.body->SetLinearVelocity({3.0F, 0.0F});
  hanging.run(20);
  const Vec2 velocity = hanging.coupling.velocity(*hanging.body);
  EXPECT_TRUE(hanging.coupling.held_by(*hanging.body));
  EXPECT_TRUE(hanging.coupling.release(*hanging.body));
  EXPECT_FALSE(hanging.coupling.release(*hanging.body));
  EXPECT_FALSE(hanging.coupling.held_by(*hanging.body));
  hanging.run(1);
  EXPECT_NEAR(length(hanging.coupling.velocity(*hanging.body) - velocity - Vec2{0.0, -9.81 * dt}), 0.0, 1e-5);
}

TEST(CouplingHold, KeepsTheMomentumOfCordAndHolder) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* body = add_circle(world, {4.5, 0.3}, 0.2, b2_dynamicBody, 8.0);
  body->SetLinearVelocity({1.0F, 2.0F});
  body->SetAngularVelocity(2.0F);
  coupling.hold(0, 41, *body, {-0.5F, -0.2F});  // where the cord's last point is
  const auto total = [&] {
    return test_support::momentum(coupling.cord(0).thesis()) +
           static_cast<double>(body->GetMass()) * coupling.velocity(*body);
  };
  const Vec2 before = total();
  for (int k = 0; k < 600; ++k) {
    tick(coupling, world);
    const Vec2 now = total();
    ASSERT_EQ(coupling.cord(0).thesis_report().motion_limited, 0);
    ASSERT_NEAR(length(now - before), 0.0, 1e-9 * length(before)) << "tick " << k;
  }
}

TEST(CouplingHold, AHolderThatIsDestroyedLetsGo) {
  Hanging hanging(2.0);
  hanging.run(10);
  hanging.world.DestroyBody(hanging.body);  // without telling the coupling
  hanging.run(10);
  EXPECT_TRUE(test_support::all_finite(hanging.coupling.cord(0).thesis()));

  Hanging told(2.0);
  told.run(10);
  told.coupling.destroy(told.world, *told.body);
  b2Body* next = add_circle(told.world, {5.0, 5.0}, 0.1);  // Box2D likes to use the same address again
  told.run(10);
  EXPECT_FALSE(told.coupling.held_by(*next));
  EXPECT_NEAR(static_cast<double>(next->GetPosition().x), 5.0, 1e-6);
}

TEST(CouplingHold, AHolderThatIsPutFarAwayIsPulledBackWithoutAnExplosion) {
  Hanging hanging(5.0);
  hanging.run(60);
  hanging.body->SetTransform({8.0F, 3.0F}, 0.0F);
  double fastest = 0.0;
  for (int k = 0; k < 600; ++k) {
    hanging.run(1);
    fastest = std::max(fastest, length(hanging.coupling.velocity(*hanging.body)));
  }
  EXPECT_LT(fastest, 60.0);
  EXPECT_LT(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetPosition())), 0.05);
  EXPECT_EQ(test_support::inverted_triangles(hanging.coupling.cord(0).thesis()), 0);
}

TEST(CouplingHold, RefusesWhatDoesNotExist) {
  Hanging hanging(2.0);
  EXPECT_THROW(hanging.coupling.hold(1, 0, *hanging.body, b2Vec2_zero), ribbon::CallError);
  EXPECT_THROW(hanging.coupling.hold(-1, 0, *hanging.body, b2Vec2_zero), ribbon::CallError);
  EXPECT_THROW(hanging.coupling.hold(0, 42, *hanging.body, b2Vec2_zero), ribbon::DefinitionError);
  const b2Vec2 nowhere(std::numeric_limits<float>::quiet_NaN(), 0.0F);
  EXPECT_THROW(hanging.coupling.hold(0, 40, *hanging.body, nowhere), ribbon::DefinitionError);
  EXPECT_EQ(hanging.coupling.held_by(*hanging.body)->point, 40);  // as before
}

/// A fixture may have any friction, and an extent that no coordinate of a cord reaches.
TEST(Coupling, AFixtureOfAnyNumbersIsMetOrLeftOut) {
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
  for (const Vec2 x : coupling.cord(0).positions()) EXPECT_TRUE(is_finite(x));
}

/// So that a tick that cannot be is not half begun.
TEST(Coupling, RefusesATickThatCannotBeAndChangesNothing) {
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

/// Two cords pinned in the same place lie in each other, with an energy that no number tells.
TEST(Coupling, CordsThatLieInEachOtherCanBeSavedAndRestored) {
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

TEST(Coupling, RefusesToDriveACordThatIsNone) {
  ribbon::box2d::Coupling coupling;
  EXPECT_THROW(coupling.cord(0).drag(0, {}), ribbon::CallError);
  coupling.add(ThesisCord(cord_def()));
  EXPECT_THROW(coupling.cord(1).drag(0, {}), ribbon::CallError);
  EXPECT_THROW(coupling.cord(-1).free(0), ribbon::CallError);
}

TEST(Coupling, NothingIsNearToNowhere) {
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(coupling.nearest_point({nan, 0.0}, 10.0));
  EXPECT_FALSE(coupling.nearest_point({0.0, 0.0}, nan));
}

/// The same by a look at every point, between which places of a cord of the direct solver are.
double nearest_distance(const ribbon::box2d::Coupling& coupling, Vec2 position, bool between_points) {
  double nearest = std::numeric_limits<double>::infinity();
  for (ribbon::box2d::CordId c = 0; c < coupling.size(); ++c) {
    const auto x = coupling.cord(c).positions();
    const int rows = coupling.cord(c).shape().rows;
    for (int p = 0; p < static_cast<int>(x.size()); ++p) {
      const auto place_at = [&](double along) { return coupling.position({c, p, 0.0, along}); };
      nearest = std::min(nearest, length(place_at(0.0) - position));
      if (!between_points || p + rows >= static_cast<int>(x.size()) ||
          coupling.cord(c).solver() == ribbon::box2d::Solver::thesis)
        continue;
      const Vec2 link = place_at(1.0) - place_at(0.0);
      const double along = std::clamp(dot(position - place_at(0.0), link) / dot(link, link), 0.0, 1.0);
      nearest = std::min(nearest, length(place_at(along) - position));
    }
  }
  return nearest;
}

TEST(Coupling, FindsWhatALookAtEveryPointFinds) {
  ribbon::box2d::Coupling coupling;
  test_support::Dice dice(7);
  for (int k = 0; k < 40; ++k) {
    ribbon::CordDef def;
    def.points = 9;
    def.length = 2.0;
    def.pins = {0};
    def.allow_sleep = true;
    const Vec2 from{dice(-5.0, 5.0), dice(-5.0, 5.0)};
    const double turn = dice(0.0, 6.0);
    for (int p = 0; p < def.points; ++p)
      def.positions.push_back(from + 0.25 * p * Vec2{std::cos(turn), std::sin(turn)});
    coupling.add(ribbon::Cord(def));
  }
  coupling.add(ThesisCord(cord_def()));
  b2World world({0.0F, -9.81F});
  for (int tick = 0; tick < 60; ++tick) {
    coupling.gather(world, dt);
    coupling.step();
    coupling.apply();
    if (tick % 4 == 0) {  // from outside, between two ticks
      coupling.cord(tick % 40).drag(0, {dice(-6.0, 6.0), dice(-6.0, 6.0)});
      coupling.cord(tick % 39).direct().restore(coupling.cord(tick % 39 + 1).direct().save());
    }
    for (int k = 0; k < 20; ++k) {
      const Vec2 position{dice(-8.0, 8.0), dice(-8.0, 8.0)};
      const double point = nearest_distance(coupling, position, false);
      const double place = nearest_distance(coupling, position, true);
      ASSERT_NEAR(coupling.nearest_point(position, 20.0)->distance, point, 1e-12);
      ASSERT_NEAR(coupling.nearest_place(position, 20.0)->distance, place, 1e-12);
      EXPECT_FALSE(coupling.nearest_point(position, 0.999 * point));
      EXPECT_FALSE(coupling.nearest_place(position, 0.999 * place));
    }
  }
}

TEST(Coupling, FindsTheNearestPointWithinReach) {
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  coupling.add(ThesisCord(cord_def({0.0, 2.0})));
  const auto nearest = coupling.nearest_point({1.0, 1.8}, 0.5);
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->cord, 1);
  EXPECT_EQ(nearest->point, 10);
  EXPECT_NEAR(nearest->distance, 0.1, 1e-12);
  EXPECT_FALSE(coupling.nearest_point({1.0, 1.0}, 0.5));
}

}  // namespace
}  // namespace engine
