#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/contact_world.h"
#include "tests/support/shape_world.h"

// What Box2D pushes through a cord, by its contacts or because the game sets it elsewhere, takes the cord along.

namespace engine {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;
using ribbon::box2d::to_float;
using test_support::bridge_def;
using test_support::position;
using World = test_support::ShapeWorld;

constexpr double sag = 0.55;  // m, about, of the bridge

/// Returns the height of the bridge at x, m.
double bridge_at(const World& scene, double x) {
  const auto points = scene.cord().positions();
  for (std::size_t k = 1; k < points.size(); ++k) {
    if (points[k - 1].x <= x && x < points[k].x) return 0.5 * (points[k - 1].y + points[k].y);
  }
  return 1e9;
}

/// A ball rests on a bridge of a cord, and is set lower. Returns whether it is then still above the cord.
bool stays_above(double way) {
  World scene;
  scene.coupling.add(ribbon::Cord(bridge_def()));
  b2Body* const ball = scene.add_ball({2.05, -sag}, 0.02, 0.05);
  scene.tick(120);
  EXPECT_GT(position(ball).y, bridge_at(scene, position(ball).x));
  ball->SetTransform(to_float(position(ball) - Vec2{0.0, way}), ball->GetAngle());
  scene.tick();
  return position(ball).y > bridge_at(scene, position(ball).x);
}

TEST(PushedBodies, TakeTheCordAlong) {
  EXPECT_TRUE(stays_above(0.05));
  EXPECT_TRUE(stays_above(0.15));
}

TEST(PushedBodies, SetFarAwayAreNotPushed) { EXPECT_FALSE(stays_above(0.3)); }

}  // namespace
}  // namespace engine
