#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Bodies of Box2D against a cord of the direct solver: rest, shapes, momentum, speed.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using std::numbers::pi;
using test_support::add_shape;
using test_support::box;
using test_support::bridge_def;
using test_support::bridge_mass;
using test_support::circle;
using test_support::copy;
using test_support::distance_to_path;
using test_support::edge;
using test_support::max_distance;
using test_support::position;
using test_support::segments_cross;
using World = test_support::ShapeWorld;

using constants::dt;
using constants::infinity;

/// Returns the penetration of a circle into the cord, m; negative if they do not touch.
double depth(const Cord& cord, Vec2 middle, double radius) {
  return radius + cord.def().radius - distance_to_path(middle, cord.positions());
}

class Bridge : public testing::TestWithParam<double> {};

TEST_P(Bridge, HoldsABallWithoutDriftOrJitter) {
  const double mass = GetParam() * bridge_mass;
  CordDef def = bridge_def();
  def.drag = 5.0;
  def.accuracy.tolerance = 1e-9;
  test_support::ContactWorld settled(def);
  settled.add_ball(def.positions[20] + Vec2{0.0, 0.28}, 0.25, mass, 0.5);
  for (int k = 0; k < 1800; ++k) {
    settled.step();
    settled.body(0).velocity = 0.9 * settled.body(0).velocity;
    settled.body(0).angular_velocity *= 0.9;
  }
  def.drag = 0.0;
  def.accuracy = {};
  def.positions = copy(settled.cord.positions());
  World scene;
  scene.coupling.add(Cord(def));
  b2Body* ball = scene.add_ball(settled.body(0).position, 0.25, mass);
  const Vec2 start = position(ball);
  double drift = 0.0;
  double jitter = 0.0;
  double deepest = 0.0;
  for (int k = 0; k < 600; ++k) {
    const Vec2 before = position(ball);
    scene.tick();
    jitter = std::max(jitter, length(position(ball) - before));
    drift = std::max({drift, length(position(ball) - start), max_distance(def.positions, scene.cord().positions())});
    deepest = std::max(deepest, depth(scene.cord(), position(ball), 0.25));
  }
  EXPECT_LE(drift, 1e-4);
  EXPECT_LE(jitter, 1e-4);
  EXPECT_LE(deepest, 0.01 * 2.0 * def.radius + 1e-3);
  EXPECT_FALSE(scene.cord().touches().empty());
  EXPECT_LE(length(scene.coupling.body(*ball).velocity()), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(MassRatios, Bridge, testing::Values(0.01, 0.1, 1.0, 10.0, 100.0));

TEST(ContactCord, ABoxRestsOnABridge) {
  CordDef def = bridge_def();
  def.drag = 5.0;
  World scene;
  scene.coupling.add(Cord(def));
  b2Body* body = scene.add_body({2.0, -0.1});
  body->SetLinearDamping(5.0F);
  body->SetAngularDamping(5.0F);
  add_shape(body, box(0.3, 0.2), 12.5, 0.5);
  scene.tick(1200);
  constexpr double reach = 0.02 + static_cast<double>(b2_polygonRadius);
  double deepest = -infinity;
  const Vec2 start = position(body);
  const float angle = body->GetAngle();
  for (int k = 0; k < 600; ++k) {
    scene.tick();
    for (const Vec2 x : scene.cord().positions()) {
      const Vec2 inside = ribbon::box2d::to_double(body->GetLocalPoint(ribbon::box2d::to_float(x)));
      const Vec2 off{std::max(0.0, std::abs(inside.x) - 0.3), std::max(0.0, std::abs(inside.y) - 0.2)};
      deepest = std::max(deepest, reach - length(off));
    }
    for (const float x : {-0.3F, 0.3F}) {
      deepest = std::max(deepest, depth(scene.cord(), ribbon::box2d::to_double(body->GetWorldPoint({x, -0.2F})),
                                        static_cast<double>(b2_polygonRadius)));
    }
  }
  EXPECT_LE(length(position(body) - start), 1e-4);
  EXPECT_NEAR(body->GetAngle(), angle, 1e-4F);
  EXPECT_LE(deepest, 1e-3);
  EXPECT_GT(deepest, 0.0);  // the cord carries the box
}

/// A straight cord falls on flat ground of each shape, and rests on it at its radius plus that of Box2D.
TEST(ContactCord, RestsOnEdgesChainsAndBoxes) {
  const auto lies_at = [](const b2Shape& shape, Vec2 ground, b2BodyType type, double angle = 0.0) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.drag = 1.0;
    def.positions = test_support::equally_spaced(21, {0.0, 0.2}, {0.1, 0.0});
    World scene;
    scene.coupling.add(Cord(def));
    b2Body* body = scene.add_body(ground, type);
    body->SetTransform(body->GetPosition(), static_cast<float>(angle));
    add_shape(body, shape, 0.0, 0.5);
    scene.tick(300);
    double worst = 0.0;
    for (const Vec2 x : scene.cord().positions()) {
      worst = std::max(worst, std::abs(x.y - def.radius - static_cast<double>(shape.m_radius)));
    }
    EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
    return worst;
  };
  const std::array<b2Vec2, 4> line = {b2Vec2{-3.0F, 0.0F}, {0.5F, 0.0F}, {1.2F, 0.0F}, {5.0F, 0.0F}};
  b2ChainShape chain;
  chain.CreateChain(line.data(), 4, {-4.0F, 0.0F}, {6.0F, 0.0F});
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    EXPECT_LE(lies_at(edge({-3.0, 0.0}, {5.0, 0.0}), {}, type), 1e-4);
    EXPECT_LE(lies_at(chain, {}, type), 1e-4);
    EXPECT_LE(lies_at(box(5.0, 0.5), {0.0, -0.5}, type), 1e-4);
  }
  const std::array<b2Vec2, 4> square = {b2Vec2{-4.0F, -4.0F}, {4.0F, -4.0F}, {4.0F, 4.0F}, {-4.0F, 4.0F}};
  b2ChainShape loop;
  loop.CreateLoop(square.data(), 4);
  for (int side = 0; side < 4; ++side) {  // on each
    EXPECT_LE(lies_at(box(4.0, 4.0), {0.0, -4.0}, b2_staticBody, 0.5 * pi * side), 1e-4) << side;
    EXPECT_LE(lies_at(loop, {0.0, -4.0}, b2_staticBody, 0.5 * pi * side), 1e-4) << side;
  }
}

TEST(ContactCord, HangsOverTheCornerOfABoxAndTheEndOfAnEdge) {
  for (const bool is_box : {true, false}) {
    CordDef def;
    def.points = 41;
    def.length = 4.0;
    def.radius = 0.02;
    def.friction = 0.5;
    def.pins = {0};
    def.positions = test_support::equally_spaced(41, {-0.5, 0.53}, {0.1, 0.0});
    World scene;
    scene.coupling.add(Cord(def));
    b2Body* body = scene.add_body({1.0, 0.0}, b2_staticBody);
    is_box ? add_shape(body, box(1.0, 0.5), 0.0, 0.5) : add_shape(body, edge({-1.0, 0.5}, {1.0, 0.5}), 0.0, 0.5);
    for (int k = 0; k < 600; ++k) {
      scene.tick();
      const std::span<const Vec2> x = scene.cord().positions();
      for (std::size_t p = 1; p < x.size(); ++p) {
        ASSERT_FALSE(segments_cross(x[p - 1], x[p], {0.0, 0.5}, {2.0, 0.5})) << k;
        ASSERT_FALSE(is_box && segments_cross(x[p - 1], x[p], {2.0, 0.5}, {2.0, -0.5})) << k;
      }
    }
    EXPECT_LT(scene.cord().positions()[40].y, -0.3);
    EXPECT_GT(scene.cord().positions()[20].y, 0.5);
  }
}

/// Exact to single precision.
TEST(ContactCord, ConservesMomentumWithBallsInFreeFlight) {
  World scene(Vec2{});
  CordDef def;
  def.points = 31;
  def.length = 3.0;
  def.radius = 0.02;
  def.mass_per_length = 0.5;
  def.accuracy = Accuracy::accurate();
  def.accuracy.tolerance = 1e-9;
  scene.coupling.add(Cord(def));
  const std::array<b2Body*, 3> balls = {scene.add_ball({0.8, 0.7}, 0.2, 0.3), scene.add_ball({1.6, -0.6}, 0.15, 3.0),
                                        scene.add_ball({2.5, 0.9}, 0.25, 1.0)};
  balls[0]->SetLinearVelocity({0.3F, -2.0F});
  balls[1]->SetLinearVelocity({-0.2F, 1.5F});
  balls[2]->SetLinearVelocity({-0.5F, -1.0F});
  balls[2]->SetAngularVelocity(5.0F);
  const auto momentum = [&] {
    Vec2 sum;
    for (int p = 0; p < 31; ++p) sum += scene.cord().mass(p) * scene.cord().velocities()[static_cast<std::size_t>(p)];
    for (const b2Body* ball : balls)
      sum += static_cast<double>(ball->GetMass()) * scene.coupling.body(*ball).velocity();
    return sum;
  };
  const Vec2 before = momentum();
  int touched = 0;
  for (int k = 0; k < 600; ++k) {
    scene.tick();
    touched += scene.cord().touches().empty() ? 0 : 1;
    ASSERT_LE(length(momentum() - before), 1e-7 * length(before)) << k;
  }
  EXPECT_GT(touched, 50);
}

/// Returns whether a ray from p straight up crosses the closed cord an odd number of times.
bool is_in(std::span<const Vec2> cord, Vec2 p) {
  bool in = false;
  for (std::size_t k = 1; k < cord.size(); ++k) {
    const Vec2 a = cord[k - 1];
    const Vec2 b = cord[k];
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    if (a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x) > p.y) in = !in;
  }
  return in;
}

/// Returns how many of `tries` balls leave a ring of cord, with a speed in radii per tick. Box2D limits motion to 2 m
/// per tick.
int escapes(double radii, double least, double most, int tries, bool with_contact = true) {
  int count = 0;
  for (int n = 0; n < tries; ++n) {
    std::mt19937 random(static_cast<unsigned>(n));
    const auto dice = [&random](double low, double high) {
      return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    CordDef def;
    def.points = 41;
    def.length = 4.0;
    def.radius = 0.02;
    def.mass_per_length = 0.25;
    def.friction = dice(0.0, 0.5);
    def.pins = {0, 40};
    for (int i = 0; i < 41; ++i) {
      const double turned = 2.0 * pi * (i % 40) / 40;
      def.positions.push_back(0.635 * Vec2{std::sin(turned), std::cos(turned)});
    }
    World scene;
    scene.coupling.add(Cord(def));
    const double radius = dice(least, most);
    b2Body* ball = scene.add_ball({}, radius, std::pow(10.0, dice(-2.0, 2.0)), 0.4);
    if (!with_contact) ball->GetFixtureList()->SetSensor(true);
    const double angle = dice(0.0, 2.0 * pi);
    ball->SetLinearVelocity(ribbon::box2d::to_float((radii * radius / dt) * Vec2{std::cos(angle), std::sin(angle)}));
    bool out = false;
    for (int k = 0; k < 20 && !out; ++k) {
      scene.tick();
      out = !is_in(scene.cord().positions(), position(ball));
    }
    count += out ? 1 : 0;
  }
  return count;
}

TEST(ContactCord, NoBallEscapesFromARing) {
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 60), 0);
  EXPECT_EQ(escapes(100.0, 0.01, 0.02, 60), 0);
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 20, false), 20);
}

TEST(LongContactCord, NoBallOfAThousandEscapesFromARing) {
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 1000), 0);
  EXPECT_EQ(escapes(100.0, 0.01, 0.02, 1000), 0);
}

}  // namespace
}  // namespace engine
