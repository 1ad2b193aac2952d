// Wheels of a map, and the ropes around them.

#include <gtest/gtest.h>

#include <string>

#include "engine/scene/scene_tuning.h"
#include "ribbon/box2d/convert.h"
#include "tests/engine/scene/scene_map.h"
#include "tests/support/constants.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using constants::dt;
using ribbon::Vec2;
using ribbon::box2d::PulleyState;
using test_support::says;

MapObject wheel(int id, std::int64_t of_cord, Vec2 position) {
  MapObject object = thing(id, "wheel", MapShape::ellipse, position, {0.5, 0.5});
  object.properties.insert("cord", of_cord);
  return object;
}

MapObject rope(std::vector<Vec2> corners) {
  MapObject object = thing(7, "cord", MapShape::polyline, corners.front());
  object.points = std::move(corners);
  object.properties.insert("columns", std::int64_t{61});
  object.properties.insert("mass", 0.05);
  return object;
}

MapObject weight_at(int id, Vec2 position, double mass) {
  MapObject object = thing(id, "load", MapShape::rectangle, position, {0.3, 0.3});
  object.properties.insert("mass", mass);
  object.properties.insert("cord", std::int64_t{7});
  return object;
}

/// A rope over a wheel at (5, 8) whose ends are at (4.75, 5) and (5.25, 5).
MapObject over_a_wheel() { return rope({{4.75, 5.0}, {5.0, 8.25}, {5.25, 5.0}}); }

TEST(SceneWheel, IsRefusedForARopeAtRest) {
  MapObject at_rest = over_a_wheel();
  at_rest.properties.insert("pin_first", true);
  at_rest.properties.insert("at_rest", true);
  EXPECT_EQ(refusal(map_of({wheel(9, 7, {5.0, 8.0}), at_rest})),
            "test.tmj: object 7: property \"at_rest\" is of a cord without wheels; accepted is one or the other");
}

/// The heavier load pulls the lighter one up to the disc of the wheel.
TEST(SceneWheel, StopsALoadThatReachesIt) {
  Scene scene(map_of(
      {wheel(9, 7, {5.0, 8.0}), weight_at(10, {4.75, 4.85}, 10.0), over_a_wheel(), weight_at(11, {5.25, 4.85}, 30.0)}));
  const b2Body& lifted = *scene.bodies()[0].body;
  const auto distance = [&lifted] { return length(ribbon::box2d::to_double(lifted.GetPosition()) - Vec2{5.0, 8.0}); };
  double nearest = distance();
  int unconverged = 0;
  for (int k = 0; k < 300; ++k) {
    scene.tick(dt);
    nearest = std::min(nearest, distance());
    unconverged += scene.coupling().last_step().report().unconverged;
  }
  EXPECT_EQ(unconverged, 0);
  EXPECT_GT(nearest, 0.25 + 0.15);
  EXPECT_LT(distance(), 0.25 + 0.25);
  EXPECT_NEAR(lifted.GetLinearVelocity().Length(), 0.0F, 1e-3F);
}

/// Atwood's machine: the heavier load falls by (m₂ − m₁)·g/(m₁ + m₂ + I/R²).
TEST(SceneWheel, CarriesARopeWithLoads) {
  MapObject turning = wheel(9, 7, {5.0, 8.0});
  turning.properties.insert("inertia", 2.0 * 0.25 * 0.25);
  Scene scene(map_of({turning, weight_at(10, {4.75, 4.85}, 10.0), over_a_wheel(), weight_at(11, {5.25, 4.85}, 12.0)}));
  ASSERT_EQ(scene.wheels().size(), 1U);
  EXPECT_EQ(scene.wheels()[0].object, 9);
  for (int k = 0; k < 30; ++k) scene.tick(dt);
  const b2Body& falling = *scene.bodies()[1].body;
  const double speed = -static_cast<double>(falling.GetLinearVelocity().y);
  EXPECT_NEAR(speed / (2.0 / 24.0 * 9.81 * 30.0 * dt), 1.0, 0.02);
  const PulleyState state = scene.coupling().pulley(scene.wheels()[0].pulley).state();
  EXPECT_FALSE(state.def.counterclockwise);
  EXPECT_NEAR(state.turning * 0.25, -speed, 0.05 * speed);
}

/// A block on a bight of the rope, which is pinned at both of its ends: half of the weight on each.
TEST(SceneWheel, IsCarriedByALoad) {
  MapObject bight = rope({{4.75, 9.0}, {5.0, 4.75}, {5.25, 9.0}});
  bight.properties.insert("pin_first", true);
  bight.properties.insert("pin_last", true);
  MapObject block = weight_at(10, {5.0, 4.6}, 30.0);
  block.properties = Properties("test.tmj: object 10");
  block.properties.insert("mass", 30.0);
  MapObject sheave = wheel(9, 7, {5.0, 5.0});
  sheave.properties.insert("body", std::int64_t{10});
  Scene scene(map_of({bight, sheave, block}));
  for (int k = 0; k < 240; ++k) scene.tick(dt);
  const PulleyState state = scene.coupling().pulley(scene.wheels()[0].pulley).state();
  EXPECT_TRUE(state.def.counterclockwise);
  EXPECT_NEAR(state.tension_before / (0.5 * 30.0 * 9.81), 1.0, 0.03);
  EXPECT_NEAR(state.tension_after / (0.5 * 30.0 * 9.81), 1.0, 0.03);
}

TEST(SceneWheel, RunsByItsMotor) {
  MapObject drum = wheel(9, 7, {5.0, 8.0});
  drum.properties.insert("motor_speed", 2.0);
  drum.properties.insert("motor_torque", 1000.0);
  drum.properties.insert("turns", std::int64_t{1});
  Scene scene(map_of({over_a_wheel(), drum, weight_at(10, {4.75, 4.85}, 10.0), weight_at(11, {5.25, 4.85}, 10.0)}));
  for (int k = 0; k < 60; ++k) scene.tick(dt);
  EXPECT_NEAR(scene.coupling().pulley(scene.wheels()[0].pulley).state().turning, 2.0, 1e-6);
  EXPECT_NEAR(static_cast<double>(scene.bodies()[1].body->GetLinearVelocity().y), 2.0 * 0.25, 0.02);
}

TEST(SceneWheel, KeepsItsRopeWhileThatIsTuned) {
  MapObject cord = over_a_wheel();
  Scene scene(
      map_of({cord, wheel(9, 7, {5.0, 8.0}), weight_at(10, {4.75, 4.85}, 10.0), weight_at(11, {5.25, 4.85}, 10.0)}));
  for (int k = 0; k < 30; ++k) scene.tick(dt);
  const double length = scene.coupling().cord(0).direct().def().length;
  cord.properties.insert("stretch_stiffness", 1e6);
  retune(scene.coupling(), 0, cord);
  for (int k = 0; k < 60; ++k) scene.tick(dt);
  EXPECT_EQ(scene.coupling().cord(0).direct().def().length, length);
  EXPECT_NEAR(scene.coupling().pulley(scene.wheels()[0].pulley).state().tension_after / (10.0 * 9.81), 1.0, 0.02);
}

TEST(SceneWheel, IsRefusedWhereItCannotBe) {
  const MapObject cord = over_a_wheel();
  EXPECT_TRUE(says(refusal(map_of({cord, wheel(9, 7, {5.0, 6.0})})), "object 9: no corner of its cord, object 7"));
  EXPECT_TRUE(says(refusal(map_of({cord, wheel(9, 7, {5.0, 8.0}), wheel(10, 7, {5.0, 8.1})})),
                   "object 10: is at the same corner of its cord as object 9"));
  EXPECT_TRUE(says(refusal(map_of({rope({{5.0, 5.0}, {5.0, 8.0}, {5.0, 9.0}}), wheel(9, 7, {5.0, 8.0})})),
                   "its cord goes straight on at corner 2"));
  EXPECT_TRUE(
      says(refusal(map_of({rope({{4.75, 5.0}, {5.0, 8.25}, {6.0, 7.0}, {5.25, 5.0}}), wheel(9, 7, {5.0, 8.0})})),
           "object 7: corner 3 of a cord with wheels is at none of them"));
  EXPECT_TRUE(says(refusal(map_of({cord, wheel(9, 8, {5.0, 8.0})})), "and there is no such object"));
  MapObject oval = wheel(9, 7, {5.0, 8.0});
  oval.size.y = 0.4;
  EXPECT_TRUE(says(refusal(map_of({cord, oval})), "the shape of a wheel is ellipse of 0.5 by 0.4 m"));
  MapObject nowhere = wheel(9, 7, {5.0, 8.0});
  nowhere.properties.insert("body", std::int64_t{7});
  EXPECT_TRUE(says(refusal(map_of({cord, nowhere})), "an object of class \"cord\"; accepted is the id of a ground"));
  const MapObject without = thing(9, "wheel", MapShape::ellipse, {5.0, 8.0}, {0.5, 0.5});
  EXPECT_TRUE(says(refusal(map_of({cord, without})), "cord"));
  const MapObject short_rope = rope({{4.8, 8.0}, {5.0, 8.25}, {5.25, 5.0}});
  EXPECT_TRUE(says(refusal(map_of({short_rope, wheel(9, 7, {5.0, 8.0})})), "object 7"));
  MapObject anchor = thing(12, "anchor", MapShape::point, {5.0, 8.25});
  anchor.properties.insert("cord", std::int64_t{7});
  EXPECT_TRUE(says(refusal(map_of({cord, wheel(9, 7, {5.0, 8.0}), anchor})), "is on a wheel"));
  MapObject thesis = over_a_wheel();
  thesis.properties.insert("solver", std::string("thesis"));
  thesis.properties.insert("spring_stiffness", 1e4);
  EXPECT_TRUE(says(refusal(map_of({thesis, wheel(9, 7, {5.0, 8.0})})), "is of the thesis's solver and has a wheel"));
  MapObject ribbon = over_a_wheel();
  ribbon.properties.insert("rows", std::int64_t{2});
  ribbon.properties.insert("stretch_stiffness", 1e4);
  EXPECT_FALSE(refusal(map_of({ribbon, wheel(9, 7, {5.0, 8.0})})).empty());
}

}  // namespace
}  // namespace engine
