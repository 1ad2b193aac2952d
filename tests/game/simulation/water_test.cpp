// Bodies float in the water of a level, and the player swims.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

constexpr double level_of_water = 8.0;  // m

engine::TiledMap sea(std::vector<MapObject> objects, Vec2 feet = {3.0, 2.0}) {
  engine::TiledMap map = small_map(std::move(objects), feet);
  map.properties.insert("water_level", level_of_water);
  return map;
}

MapObject crate_at(Vec2 center, double mass) { return crate(center - Vec2{0.0, 0.5}, {1.0, 1.0}, mass); }

b2Body& first_load(Simulation& simulation) {
  for (const engine::SceneBody& made : simulation.scene().bodies())
    if (made.kind != engine::BodyKind::ground) return *made.body;
  throw std::logic_error("the level has no load");
}

TEST(Submerged, IsThePartOfABodyBelowALevel) {
  b2World world({0.0F, 0.0F});
  b2BodyDef definition;
  definition.position = {1.0F, 2.0F};
  b2Body& body = *world.CreateBody(&definition);
  b2CircleShape circle;
  circle.m_radius = 0.5F;
  body.CreateFixture(&circle, 1.0F);
  const double area = 0.25 * std::numbers::pi;
  EXPECT_NEAR(submerged(body, 2.0).area, 0.5 * area, 1e-6);
  EXPECT_NEAR(submerged(body, 9.0).area, area, 1e-6);
  EXPECT_EQ(submerged(body, 1.0).area, 0.0);
  EXPECT_NEAR(submerged(body, 2.0).center.y, 2.0 - 4.0 * 0.5 / (3.0 * std::numbers::pi), 3e-3);
}

/// It displaces its own mass: 70 kg a metre of depth of a crate 1 m wide.
TEST(Water, ACrateFloatsByWhatItDisplaces) {
  const Level level = level_of(sea({crate_at({10.0, 8.3}, 35.0)}));
  Simulation simulation(level);
  run(simulation, 900);
  EXPECT_NEAR(static_cast<double>(first_load(simulation).GetPosition().y), level_of_water, 0.02);
  EXPECT_LT(first_load(simulation).GetLinearVelocity().Length(), 0.02F);
}

TEST(Water, AHeavyCrateSinksSlowly) {
  const Level level = level_of(sea({crate_at({10.0, 7.0}, 200.0)}));
  Simulation simulation(level);
  run(simulation, 60);
  const double fallen = 7.0 - static_cast<double>(first_load(simulation).GetPosition().y);
  EXPECT_GT(fallen, 0.5);
  EXPECT_LT(fallen, 3.0) << "in air it would be 4.9 m";
}

TEST(Water, ALightBallRisesWithoutLeapingOut) {
  MapObject ball = disc_of(20, "circle", {10.0, 5.0}, 0.4);
  const Level level = level_of(sea({ball}));
  Simulation simulation(level);
  run(simulation, 6);
  EXPECT_GT(first_load(simulation).GetLinearVelocity().y, 0.5F);
  EXPECT_LT(first_load(simulation).GetLinearVelocity().y, 0.99F) << "it moves water along: g at most, in 0.1 s";
  double highest = 0.0;
  for (int k = 0; k < 600; ++k) {
    run(simulation, 1);
    highest = std::max(highest, static_cast<double>(first_load(simulation).GetPosition().y));
  }
  EXPECT_LT(highest, level_of_water + 1.2);
  EXPECT_NEAR(static_cast<double>(first_load(simulation).GetPosition().y), level_of_water + 0.4, 0.1);
}

TEST(Water, ThePlayerFloatsWithItsHeadOutAndLeapsOut) {
  const Level level = level_of(sea({}, {10.0, 5.0}));
  Simulation simulation(level);
  run(simulation, 300);
  const double y = simulation.player().position().y;
  EXPECT_GT(y + 0.75, level_of_water + 0.1) << "its head is out";
  EXPECT_LT(y, level_of_water);
  EXPECT_EQ(simulation.falls(), 0);
  double highest = y;
  for (int k = 0; k < 60; ++k) {
    run(simulation, 1, button_jump);
    highest = std::max(highest, simulation.player().position().y);
  }
  EXPECT_GT(highest, y + 0.7) << "it leaps";
  run(simulation, 120, button_right);
  EXPECT_GT(simulation.player().position().x, 11.5) << "it swims";
  EXPECT_LT(simulation.player().body().GetLinearVelocity().x, 4.0F) << "slower than it runs";
}

TEST(Water, DoesNothingAboveItsSurface) {
  const Level wet = level_of(sea({crate_at({10.0, 15.0}, 35.0)}, {3.0, 12.0}));
  const Level dry = level_of(small_map({crate_at({10.0, 15.0}, 35.0)}, {3.0, 12.0}));
  Simulation one(wet);
  Simulation other(dry);
  run(one, 30, button_right);
  run(other, 30, button_right);
  EXPECT_EQ(one.player().position(), other.player().position());
  EXPECT_EQ(first_load(one).GetPosition(), first_load(other).GetPosition());
}

TEST(Water, GoesBackAndIsAsAtTheStartAfterAFall) {
  const Level level = level_of(sea({crate_at({10.0, 8.3}, 35.0), hanging_rope(10, {10.0, 12.0})}, {10.0, 5.0}));
  expect_goes_back(level, 200, {button_right, button_right | button_jump, 0, 0, button_jump});
  Simulation simulation(level);
  run(simulation, 30, button_jump);
  run(simulation, 1, button_retry);
  Simulation fresh(level);
  run(fresh, 1, button_retry);
  EXPECT_EQ(first_load(simulation).GetPosition(), first_load(fresh).GetPosition());
}

}  // namespace
}  // namespace game
