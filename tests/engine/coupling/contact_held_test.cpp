#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Bodies between a wall and a cord that they hold or touch.

namespace engine {
namespace {

using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using test_support::add_shape;
using test_support::bridge_def;
using test_support::edge;
using test_support::path_length;
using test_support::position;
using World = test_support::ShapeWorld;

using constants::infinity;

double stretch_of(const Cord& cord) { return path_length(cord.positions()) / cord.def().length - 1.0; }

enum class Obstacle { wall, grazed_floor, floor, stood_on, ceiling, pit };

struct HeavyRun {
  double gain = 0.0;      ///< J
  double lowest = 0.0;    ///< m
  double stretch = 0.0;   ///< relative
  double leftover = 0.0;  ///< m/s, maximum in the last 100 ticks
  double off = 0.0;       ///< m, distance of the anchor from its point
  double scale = 0.0;     ///< J
};

CordDef cord_for(Obstacle obstacle, double stiffness) {
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
  return def;
}

/// Adds the edges of an obstacle. Returns the height of its floor [m], or −infinity.
double add_obstacle(World& scene, Obstacle obstacle) {
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
  return floor;
}

/// 70 kg at the end of 10 m of cord: released at 70° from the vertical, or straight below with a slack cord.
HeavyRun run_into(Obstacle obstacle, double stiffness, int ticks) {
  World scene;
  const CordDef def = cord_for(obstacle, stiffness);
  scene.coupling.add(Cord(def));
  b2Body* body = scene.add_ball(def.positions[50], 0.4, 70.0, 0.3);
  body->SetBullet(true);
  body->SetFixedRotation(obstacle == Obstacle::stood_on);  // it does not roll
  scene.coupling.hold(0, 50, *body, {0.0F, 0.0F});
  const double floor = add_obstacle(scene, obstacle);
  const double mass = static_cast<double>(body->GetMass());
  const auto energy = [&] {
    const Vec2 v = scene.coupling.body(*body).velocity();
    const double turning = static_cast<double>(body->GetAngularVelocity());
    return energy_of(scene.cord(), {0.0, -9.81}).total() + 0.5 * mass * dot(v, v) + mass * 9.81 * position(body).y +
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
    run.stretch = std::max(run.stretch, stretch_of(scene.cord()));
    run.off = std::max(run.off, length(scene.cord().positions()[50] - position(body)));
    if (k >= ticks - 100) run.leftover = std::max(run.leftover, length(scene.coupling.body(*body).velocity()));
  }
  return run;
}

TEST(ContactCord, AHeldBodyHitsWallsAndFloorsAndComesToRest) {
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

/// A ball that just fits between a taut cord and the ground is pushed up against the cord, and then down.
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
    // Twice the deflection d of an elastic straight cord under 150 N: F = 8·EA·(d/L)³.
    const double aside = 2.0 * std::cbrt(150.0 / (8.0 * stiffness)) * def.length;
    EXPECT_LE(highest, -0.29 + aside) << stiffness;
    EXPECT_GE(lowest, -0.6 + 0.29 - 0.01) << stiffness;
    EXPECT_NEAR(position(ball).x, 2.0, 0.5) << stiffness;  // below the cord its equilibrium is unstable, and it rolls
    for (const Vec2 x : scene.cord().positions()) EXPECT_GT(x.y, -0.05) << stiffness;
  }
}

TEST(ContactCord, AHeldBodyPushedIntoAWallStays) {
  CordDef def;
  def.points = 31;
  def.length = 3.0;
  def.pins = {0};
  def.positions = test_support::equally_spaced(31, {0.0, 0.0}, {0.0, -0.1});
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
    if (k > 500) fastest = std::max(fastest, length(scene.coupling.body(*body).velocity()));
  }
  EXPECT_LE(furthest_in, 0.02);
  EXPECT_LE(fastest, 1e-2);
  EXPECT_LE(stretch_of(scene.cord()), 1e-3);
}

}  // namespace
}  // namespace engine
