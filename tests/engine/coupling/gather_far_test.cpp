#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <new>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/engine/coupling/gather_oracle.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Many cords that are far from everything: one search with the box around a group of them is enough, until something
// comes near one of them.

namespace engine {
namespace {

using constants::dt;
using ribbon::Vec2;
using ribbon::box2d::CordId;
using test_support::Dice;

constexpr int cords = 70;            // more than one group
constexpr double spacing = 3.0;      // m
constexpr int boxes = 300;           // so many that a few distant ones are tested one by one
constexpr double far_away = 1000.0;  // m

/// A row of hanging cords, some of which may sleep, and boxes far away on both sides of them.
struct FarWorld : test_support::ShapeWorld {
  FarWorld() {
    for (int k = 0; k < cords; ++k) {
      ribbon::CordDef def;
      def.points = 6;
      def.length = 1.0;
      def.radius = 0.02;
      def.drag = 1.0;
      def.allow_sleep = k % 2 == 0;
      def.pins = {0};
      def.positions = test_support::equally_spaced(def.points, {spacing * k, 0.0}, {0.0, -0.2});
      coupling.add(ribbon::Cord(def));
    }
    for (int k = 0; k < boxes; ++k) add_box(distant(k), k % 3 == 0 ? b2_dynamicBody : b2_staticBody);
  }
  void add_box(Vec2 place, b2BodyType type) {
    bodies.push_back(add_body(place, type));
    bodies.back()->SetGravityScale(0.0F);
    test_support::add_shape(bodies.back(), test_support::box(0.1, 0.1), 1.0, 0.5);
  }
  static Vec2 distant(int k) { return {k % 2 == 0 ? far_away + k : -far_away - k, 2.0 * (k % 7)}; }
  /// Beside some cord, at most `distance` from it.
  static Vec2 beside_a_cord(Dice& dice, double distance) {
    const int cord = static_cast<int>(dice(0.0, cords - 0.01));
    return {spacing * cord + dice(-distance, distance), dice(-1.0 - distance, distance)};
  }
  b2Body& any(Dice& dice) { return *bodies[static_cast<std::size_t>(dice(0.0, boxes - 0.01))]; }
  /// Moves a box to a cord, or flings one at it.
  void bring_one(Dice& dice) {
    b2Body& body = any(dice);
    body.SetTransform(ribbon::box2d::to_float(beside_a_cord(dice, 4.0)), 0.0F);
    if (body.GetType() == b2_dynamicBody && dice.coin())
      body.SetLinearVelocity({static_cast<float>(dice(-150.0, 150.0)), 0.0F});
  }
  void send_away_all() {
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      bodies[k]->SetLinearVelocity({0.0F, 0.0F});
      bodies[k]->SetTransform(ribbon::box2d::to_float(distant(static_cast<int>(k))), 0.0F);
    }
  }
  /// Gathers, compares with a search of all fixtures, and returns how many were found.
  std::size_t gather_and_compare() {
    const gather_oracle::Speeds speeds = gather_oracle::speeds_in(world);
    coupling.gather(world, dt);
    std::size_t all = 0;
    for (CordId c = 0; c < cords; ++c) {
      const gather_oracle::Found wanted =
          gather_oracle::by_looking_at_all(world, speeds, coupling.cord(c).swept_aabb(), b2Filter(), dt);
      EXPECT_EQ(gather_oracle::by_gather(coupling, c), wanted) << "cord " << c;
      all += wanted.size();
    }
    return all;
  }

  std::vector<b2Body*> bodies;
};

TEST(GatherFar, FindsWhatComesNear) {
  FarWorld far;
  Dice dice(4);
  std::size_t near = 0;
  for (int round = 0; round < 60; ++round) {
    if (round % 5 == 0) {
      far.send_away_all();
      EXPECT_EQ(far.gather_and_compare(), 0U) << "round " << round;
    } else {
      for (int k = 0; k < 4; ++k) far.bring_one(dice);
      near += far.gather_and_compare();
    }
    if (testing::Test::HasFailure()) return;
    far.tick();
  }
  EXPECT_GT(near, 60U);
}

/// It is alone, so nothing else makes its group search for more than bodies at rest.
TEST(GatherFar, FindsAFastBodyBeforeItIsThere) {
  FarWorld far;
  b2Body& body = *far.bodies[0];
  body.SetTransform({static_cast<float>(spacing * 30), 1.5F}, 0.0F);
  EXPECT_EQ(far.gather_and_compare(), 0U);
  body.SetLinearVelocity({0.0F, -150.0F});
  EXPECT_EQ(far.gather_and_compare(), 1U);
}

TEST(GatherFar, WakesACordAtWhichABoxIsPut) {
  FarWorld far;
  far.tick(600);
  ASSERT_TRUE(far.coupling.cord(66).direct().is_asleep());
  far.bodies[1]->SetTransform({static_cast<float>(spacing * 66 + 0.1), -0.5F}, 0.0F);
  far.tick(2);
  EXPECT_FALSE(far.coupling.cord(66).direct().is_asleep());
  EXPECT_GT(far.coupling.cord(66).near_count(), 0);
  EXPECT_TRUE(far.coupling.cord(64).direct().is_asleep());
}

/// The new world is at the address of the old one, and so may its tree be.
TEST(GatherFar, AnotherWorldAtTheSameAddressIsSearched) {
  FarWorld far;
  far.tick(10);
  far.world.~b2World();
  new (&far.world) b2World(b2Vec2(0.0F, -9.81F));
  far.bodies.clear();
  for (int k = 0; k < boxes; ++k) {
    far.add_box(k == 7 ? Vec2{spacing * 5 + 0.1, -0.5} : FarWorld::distant(k),
                k % 3 == 0 ? b2_dynamicBody : b2_staticBody);
  }
  EXPECT_EQ(far.gather_and_compare(), 1U);
}

}  // namespace
}  // namespace engine
