#include "tests/study/figures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/coupled_world.h"
#include "tests/support/points.h"

namespace study {
namespace {

using ribbon::Vec2;
using test_support::depth;
using test_support::penetration;

constexpr double single = 1e-6;  // m, accuracy of positions in Box2D

/// A rope of 2 kg and 2 m along x at height y, pinned at its first point.
ribbon::CordDef rope(double y) {
  ribbon::CordDef def;
  def.points = 5;
  def.length = 2.0;
  def.mass_per_length = 1.0;
  def.radius = 0.1;
  def.positions = test_support::equally_spaced(def.points, {0.0, y}, {0.5, 0.0});
  def.pins = {0};
  return def;
}

b2Fixture& add_box(b2World& world, Vec2 center, double half_width, double half_height, double angle = 0.0) {
  b2BodyDef def;
  def.position = {static_cast<float>(center.x), static_cast<float>(center.y)};
  def.angle = static_cast<float>(angle);
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(half_width), static_cast<float>(half_height));
  return *world.CreateBody(&def)->CreateFixture(&shape, 0.0F);
}

TEST(Figures, DescribeCordsAndBodies) {
  test_support::CoupledWorld world({}, {0.0, -10.0});
  world.add(rope(3.0));
  world.coupling.cord(0).direct().set_velocity(4, {0.0, 4.0});  // an eighth of 2 kg
  b2Body& ball = world.add_circle(b2_dynamicBody, {0.0, -5.0}, 0.5, 4.0, 0.0);
  ball.SetLinearVelocity({3.0F, 0.0F});
  ball.SetAngularVelocity(2.0F);
  const Figures figures = figures_of(world.world, world.coupling, {});
  EXPECT_NEAR(mass_of(world.world, world.coupling), 6.0, single);
  EXPECT_NEAR(figures.momentum.x, 12.0, 10 * single);
  EXPECT_NEAR(figures.momentum.y, 1.0, single);
  const double turning = 0.5 * (0.5 * 4.0 * 0.25) * 4.0;
  EXPECT_NEAR(figures.kinetic, 18.0 + 2.0 + turning, 100 * single);
  EXPECT_NEAR(figures.energy, figures.kinetic + 2.0 * 10.0 * 3.0 - 4.0 * 10.0 * 5.0, 1000 * single);
  EXPECT_EQ(figures.penetration, 0.0);
}

TEST(Figures, TensionIsTheGreatestOfAllLinks) {
  test_support::CoupledWorld world({}, {0.0, -10.0});
  ribbon::CordDef hanging = rope(0.0);
  for (int i = 0; i < hanging.points; ++i) hanging.positions[static_cast<std::size_t>(i)] = {0.0, -0.5 * i};
  world.add(hanging);
  for (int k = 0; k < 5; ++k) world.tick();
  EXPECT_NEAR(figures_of(world.world, world.coupling, {}).tension, 1.75 * 10.0, 1e-3);  // all but the pinned eighth
}

TEST(Figures, ThesisCordsHaveNoTensionPenetrationOrEnergy) {
  b2World world({0.0F, -10.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ribbon::ThesisCord(ribbon::ThesisDef{}));
  const Figures figures = figures_of(world, coupling, {});
  EXPECT_TRUE(std::isnan(figures.tension));
  EXPECT_TRUE(std::isnan(figures.penetration));
  EXPECT_TRUE(std::isnan(figures.energy));
  EXPECT_EQ(figures.kinetic, 0.0);
}

TEST(Figures, PenetrationIsAShareOfTheRadius) {
  test_support::CoupledWorld world({});
  world.add(rope(0.0));
  world.add_circle(b2_staticBody, {1.25, 0.55}, 0.5, 1.0, 0.0);
  EXPECT_NEAR(figures_of(world.world, world.coupling, {}).penetration, 0.5, 10 * single);
  b2Filter none;
  none.maskBits = 0;
  EXPECT_EQ(figures_of(world.world, world.coupling, none).penetration, 0.0);
}

TEST(Penetration, OfAPolygonIsTheDistanceToTheNearestSide) {
  b2World world({0.0F, 0.0F});
  const b2Fixture& box = add_box(world, {0.0, 0.0}, 2.0, 1.0);
  EXPECT_NEAR(depth(box, {-0.5, 0.7}, {0.5, 0.7}), 0.3, single);             // through its top
  EXPECT_NEAR(depth(box, {-0.5, 0.7}, {0.5, 0.2}), 0.8, single);             // the lower end counts
  EXPECT_NEAR(depth(box, {-5.0, 0.9}, {5.0, 0.9}), 0.1, single);             // both ends outside
  EXPECT_NEAR(depth(box, {1.9, 1.1}, {2.1, 0.9}), 0.0, single);              // along a corner
  EXPECT_NEAR(depth(box, {1.8, 1.0}, {2.0, 0.8}), std::sqrt(0.02), single);  // across it
  EXPECT_NEAR(depth(box, {-1.0, 1.5}, {1.0, 1.25}), -0.25, single);
  EXPECT_NEAR(depth(box, {5.0, 5.0}, {8.0, 5.0}), -5.0, single);  // 3 and 4 away from the corner
}

TEST(Penetration, DoesNotDependOnTheRotationOfAPolygon) {
  b2World world({0.0F, 0.0F});
  const b2Fixture& box = add_box(world, {0.0, 0.0}, 2.0, 1.0, std::acos(0.0));
  EXPECT_NEAR(depth(box, {-0.7, -0.5}, {-0.7, 0.5}), 0.3, single);
}

TEST(Penetration, CountsTheRadiusAndTheDeepestOfAll) {
  b2World world({0.0F, 0.0F});
  add_box(world, {0.0, 0.0}, 2.0, 1.0);
  add_box(world, {10.0, 0.0}, 2.0, 1.0);
  const test_support::Outline outline{{{-1.0, 1.05}, {1.0, 1.05}, {10.0, 0.8}}, false, 0.1};
  EXPECT_NEAR(penetration(world, outline, {}), 0.3, 10 * single);
  const test_support::Outline above{{{-1.0, 1.2}, {1.0, 1.2}}, false, 0.1};
  EXPECT_EQ(penetration(world, above, {}), 0.0);
}

}  // namespace
}  // namespace study
