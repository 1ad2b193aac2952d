#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "ribbon/box2d/coupling.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Filters, bodies and fixtures that are created and destroyed, and heap memory.

namespace engine {
namespace {

using ribbon::Cord;
using ribbon::Vec2;
using test_support::add_shape;
using test_support::box;
using test_support::bridge_def;
using test_support::circle;
using test_support::edge;
using test_support::filter;
using test_support::path_length;
using test_support::position;
using World = test_support::ShapeWorld;

using constants::dt;

double stretch(const Cord& cord) { return path_length(cord.positions()) / cord.def().length - 1.0; }

/// Returns whether a bridge with one filter catches a falling box with another.
bool is_caught(const b2Filter& of_cord, const b2Filter& of_box, bool sensor) {
  World scene;
  scene.coupling.add(Cord(bridge_def()), of_cord);
  b2Body* body = scene.add_body({2.0, 0.3});
  add_shape(body, box(0.2, 0.2), 5.0, 0.5, of_box)->SetSensor(sensor);
  scene.tick(90);
  return position(body).y > -3.0;
}

TEST(ContactCord, FiltersAndSensorsActAsBetweenTwoFixtures) {
  EXPECT_TRUE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFF), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFE), filter(1, 0xFFFF), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFD), false));
  EXPECT_TRUE(is_caught(filter(2, 0, 3), filter(1, 0, 3), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF, -3), filter(1, 0xFFFF, -3), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFF), true));
}

/// A dumbbell hangs on the end that collides with the cord; the other end passes through.
TEST(ContactCord, EachFixtureOfABodyCollidesByItsOwnFilter) {
  World scene;
  scene.coupling.add(Cord(bridge_def()), filter(2, 0xFFFF));
  b2Body* body = scene.add_body({2.0, 0.0});
  add_shape(body, circle(0.15, {0.0, 0.2}), 10.0, 0.5);
  add_shape(body, box(0.05, 0.3), 10.0, 0.5, filter(1, 0xFFFD));
  add_shape(body, circle(0.15, {0.0, -0.9}), 10.0, 0.5, filter(1, 0xFFFD));
  scene.tick(300);
  EXPECT_GT(position(body).y, -2.0);
  EXPECT_LT(std::abs(body->GetAngle()), 0.8F);  // upright, with its weight below
}

TEST(ContactCord, BodiesAndFixturesCanBeAddedAndRemovedDuringContact) {
  World scene;
  scene.coupling.add(Cord(bridge_def()));
  add_shape(scene.add_body({2.0, -1.5}, b2_staticBody), box(3.0, 0.1), 0.0, 0.5);
  std::vector<b2Body*> balls;
  std::mt19937 random(7);
  int touched = 0;
  for (int k = 0; k < 240; ++k) {
    if (k % 10 == 0) {
      const double x = 0.5 + 3.0 * (static_cast<double>(random()) / 4294967296.0);
      balls.push_back(scene.add_ball({x, 0.8}, 0.12, 0.5));
      if (k % 20 == 0) add_shape(balls.back(), box(0.2, 0.03), 1.0, 0.5);
    }
    if (k % 10 == 5 && balls.size() > 5) {
      const std::size_t which = random() % balls.size();
      b2Body* body = balls[which];
      if (k % 20 == 5) {
        body->DestroyFixture(body->GetFixtureList());
        add_shape(body, circle(0.1), 5.0, 0.5);
      } else {
        scene.world.DestroyBody(body);
        balls.erase(balls.begin() + static_cast<std::ptrdiff_t>(which));
      }
    }
    scene.tick();
    touched += scene.cord().touches().empty() ? 0 : 1;
    ASSERT_LE(stretch(scene.cord()), 1e-2) << k;
    for (const Vec2 x : scene.cord().positions()) ASSERT_TRUE(is_finite(x) && length(x) < 10.0) << k;
  }
  EXPECT_GT(touched, 150);
  for (b2Body* body : balls) scene.world.DestroyBody(body);
  const double deepest = scene.cord().positions()[20].y;
  scene.tick(30);
  EXPECT_TRUE(scene.cord().touches().empty());
  EXPECT_GT(scene.cord().positions()[20].y, deepest - 2.0);
}

TEST(ContactCord, ATickAfterTheFirstContactAllocatesNothing) {
  World scene;
  scene.coupling.add(Cord(bridge_def()));
  scene.add_ball({1.7, 0.5}, 0.2, 2.0);
  b2Body* body = scene.add_body({2.6, 0.6});
  add_shape(body, box(0.2, 0.1), 20.0, 0.5);
  add_shape(scene.add_body({2.0, -1.0}, b2_staticBody), edge({-1.0, 0.0}, {1.0, 0.1}), 0.0, 0.5);
  scene.tick(600);
  int touched = 0;
  for (int k = 0; k < 240; ++k) {
    const test_support::AllocationCount count;
    scene.step_cords();
    ASSERT_EQ(count.so_far(), 0) << k;
    scene.world.Step(static_cast<float>(dt), 8, 3);
    touched += scene.cord().touches().empty() ? 0 : 1;
  }
  EXPECT_GT(touched, 200);
}

}  // namespace
}  // namespace engine
