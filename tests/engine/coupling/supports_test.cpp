#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/supports.h"
#include "ribbon/layout.h"
#include "ribbon/pulley.h"
#include "tests/support/shape_world.h"

// Bodies that hold a cord and that static bodies keep from moving.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Vec2;
using test_support::ShapeWorld;

enum class PresetName { fast, balanced, accurate };

Accuracy accuracy_of(PresetName preset) {
  if (preset == PresetName::fast) return Accuracy::fast();
  return preset == PresetName::balanced ? Accuracy::balanced() : Accuracy::accurate();
}

/// A ball of 1 kg lies on two posts. A cord of 3 m hangs from it between them, with a load at its end.
struct Stopper {
  Stopper(PresetName preset, double load_mass, double drop) {
    for (const double x : {-1.1, 1.1}) {
      test_support::add_shape(scene.add_body({x, 0.0}, b2_staticBody), test_support::box(1.0, 0.1), 0.0, 0.5);
    }
    ball = scene.add_ball({0.0, 0.3}, 0.25, 1.0);
    for (int k = 0; k < 120; ++k) scene.world.Step(static_cast<float>(ShapeWorld::dt), 8, 3);
    start = test_support::position(ball);
    std::vector<Vec2> path{start, start + Vec2{0.0, -3.0}};
    if (drop > 0.0) path = {start, start + Vec2{0.0, -2.5}, start + Vec2{0.05, -2.5}, start + Vec2{0.05, drop - 3.0}};
    load = scene.add_ball(path.back(), 0.3, load_mass);
    ribbon::CordDef def;
    def.points = 31;
    def.mass_per_length = 0.1;
    def.accuracy = accuracy_of(preset);
    ribbon::lay_along(def, path);
    scene.coupling.add(ribbon::Cord(def));
    scene.coupling.hold(0, 0, *ball, {0.0F, 0.0F});
    scene.coupling.hold(0, 30, *load, {0.0F, 0.0F});
  }

  /// Lifts all of it by that many metres.
  void raise(double height) {
    for (b2Body* const body : {ball, load}) {
      body->SetTransform(body->GetPosition() + b2Vec2{0.0F, static_cast<float>(height)}, body->GetAngle());
    }
    ribbon::Cord& cord = scene.coupling.cord(0).direct();
    ribbon::Cord::State state = cord.save();
    for (Vec2& position : state.positions) position.y += height;
    cord.restore(state);
  }

  double gap() const { return length(scene.cord().positions()[0] - test_support::position(ball)); }

  ShapeWorld scene;
  b2Body* ball = nullptr;
  b2Body* load = nullptr;
  Vec2 start;
};

class StopperInAGap : public testing::TestWithParam<std::tuple<PresetName, double, double>> {};
INSTANTIATE_TEST_SUITE_P(Loads, StopperInAGap,
                         testing::Combine(testing::Values(PresetName::fast, PresetName::balanced, PresetName::accurate),
                                          testing::Values(0.1, 1.0, 10.0, 70.0, 1000.0), testing::Values(0.0, 0.95)));

/// Without supports a load of 70 kg drew the cord 1.1 m off the ball, and one of 1,000 kg by 9 to 11 m.
TEST_P(StopperInAGap, HoldsALoadOfAThousandTimesItsMass) {
  const auto [preset, mass, drop] = GetParam();
  Stopper scene(preset, mass, drop);
  double gap = 0.0;
  double moved = 0.0;
  for (int k = 0; k < 300; ++k) {
    scene.scene.tick();
    gap = std::max(gap, scene.gap());
    moved = std::max(moved, length(test_support::position(scene.ball) - scene.start));
  }
  EXPECT_LT(gap, 5e-3);
  EXPECT_LT(moved, 5e-3);
  EXPECT_LT(scene.gap(), 1e-4);
}

/// The same ball, which rebounds, is drawn to the posts by a load that falls. In the tick of the impact Box2D stops it,
/// and the cord goes on. Without supports that it does not touch, it rebounded in each tick: it was thrown 226 m high
/// by a load of 70 kg, and drawn through between the posts by one of 1,000.
class StopperThatRebounds : public testing::TestWithParam<std::tuple<PresetName, double>> {};
INSTANTIATE_TEST_SUITE_P(Loads, StopperThatRebounds,
                         testing::Combine(testing::Values(PresetName::fast, PresetName::balanced, PresetName::accurate),
                                          testing::Values(10.0, 70.0, 1000.0)));

TEST_P(StopperThatRebounds, ComesBackToItsCord) {
  const auto [preset, mass] = GetParam();
  Stopper scene(preset, mass, 0.0);
  scene.ball->GetFixtureList()->SetRestitution(0.5F);
  scene.raise(2.0);
  double gap = 0.0;
  double rebound = 0.0;
  for (int k = 0; k < 600; ++k) {
    scene.scene.tick();
    gap = std::max(gap, scene.gap());
    if (k >= 60) rebound = std::max(rebound, length(test_support::position(scene.ball) - scene.start));
  }
  EXPECT_LT(gap, 0.11);  // what the cord goes on by in one tick, at 6 m/s
  EXPECT_LT(rebound, 0.2);
  EXPECT_LT(scene.gap(), 1e-3);
}

/// A wedge a centimetre below the place where the ball comes to lie. The cord passes it.
struct Wedge {
  bool passes_filter = true;
  bool is_sensor = false;
  bool has_joint = false;  // one with the ball, so that these do not collide
};

/// Returns where a ball that rebounds is in each tick.
std::vector<Vec2> path_over(const std::optional<Wedge>& wedge) {
  Stopper scene(PresetName::balanced, 1000.0, 0.0);
  scene.ball->GetFixtureList()->SetRestitution(0.5F);
  scene.ball->GetFixtureList()->SetFilterData(test_support::filter(3, 0xFFFF));
  if (wedge) {
    b2Body* const body = scene.scene.add_body(scene.start - Vec2{0.0, 0.31}, b2_staticBody);
    const b2Filter filter = test_support::filter(1, wedge->passes_filter ? 2 : 0);
    test_support::add_shape(body, test_support::box(0.05, 0.05), 0.0, 0.5, filter)->SetSensor(wedge->is_sensor);
    if (wedge->has_joint) {
      b2DistanceJointDef slack;
      slack.Initialize(body, scene.ball, body->GetPosition(), scene.ball->GetPosition());
      slack.minLength = 0.0F;
      slack.maxLength = 100.0F;
      scene.scene.world.CreateJoint(&slack);
    }
  }
  scene.raise(2.0);
  std::vector<Vec2> path;
  for (int k = 0; k < 120; ++k) {
    scene.scene.tick();
    path.push_back(test_support::position(scene.ball));
  }
  return path;
}

TEST(Supports, OfABodyStoppedOffItsCordAreOnlyWhatItCollidesWith) {
  const std::vector<Vec2> alone = path_over({});
  EXPECT_NE(path_over(Wedge{}), alone);
  EXPECT_EQ(path_over(Wedge{.is_sensor = true}), alone);
  EXPECT_EQ(path_over(Wedge{.passes_filter = false}), alone);
  EXPECT_EQ(path_over(Wedge{.has_joint = true}), path_over(Wedge{.passes_filter = false, .has_joint = true}));
}

/// The surfaces of these are nearer to each other than the resolution of their places. A normal between equal places
/// was not a number, and the tick threw.
TEST(Supports, OfBodiesThatNearlyTouchHaveNormals) {
  int found = 0;
  for (int k = 0; k < 400; ++k) {
    b2World world({0.0F, 0.0F});
    b2BodyDef def;
    def.position = {7.0F + 0.137F * static_cast<float>(k), 0.0F};
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    world.CreateBody(&def)->CreateFixture(&circle, 0.0F);
    def.type = b2_dynamicBody;
    def.position.x = std::nextafter(def.position.x + 0.3F, 1e3F);
    b2Body* const ball = world.CreateBody(&def);
    circle.m_radius = 0.1F;
    ball->CreateFixture(&circle, 1.0F);
    std::vector<b2Fixture*> memory;
    std::vector<ribbon::box2d::FoundSupport> supports;
    ribbon::box2d::append_supports(*ball, {0.05, memory}, supports);
    for (const ribbon::box2d::FoundSupport& found_one : supports) {
      EXPECT_NEAR(found_one.support.normal.x, 1.0, 1e-12) << k;
      EXPECT_EQ(found_one.support.normal.y, 0.0) << k;
      ++found;
    }
  }
  EXPECT_GT(found, 100);
}

/// A load of 98 N presses a box of 1 kg on a wall. Friction holds it, because Box2D feels the pressure.
TEST(Supports, PressTheirBodiesForFriction) {
  for (const double friction : {0.3, 0.05}) {
    ShapeWorld scene;
    const b2Filter passes = test_support::filter(2, 0xFFFF & ~4);
    test_support::add_shape(scene.add_body({1.0, 0.0}, b2_staticBody), test_support::box(0.5, 5.0), 0.0, friction,
                            passes);
    b2Body* const box = scene.add_body({0.3, 0.0});
    test_support::add_shape(box, test_support::box(0.2, 0.2), 1.0 / 0.16, friction, passes);
    ribbon::CordDef def;
    def.points = 11;
    def.length = 2.0;
    def.mass_per_length = 0.01;
    ribbon::lay_along(def, {{0.3, 0.0}, {2.3, 0.0}});
    ribbon::Cord cord(def);
    cord.set_load(10, {98.0, 0.0});
    scene.coupling.add(std::move(cord), test_support::filter(4, 4));
    scene.coupling.hold(0, 0, *box, {0.0F, 0.0F});
    for (int k = 0; k < 120; ++k) scene.tick();
    const double slid = -test_support::position(box).y;
    if (friction > 0.1) {
      EXPECT_LT(slid, 0.02);  // 29 N are enough for 9.8,
    } else {
      EXPECT_GT(slid, 1.0);  // and 4.9 are not
    }
  }
}

/// A hand draws a box up from the ground, which does not stick.
TEST(Supports, LetABoxBeLifted) {
  ShapeWorld scene;
  test_support::add_shape(scene.add_body({0.0, -0.5}, b2_staticBody), test_support::box(5.0, 0.5), 0.0, 0.5);
  b2Body* const box = scene.add_body({0.0, 0.2});
  test_support::add_shape(box, test_support::box(0.2, 0.2), 10.0 / 0.16, 0.5);
  for (int k = 0; k < 60; ++k) scene.world.Step(static_cast<float>(ShapeWorld::dt), 8, 3);
  const Vec2 start = test_support::position(box);
  ribbon::CordDef def;
  def.points = 11;
  def.length = 2.0;
  def.mass_per_length = 0.1;
  def.pins = {10};
  ribbon::lay_along(def, {start, start + Vec2{0.0, 2.0}});
  scene.coupling.add(ribbon::Cord(def));
  scene.coupling.hold(0, 0, *box, {0.0F, 0.0F});
  for (int k = 1; k <= 60; ++k) {
    scene.coupling.cord(0).direct().constrain(10, start + Vec2{0.0, 2.0 + 0.5 * k * ShapeWorld::dt});
    scene.tick();
    EXPECT_NEAR(test_support::position(box).y - start.y, 0.5 * k * ShapeWorld::dt, 2e-3) << k;
  }
}

/// A box that stands with less than half of itself on a ledge tips over it, drawn by its cord.
TEST(Supports, LetABoxTipOverALedge) {
  ShapeWorld scene;
  test_support::add_shape(scene.add_body({-5.0, -0.5}, b2_staticBody), test_support::box(5.0, 0.5), 0.0, 0.5);
  b2Body* const box = scene.add_body({0.05, 0.2});
  test_support::add_shape(box, test_support::box(0.2, 0.2), 1.0 / 0.16, 0.5);
  b2Body* const load = scene.add_ball({0.2, -1.0}, 0.1, 20.0);
  ribbon::CordDef def;
  def.points = 11;
  def.length = 1.1;
  def.mass_per_length = 0.1;
  ribbon::lay_along(def, {{0.2, 0.1}, {0.2, -1.0}});
  scene.coupling.add(ribbon::Cord(def));
  scene.coupling.hold(0, 0, *box, {0.15F, -0.1F});
  scene.coupling.hold(0, 10, *load, {0.0F, 0.0F});
  for (int k = 0; k < 60; ++k) scene.tick();
  EXPECT_LT(test_support::position(box).y, -0.5);
}

/// A platform that rises carries a box and the load that hangs on it.
TEST(Supports, OfAKinematicBodyRiseWithIt) {
  ShapeWorld scene;
  std::vector<b2Body*> platforms;
  for (const double x : {-1.1, 1.1}) {
    platforms.push_back(scene.add_body({x, 0.0}, b2_kinematicBody));
    test_support::add_shape(platforms.back(), test_support::box(1.0, 0.1), 0.0, 0.5);
  }
  b2Body* const box = scene.add_body({0.0, 0.2});
  test_support::add_shape(box, test_support::box(0.4, 0.1), 1.0 / 0.16, 0.5);
  b2Body* const load = scene.add_ball({0.0, -1.8}, 0.2, 100.0);
  ribbon::CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.mass_per_length = 0.1;
  ribbon::lay_along(def, {{0.0, 0.2}, {0.0, -1.8}});
  scene.coupling.add(ribbon::Cord(def));
  scene.coupling.hold(0, 0, *box, {0.0F, 0.0F});
  scene.coupling.hold(0, 20, *load, {0.0F, 0.0F});
  for (int k = 0; k < 60; ++k) scene.tick();
  for (b2Body* platform : platforms) platform->SetLinearVelocity({0.0F, 1.0F});
  for (int k = 0; k < 60; ++k) scene.tick();
  EXPECT_NEAR(test_support::position(box).y, 1.2, 0.02);
  EXPECT_NEAR(test_support::position(load).y, -0.8, 0.02);
  EXPECT_LT(length(scene.cord().positions()[0] - test_support::position(box)), 1e-2);
}

/// The block of a pulley lies on two posts. Both loads hang from it through the gap.
TEST(Supports, HoldTheBlockOfAPulley) {
  ShapeWorld scene;
  for (const double x : {-1.3, 1.3}) {
    test_support::add_shape(scene.add_body({x, 0.0}, b2_staticBody), test_support::box(1.0, 0.1), 0.0, 0.5);
  }
  b2Body* const block = scene.add_body({0.0, 0.3});
  test_support::add_shape(block, test_support::box(0.6, 0.2), 1.0 / 0.48, 0.5, test_support::filter(2, 0xFFFF & ~4));
  for (int k = 0; k < 60; ++k) scene.world.Step(static_cast<float>(ShapeWorld::dt), 8, 3);
  const Vec2 start = test_support::position(block);
  const ribbon::PulleyDef wheel{.center = start, .radius = 0.15, .counterclockwise = false, .inertia = 0.01};
  const ribbon::ReevedCord reeved = ribbon::reeve(start + Vec2{-0.15, -1.8}, {&wheel, 1}, start + Vec2{0.15, -1.8}, 41);
  ribbon::CordDef def;
  def.points = 41;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.mass_per_length = 0.1;
  const ribbon::box2d::CordId cord = scene.coupling.add(ribbon::Cord(def), test_support::filter(4, 4));
  const ribbon::box2d::PulleyId pulley = scene.coupling.add_pulley(cord, *block, reeved.pulleys[0]);
  b2Body* const left = scene.add_ball(reeved.positions.front(), 0.1, 50.0);
  b2Body* const right = scene.add_ball(reeved.positions.back(), 0.1, 50.0);
  scene.coupling.hold(cord, 0, *left, {0.0F, 0.0F});
  scene.coupling.hold(cord, 40, *right, {0.0F, 0.0F});
  const double height = test_support::position(left).y;
  for (int k = 0; k < 120; ++k) scene.tick();
  EXPECT_LT(length(test_support::position(block) - start), 5e-3);
  EXPECT_NEAR(test_support::position(left).y, height, 1e-2);
  EXPECT_NEAR(test_support::position(right).y, height, 1e-2);
  EXPECT_TRUE(scene.coupling.pulley(pulley).is_valid());
}

}  // namespace
}  // namespace engine
