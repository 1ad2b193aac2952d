#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/allocations.h"
#include "tests/support/contact_world.h"
#include "tests/support/shape_world.h"

// Box2D's bodies against a cord of the direct solver.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using std::numbers::pi;
using test_support::add_shape;
using test_support::arc;
using test_support::box;
using test_support::circle;
using test_support::edge;
using test_support::position;
using World = test_support::ShapeWorld;

constexpr double dt = World::dt;
constexpr double infinity = std::numeric_limits<double>::infinity();

double stretch(const Cord& cord) {
  double sum = 0.0;
  for (std::size_t p = 1; p < cord.positions().size(); ++p) {
    sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  }
  return sum / cord.def().length - 1.0;
}

/// m, how deep a circle is in the cord; negative if it does not touch.
double depth(const Cord& cord, Vec2 middle, double radius) {
  double nearest = infinity;
  for (std::size_t p = 1; p < cord.positions().size(); ++p) {
    const Vec2 a = cord.positions()[p - 1];
    const Vec2 ab = cord.positions()[p] - a;
    const double along = std::clamp(dot(middle - a, ab) / dot(ab, ab), 0.0, 1.0);
    nearest = std::min(nearest, length(middle - a - along * ab));
  }
  return radius + cord.def().radius - nearest;
}

double furthest(std::span<const Vec2> from, std::span<const Vec2> to) {
  double most = 0.0;
  for (std::size_t p = 0; p < from.size(); ++p) most = std::max(most, length(to[p] - from[p]));
  return most;
}

std::vector<Vec2> copy(std::span<const Vec2> x) { return {x.begin(), x.end()}; }

// --- resting --------------------------------------------------------------------------------------------------------

constexpr double bridge_mass = 0.42;

/// 4.2 m of cord, 4 cm thick, that hangs between pins 4 m apart.
CordDef bridge_def() {
  CordDef def;
  def.points = 41;
  def.length = 4.2;
  def.radius = 0.02;
  def.mass_per_length = 0.1;
  def.friction = 0.5;
  def.positions = arc({0.0, 0.0}, {4.0, 0.0}, 40, 0.105);
  def.pins = {0, 40};
  return def;
}

class Bridge : public testing::TestWithParam<double> {};

TEST_P(Bridge, ABallRestsOnItWithoutDriftOrJitter) {
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
    drift = std::max({drift, length(position(ball) - start), furthest(def.positions, scene.cord().positions())});
    deepest = std::max(deepest, depth(scene.cord(), position(ball), 0.25));
  }
  EXPECT_LE(drift, 1e-4);
  EXPECT_LE(jitter, 1e-4);
  EXPECT_LE(deepest, 0.01 * 2.0 * def.radius + 1e-3);
  EXPECT_FALSE(scene.cord().touches().empty());
  EXPECT_LE(length(scene.coupling.velocity(*ball)), 1e-3);
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
  EXPECT_GT(deepest, 0.0);  // it is carried
}

// --- shapes ----------------------------------------------------------------------------------------------------------

/// A straight cord falls on flat ground of each shape, and lies on it at its radius and Box2D's.
TEST(ContactCord, ItLiesOnEdgesChainsAndBoxes) {
  const auto lies_at = [](const b2Shape& shape, Vec2 ground, b2BodyType type, double angle = 0.0) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.drag = 1.0;
    for (int i = 0; i < 21; ++i) def.positions.push_back({0.1 * i, 0.2});
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

/// Whether the segments from a to b and from c to d cross.
bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p) > 0.0; };
  return side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
}

TEST(ContactCord, ItHangsOverABoxsCornerAndAnEdgesEnd) {
  for (const bool is_box : {true, false}) {
    CordDef def;
    def.points = 41;
    def.length = 4.0;
    def.radius = 0.02;
    def.friction = 0.5;
    def.pins = {0};
    for (int i = 0; i < 41; ++i) def.positions.push_back({-0.5 + 0.1 * i, 0.53});
    World scene;
    scene.coupling.add(Cord(def));
    b2Body* body = scene.add_body({1.0, 0.0}, b2_staticBody);
    is_box ? add_shape(body, box(1.0, 0.5), 0.0, 0.5) : add_shape(body, edge({-1.0, 0.5}, {1.0, 0.5}), 0.0, 0.5);
    for (int k = 0; k < 600; ++k) {
      scene.tick();
      const std::span<const Vec2> x = scene.cord().positions();
      for (std::size_t p = 1; p < x.size(); ++p) {
        ASSERT_FALSE(cross_each_other(x[p - 1], x[p], {0.0, 0.5}, {2.0, 0.5})) << k;
        ASSERT_FALSE(is_box && cross_each_other(x[p - 1], x[p], {2.0, 0.5}, {2.0, -0.5})) << k;
      }
    }
    EXPECT_LT(scene.cord().positions()[40].y, -0.3);
    EXPECT_GT(scene.cord().positions()[20].y, 0.5);
  }
}

// --- momentum --------------------------------------------------------------------------------------------------------

/// To what single precision leaves of it.
TEST(ContactCord, WithBallsInFreeFlightItKeepsItsMomentum) {
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
    for (const b2Body* ball : balls) sum += static_cast<double>(ball->GetMass()) * scene.coupling.velocity(*ball);
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

// --- fast ------------------------------------------------------------------------------------------------------------

/// Whether a ray from p straight up crosses the closed cord an odd number of times.
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

/// How many of so many balls get out of a ring of cord, at so many radii a tick; Box2D takes nothing further than 2 m.
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

TEST(ContactCord, NoBallGetsOutOfARing) {
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 60), 0);
  EXPECT_EQ(escapes(100.0, 0.01, 0.02, 60), 0);
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 20, false), 20);
}

TEST(LongContactCord, NoBallOfAThousandGetsOutOfARing) {
  EXPECT_EQ(escapes(10.0, 0.05, 0.2, 1000), 0);
  EXPECT_EQ(escapes(100.0, 0.01, 0.02, 1000), 0);
}

// --- between a cord and something else
// ---------------------------------------------------------------------------------

enum class Obstacle { wall, grazed_floor, floor, stood_on, ceiling, pit };

struct HeavyRun {
  double gain = 0.0;      ///< J
  double lowest = 0.0;    ///< m
  double stretch = 0.0;   ///< a share
  double leftover = 0.0;  ///< m/s, in the last 100 ticks at most
  double off = 0.0;       ///< m, of the hand from its point
  double scale = 0.0;     ///< J
};

/// 70 kg on the end of 10 m of cord, let go at 70° from the vertical, or on a slack one straight below.
HeavyRun run_into(Obstacle obstacle, double stiffness, int ticks) {
  World scene;
  CordDef def;
  def.points = 51;
  def.length = 10.0;
  def.stretch_stiffness = stiffness;
  def.pins = {0};
  if (obstacle == Obstacle::stood_on) def.drag = 2.0;
  const bool slack = obstacle == Obstacle::stood_on || obstacle == Obstacle::floor;
  const double angle = obstacle == Obstacle::stood_on ? 0.0 : 1.2;
  const double share = slack ? 0.9 : 1.0;
  const Vec2 along{std::sin(angle), -std::cos(angle)};
  for (int i = 0; i < 51; ++i) {
    Vec2 x = (0.2 * i * share) * along;
    if (i % 2 == 1) x += (0.2 * std::sqrt(1.0 - share * share)) * perp(-along);
    def.positions.push_back(x);
  }
  scene.coupling.add(Cord(def));
  b2Body* body = scene.add_ball(def.positions[50], 0.4, 70.0, 0.3);
  body->SetBullet(true);
  body->SetFixedRotation(obstacle == Obstacle::stood_on);  // it does not roll
  scene.coupling.hold(0, 50, *body, {0.0F, 0.0F});
  b2Body* world = scene.add_body({}, b2_staticBody);
  const auto add_wall = [world](Vec2 a, Vec2 b) { add_shape(world, edge(a, b), 0.0, 0.3); };
  double floor = -infinity;
  switch (obstacle) {
    case Obstacle::wall: add_wall({-1.0, -20.0}, {-1.0, 5.0}); break;
    case Obstacle::grazed_floor: floor = -10.2; break;
    case Obstacle::floor: floor = -9.0; break;
    case Obstacle::stood_on: floor = -9.8; break;
    case Obstacle::ceiling: add_wall({-20.0, -8.0}, {-3.0, -8.0}); break;
    case Obstacle::pit:
      add_wall({-1.0, -20.0}, {-1.0, 5.0});
      add_wall({6.0, -20.0}, {6.0, 5.0});
      floor = -10.1;
      break;
  }
  if (floor > -infinity) add_wall({-20.0, floor}, {20.0, floor});
  const double mass = static_cast<double>(body->GetMass());
  const auto energy = [&] {
    const Vec2 v = scene.coupling.velocity(*body);
    const double turning = static_cast<double>(body->GetAngularVelocity());
    return scene.cord().energy({0.0, -9.81}).total() + 0.5 * mass * dot(v, v) + mass * 9.81 * position(body).y +
           0.5 * static_cast<double>(body->GetInertia()) * turning * turning;
  };
  HeavyRun run;
  run.lowest = infinity;
  run.scale = mass * 9.81 * 10.0;
  const double before = energy();
  for (int k = 0; k < ticks; ++k) {
    scene.tick();
    run.gain = std::max(run.gain, energy() - before);
    run.lowest = std::min(run.lowest, position(body).y - floor);
    run.stretch = std::max(run.stretch, stretch(scene.cord()));
    run.off = std::max(run.off, length(scene.cord().positions()[50] - position(body)));
    if (k >= ticks - 100) run.leftover = std::max(run.leftover, length(scene.coupling.velocity(*body)));
  }
  return run;
}

TEST(ContactCord, AHeldBodyHitsWallsAndFloorsAndStands) {
  for (const double stiffness : {1e7, 1e8, infinity}) {
    for (const Obstacle obstacle : {Obstacle::wall, Obstacle::grazed_floor, Obstacle::floor, Obstacle::stood_on,
                                    Obstacle::ceiling, Obstacle::pit}) {
      const HeavyRun run = run_into(obstacle, stiffness, 900);
      SCOPED_TRACE(testing::Message() << "obstacle " << static_cast<int>(obstacle) << ", EA " << stiffness);
      EXPECT_LE(run.gain, 1e-3 * run.scale);
      EXPECT_GE(run.lowest, 0.4 - 0.02);
      EXPECT_LE(run.stretch, stiffness == 1e7 ? 5e-3 : 5e-4);
      EXPECT_LE(run.off, obstacle == Obstacle::pit ? 0.25 : 0.1);
      EXPECT_LE(run.leftover, obstacle == Obstacle::stood_on ? 1e-3 : 20.0);
    }
  }
}

/// A ball that just fits between a taut cord and the ground is pushed up against the cord, and down again.
TEST(ContactCord, ABodyBetweenATautCordAndTheGroundStaysThere) {
  for (const double stiffness : {1e4, 1e6, infinity}) {
    CordDef def = bridge_def();
    def.stretch_stiffness = stiffness;
    for (int i = 0; i < 41; ++i) def.positions[static_cast<std::size_t>(i)] = {0.105 * i, 0.0};
    World scene;
    scene.coupling.add(Cord(def));
    add_shape(scene.add_body({}, b2_staticBody), edge({-10.0, -0.6}, {10.0, -0.6}), 0.0, 0.5);
    b2Body* ball = scene.add_ball({2.0, -0.31}, 0.29, 5.0);
    double highest = -infinity;
    double lowest = infinity;
    for (int k = 0; k < 600; ++k) {
      if (k >= 120) ball->ApplyForceToCenter({0.0F, k < 360 ? 200.0F : -300.0F}, true);
      scene.tick();
      highest = std::max(highest, position(ball).y);
      lowest = std::min(lowest, position(ball).y);
    }
    // By the elasticity twice what 150 N push a straight cord aside: F = 8·EA·(d/L)³.
    const double aside = 2.0 * std::cbrt(150.0 / (8.0 * stiffness)) * def.length;
    EXPECT_LE(highest, -0.29 + aside) << stiffness;
    EXPECT_GE(lowest, -0.6 + 0.29 - 0.01) << stiffness;
    EXPECT_NEAR(position(ball).x, 2.0, 0.5) << stiffness;  // pressed up under the cord it is on a summit, and rolls
    for (const Vec2 x : scene.cord().positions()) EXPECT_GT(x.y, -0.05) << stiffness;
  }
}

TEST(ContactCord, AHeldBodyPushedIntoAWallStays) {
  CordDef def;
  def.points = 31;
  def.length = 3.0;
  def.pins = {0};
  for (int i = 0; i < 31; ++i) def.positions.push_back({0.0, -0.1 * i});
  World scene;
  scene.coupling.add(Cord(def));
  b2Body* body = scene.add_ball({0.0, -3.0}, 0.3, 10.0);
  scene.coupling.hold(0, 30, *body, {0.0F, 0.0F});
  add_shape(scene.add_body({}, b2_staticBody), edge({0.31, -10.0}, {0.31, 10.0}), 0.0, 0.5);
  double furthest_in = -infinity;
  double fastest = 0.0;
  for (int k = 0; k < 600; ++k) {
    body->ApplyForceToCenter({500.0F, 0.0F}, true);
    scene.tick();
    furthest_in = std::max(furthest_in, position(body).x + 0.3 - 0.31);
    if (k > 500) fastest = std::max(fastest, length(scene.coupling.velocity(*body)));
  }
  EXPECT_LE(furthest_in, 0.02);
  EXPECT_LE(fastest, 1e-2);
  EXPECT_LE(stretch(scene.cord()), 1e-3);
}

// --- filters, and what comes and goes
// ---------------------------------------------------------------------------------

b2Filter filter(std::uint16_t category, std::uint16_t mask, std::int16_t group = 0) {
  b2Filter f;
  f.categoryBits = category;
  f.maskBits = mask;
  f.groupIndex = group;
  return f;
}

/// A box falls on a bridge of this filter: whether it is caught.
bool is_caught(const b2Filter& of_cord, const b2Filter& of_box, bool sensor) {
  World scene;
  scene.coupling.add(Cord(bridge_def()), of_cord);
  b2Body* body = scene.add_body({2.0, 0.3});
  add_shape(body, box(0.2, 0.2), 5.0, 0.5, of_box)->SetSensor(sensor);
  scene.tick(90);
  return position(body).y > -3.0;
}

TEST(ContactCord, FiltersAndSensorsDecideAsBetweenTwoFixtures) {
  EXPECT_TRUE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFF), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFE), filter(1, 0xFFFF), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFD), false));
  EXPECT_TRUE(is_caught(filter(2, 0, 3), filter(1, 0, 3), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF, -3), filter(1, 0xFFFF, -3), false));
  EXPECT_FALSE(is_caught(filter(2, 0xFFFF), filter(1, 0xFFFF), true));
}

/// A dumbbell whose one end the cord does not meet hangs on the other.
TEST(ContactCord, EachFixtureOfABodyIsMetByItsOwnFilter) {
  World scene;
  scene.coupling.add(Cord(bridge_def()), filter(2, 0xFFFF));
  b2Body* body = scene.add_body({2.0, 0.0});
  add_shape(body, circle(0.15, {0.0, 0.2}), 10.0, 0.5);
  add_shape(body, box(0.05, 0.3), 10.0, 0.5, filter(1, 0xFFFD));
  add_shape(body, circle(0.15, {0.0, -0.9}), 10.0, 0.5, filter(1, 0xFFFD));
  scene.tick(300);
  EXPECT_GT(position(body).y, -2.0);
  EXPECT_LT(std::abs(body->GetAngle()), 0.8F);  // upright, its weight below
}

TEST(ContactCord, BodiesAndFixturesComeAndGoWhileTheyTouch) {
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

TEST(ContactCord, ATickTakesNoHeapMemoryOnceItHasTouched) {
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
    scene.coupling.gather(scene.world, dt);
    scene.coupling.step();
    scene.coupling.apply();
    ASSERT_EQ(count.so_far(), 0) << k;
    scene.world.Step(static_cast<float>(dt), 8, 3);
    touched += scene.cord().touches().empty() ? 0 : 1;
  }
  EXPECT_GT(touched, 200);
}

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
    for (const Vec2 x : scene.cord().positions()) result.finite = result.finite && is_finite(x);
    for (const Vec2 v : scene.cord().velocities()) result.finite = result.finite && is_finite(v);
    result.alive = result.alive || furthest(shape, scene.cord().positions()) > 1e-3;
  }
  result.unconverged = scene.coupling.cord(0).island_total().unconverged - before;
  return result;
}

/// (Holding, or infinite, it does.)
TEST(ContactCord, AVelocityThatIsNoNumberDoesNotPoisonTheCord) {
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

/// Box2D lets a body turn as fast as it is told to; the cord sees where it is at each moment, and takes no harm.
TEST(ContactCord, ABodyThatSpinsAsFastAsCanBeDoesNotPoisonTheCord) {
  for (const Role role : {Role::touches, Role::holds, Role::drives}) {
    for (const float turning : {1e4F, 1e5F, -1e7F, 1e9F}) {
      const AfterBad after = after_bad(role, {0.0F, 0.0F}, turning);
      EXPECT_TRUE(after.finite && after.alive) << static_cast<int>(role) << " " << turning;
      EXPECT_EQ(after.unconverged, 0) << static_cast<int>(role) << " " << turning;
    }
  }
}

}  // namespace
}  // namespace engine
