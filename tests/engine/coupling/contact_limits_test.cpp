#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_world.h"
#include "tests/support/coupled_world.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Contact of the direct solver with bodies of Box2D: the hardest cases.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using std::numbers::pi;
using test_support::add_shape;
using test_support::all_finite;
using test_support::box;
using test_support::bridge_def;
using test_support::circle;
using test_support::copy;
using test_support::edge;
using test_support::max_distance;
using World = test_support::ShapeWorld;

using constants::dt;

enum class Role { touches, holds, drives };

struct AfterBad {
  bool finite = true;
  bool alive = false;
  int unconverged = 0;
};

AfterBad after_bad(Role role, b2Vec2 velocity, float turning) {
  World scene;
  scene.coupling.add(Cord(bridge_def()));
  b2Body* body = nullptr;
  if (role == Role::drives) {
    body = scene.add_body({2.0, -0.1}, b2_kinematicBody);
    add_shape(body, circle(0.25), 0.0, 0.5);
  } else {
    body = scene.add_ball({2.0, -0.2}, 0.25, 1.0);
  }
  if (role == Role::holds) scene.coupling.hold(0, 20, *body, {0.0F, 0.0F});
  scene.tick(60);
  AfterBad result;
  body->SetLinearVelocity(velocity);
  body->SetAngularVelocity(turning);
  scene.tick(2);
  scene.coupling.destroy(scene.world, *body);
  const int before = scene.coupling.cord(0).island_total().unconverged;
  const std::vector<Vec2> shape = copy(scene.cord().positions());
  for (int k = 0; k < 60; ++k) {
    scene.tick();
    result.finite = result.finite && all_finite(scene.cord().positions()) && all_finite(scene.cord().velocities());
    result.alive = result.alive || max_distance(shape, scene.cord().positions()) > 1e-3;
  }
  result.unconverged = scene.coupling.cord(0).island_total().unconverged - before;
  return result;
}

/// Some of the cases of the test with the same name in ContactCordLimits.
TEST(ContactCord, AnInvalidVelocityDoesNotSpreadToTheCord) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Role role : {Role::touches, Role::drives}) {
    for (const auto& [velocity, turning] : {std::pair{b2Vec2{nan, 0.0F}, 0.0F},
                                            {b2Vec2{1e30F, 0.0F}, 0.0F},
                                            {b2Vec2{0.0F, 0.0F}, nan},
                                            {b2Vec2{0.0F, 0.0F}, 1e30F}}) {
      const AfterBad after = after_bad(role, velocity, turning);
      EXPECT_TRUE(after.finite && after.alive) << velocity.x << " " << turning;
      EXPECT_EQ(after.unconverged, 0) << velocity.x << " " << turning;
    }
  }
}

/// Box2D accepts every angular velocity. The cord uses the body's momentary position and stays finite.
TEST(ContactCord, TheCordStaysFiniteBesideAVeryFastRotatingBody) {
  for (const Role role : {Role::touches, Role::holds, Role::drives}) {
    for (const float turning : {1e4F, 1e5F, -1e7F, 1e9F}) {
      const AfterBad after = after_bad(role, {0.0F, 0.0F}, turning);
      EXPECT_TRUE(after.finite && after.alive) << static_cast<int>(role) << " " << turning;
      EXPECT_EQ(after.unconverged, 0) << static_cast<int>(role) << " " << turning;
    }
  }
}

TEST(ContactCordLimits, AnInvalidVelocityDoesNotSpreadToTheCord) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  for (const Role role : {Role::touches, Role::holds, Role::drives}) {
    for (const auto& [velocity, turning] : {std::pair{b2Vec2{nan, 0.0F}, 0.0F},
                                            {b2Vec2{inf, 0.0F}, 0.0F},
                                            {b2Vec2{0.0F, inf}, 0.0F},
                                            {b2Vec2{1e30F, 0.0F}, 0.0F},
                                            {b2Vec2{0.0F, 0.0F}, nan},
                                            {b2Vec2{0.0F, 0.0F}, inf},
                                            {b2Vec2{0.0F, 0.0F}, 1e30F}}) {
      const AfterBad after = after_bad(role, velocity, turning);
      SCOPED_TRACE(testing::Message() << "role " << static_cast<int>(role) << ", velocity " << velocity.x << " "
                                      << velocity.y << ", turning " << turning);
      EXPECT_TRUE(after.finite);
      EXPECT_TRUE(after.alive);
      EXPECT_EQ(after.unconverged, 0);
    }
  }
}

/// A tick with more contacts than any tick before.
TEST(ContactCordLimits, OneMoreContactAllocatesNothing) {
  World scene;
  scene.coupling.add(Cord(bridge_def()));
  scene.add_ball({1.7, 0.5}, 0.2, 2.0);
  add_shape(scene.add_body({2.6, 0.6}), box(0.2, 0.1), 20.0, 0.5);
  add_shape(scene.add_body({2.0, -1.0}, b2_staticBody), edge({-1.0, 0.0}, {1.0, 0.1}), 0.0, 0.5);
  scene.tick(240);
  for (int k = 0; k < 240; ++k) {
    const test_support::AllocationCount count;
    scene.step_cords();
    EXPECT_EQ(count.so_far(), 0) << k;
    scene.world.Step(static_cast<float>(dt), 8, 3);
  }
}

/// A force pushes a ball down that is between a taut inextensible cord and the ground. The tolerance of a step, 0.1 mm,
/// is 6 mm/s.
TEST(ContactCordLimits, ABodyThatStandsBetweenATautCordAndTheGroundHasNoVelocity) {
  CordDef def = bridge_def();
  for (int i = 0; i < 41; ++i) def.positions[static_cast<std::size_t>(i)] = {0.105 * i, 0.0};
  World scene;
  scene.coupling.add(Cord(def));
  add_shape(scene.add_body({}, b2_staticBody), edge({-10.0, -0.6}, {10.0, -0.6}), 0.0, 0.5);
  b2Body* ball = scene.add_ball({2.0, -0.31}, 0.29, 5.0);
  double fastest = 0.0;
  for (int k = 0; k < 600; ++k) {
    if (k >= 120) ball->ApplyForceToCenter({0.0F, k < 360 ? 200.0F : -300.0F}, true);
    scene.tick();
    if (k > 500) fastest = std::max(fastest, std::abs(scene.coupling.body(*ball).velocity().y));  // it may roll
  }
  EXPECT_LE(fastest, 2e-3);
}

/// The string of CordContactLimits starts far from the peg's fixture.
TEST(ContactCordLimits, ASnappingStringDoesNotGoThroughAPeg) {
  CordDef def;
  def.points = 41;
  def.length = 2.0;
  def.radius = 0.02;
  def.stretch_stiffness = 1e4;
  def.pins = {0, 40};
  World scene;
  scene.coupling.add(Cord(def));
  for (int k = 1; k <= 80; ++k) {
    scene.coupling.cord(0).drag(20, {1.0, -0.05 * std::min(k, 20)});
    scene.tick();
  }
  const Vec2 peg{1.03, 0.2};
  add_shape(scene.add_body(peg, b2_staticBody), circle(0.1), 0.0, 0.0);
  scene.coupling.cord(0).free(20);
  for (int k = 0; k < 60; ++k) {
    scene.tick();
    bool below = true;
    for (std::size_t p = 1; p < scene.cord().positions().size(); ++p) {
      const Vec2 a = scene.cord().positions()[p - 1];
      const Vec2 b = scene.cord().positions()[p];
      if ((a.x <= peg.x) == (b.x <= peg.x)) continue;
      if (a.y + (b.y - a.y) * (peg.x - a.x) / (b.x - a.x) > peg.y) below = !below;
    }
    ASSERT_TRUE(below) << k;
  }
}

/// The Newton iteration once alternated between both directions of sliding: 17 steps per stage, with halvings.
TEST(ContactCordLimits, FrictionTakesFewNewtonSteps) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    test_support::CordMethod method;
    method.accuracy = accuracy;
    test_support::CoupledWorld world(method);
    test_support::lay_over_circles(world, 0.5);
    ribbon::IslandReport total;
    for (int k = 0; k < 600; ++k) {
      world.tick();
      total += world.coupling.cord(0).island_report();
    }
    EXPECT_LE(total.iterations, 4 * total.stages);
    EXPECT_EQ(total.halvings, 0);
    EXPECT_EQ(total.unconverged, 0);
  }
}

}  // namespace
}  // namespace engine
