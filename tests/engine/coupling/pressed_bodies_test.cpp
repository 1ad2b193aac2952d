#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "ribbon/box2d/coupling.h"
#include "ribbon/layout.h"
#include "tests/support/shape_world.h"

// Light bodies between a cord and what Box2D presses them on.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Vec2;
using test_support::ShapeWorld;

class PressedBody : public testing::TestWithParam<Accuracy (*)()> {};
INSTANTIATE_TEST_SUITE_P(Presets, PressedBody,
                         testing::Values(&Accuracy::fast, &Accuracy::balanced, &Accuracy::accurate));

/// A cord with 500 kg at either end hangs over a box of 1 kg that stands on a post. When only Box2D knew of the post,
/// the loads fell, and drew the cord through the box.
TEST_P(PressedBody, IsNotPressedThroughTheGround) {
  ShapeWorld scene;
  test_support::add_shape(scene.add_body({0.0, -2.0}, b2_staticBody), test_support::box(0.1, 2.0), 0.0, 0.5);
  b2Body* const box = scene.add_body({0.0, 0.2});
  test_support::add_shape(box, test_support::box(0.4, 0.2), 1.0 / 0.32, 0.5);
  for (int k = 0; k < 30; ++k) scene.world.Step(static_cast<float>(ShapeWorld::dt), 8, 3);
  ribbon::CordDef def;
  def.points = 61;
  def.mass_per_length = 0.1;
  def.radius = 0.02;
  def.accuracy = GetParam()();
  ribbon::lay_along(def, {{-0.44, -1.0}, {-0.44, 0.44}, {0.44, 0.44}, {0.44, -1.0}});
  b2Body* const left = scene.add_ball(def.positions.front(), 0.1, 500.0);
  b2Body* const right = scene.add_ball(def.positions.back(), 0.1, 500.0);
  scene.coupling.add(ribbon::Cord(def));
  scene.coupling.hold(0, 0, *left, {0.0F, 0.0F});
  scene.coupling.hold(0, 60, *right, {0.0F, 0.0F});
  double sunk = 0.0;
  for (int k = 0; k < 120; ++k) {
    scene.tick();
    sunk = std::max(sunk, 0.2 - test_support::position(box).y);
  }
  EXPECT_LT(sunk, 0.01);
  EXPECT_GT(test_support::position(left).y, -1.1);
  EXPECT_GT(test_support::position(right).y, -1.1);
}

/// A box of 500 kg pushes one of 1 kg against a taut cord. When only Box2D knew of the heavy one, it pushed the light
/// one through.
TEST_P(PressedBody, IsHeldByTheCordForWhatIsBehindIt) {
  ShapeWorld scene({0.0, 0.0});
  ribbon::CordDef def;
  def.points = 41;
  def.mass_per_length = 0.1;
  def.radius = 0.02;
  def.accuracy = GetParam()();
  def.pins = {0, 40};
  ribbon::lay_along(def, {{0.0, -1.0}, {0.0, 1.0}});
  scene.coupling.add(ribbon::Cord(def));
  b2Body* const light = scene.add_body({0.25, 0.0});
  test_support::add_shape(light, test_support::box(0.1, 0.1), 1.0 / 0.04, 0.5);
  b2Body* const heavy = scene.add_body({0.8, 0.0});
  test_support::add_shape(heavy, test_support::box(0.3, 0.3), 500.0 / 0.36, 0.5);
  heavy->SetLinearVelocity({-2.0F, 0.0F});
  double least = 1.0;
  for (int k = 0; k < 120; ++k) {
    scene.tick();
    least = std::min(least, test_support::position(light).x);
  }
  EXPECT_GT(least, 0.05);
}

}  // namespace
}  // namespace engine
