#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/grip_table.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/points.h"

// Grips at a bend of their cord.

namespace engine {
namespace {

/// A fold of a rope on a hook hangs still, though its sides are not equally long: one point carries both.
TEST(Grip, HangsStillWhereItIsFoldedOverAHook) {
  GripWorld scene;
  CordDef def = hanging();
  def.pins = {};
  for (std::size_t i = 0; i < def.positions.size(); ++i) {
    const double arc = 0.2 * (static_cast<double>(i) - 20.0);
    def.positions[i] = {i == 20 ? 0.0 : std::copysign(0.005, arc), -std::abs(arc)};
  }
  scene.coupling.add(Cord(def));
  b2Body* hook = scene.add_body({0.0, 0.0}, 1.0, b2_staticBody);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*hook, {.cord = 0, .arc = 4.0, .strength = 0.05});
  scene.tick(300);
  ASSERT_TRUE(scene.coupling.grip(grip).is_valid());
  EXPECT_LE(length(scene.coupling.grip(grip).state().place), 1e-3);
}

/// A rope that leads away from a fixed hook at an angle is pulled through it by its heavier side.
TEST(Grip, LeavesABendOfACordThatRunsThroughAHook) {
  GripWorld scene;
  CordDef def = hanging();
  def.pins = {};
  for (std::size_t i = 0; i < def.positions.size(); ++i) {
    const double arc = 0.2 * (static_cast<double>(i) - 10.0);
    def.positions[i] = i < 10 ? -arc * Vec2{std::sin(0.8), std::cos(0.8)} : Vec2{0.0, -arc};
  }
  scene.coupling.add(Cord(def));
  b2Body* hook = scene.add_body({0.0, 0.0}, 1.0, b2_staticBody);
  const double weight = def.mass_per_length * def.length * g;
  const ribbon::box2d::GripId grip = scene.coupling.hold(*hook, {.cord = 0, .arc = 2.0, .strength = 0.1 * weight});
  scene.tick(20);
  EXPECT_LE(scene.coupling.grip(grip).state().arc, 1.9);
  EXPECT_LE(length(scene.coupling.grip(grip).state().place), 0.05);
}

/// A rope runs through a hook that is fixed, by its own weight less the friction, and drops off it.
TEST(Grip, LetsACordRunThroughAHook) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    GripWorld scene;
    CordDef def = hanging();
    def.pins = {};
    scene.coupling.add(Cord(def));
    const double weight = def.mass_per_length * def.length * g;
    b2Body* hook = scene.add_body({0.0, -4.0}, 1.0, type);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*hook, {.cord = 0, .arc = 4.0, .strength = 0.25 * weight});
    scene.tick(30);
    const double fall = 0.5 * 0.75 * g * 0.5 * 0.5;
    EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 4.0 - fall, 0.01) << type;
    EXPECT_NEAR(length(scene.coupling.grip(grip).state().pull), 0.25 * weight, 1e-3 * weight) << type;
    int ticks = 30;
    for (; ticks < 120 && scene.coupling.grip(grip).is_valid(); ++ticks) scene.tick();
    EXPECT_NEAR(ticks * dt, std::sqrt(2.0 * 4.0 / (0.75 * g)), 0.05) << type;
  }
}

struct SlideInABend {
  double gap = 0.0;     // m, largest distance of the hand from its cord
  double energy = 0.0;  // kinetic at the end, as a share of what the fall gave
};

struct Bend {
  int substeps = 1;
  double strength = 1e-3;  // N
  bool back = false;       // the hand slides towards the first point
};

/// A hand of 70 kg slides down a quarter of a fixed circle of 1.5 m radius and 4.5° a link, at 5 m/s in the end.
SlideInABend slide_in_a_bend(const Bend& bend) {
  GripWorld scene;
  CordDef def = hanging();
  def.points = 41;
  const double link = 2.0 * 1.5 * std::sin(std::numbers::pi / 80.0);
  def.length = 40.0 * link;
  def.accuracy.substeps = bend.substeps;
  def.pins.clear();
  def.positions.clear();
  for (int i = 0; i < def.points; ++i) {
    const double angle = std::numbers::pi * i / 40.0;
    def.pins.push_back(i);
    def.positions.push_back({-1.5 * std::cos(angle), -1.5 * std::sin(angle)});
  }
  const Vec2 start = 0.5 * (def.positions[1] + def.positions[2]);
  if (bend.back) std::reverse(def.positions.begin(), def.positions.end());
  scene.coupling.add(Cord(def));
  b2Body* body = scene.add_body(start, 70.0);
  const double arc = bend.back ? def.length - 1.5 * link : 1.5 * link;
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = arc, .strength = bend.strength});
  const auto is_above = [&] { return body->GetPosition().x < 0.0F; };
  SlideInABend slide;
  for (int k = 0; k < 200 && is_above(); ++k) {
    scene.tick();
    const Vec2 hand = ribbon::box2d::to_double(body->GetPosition());
    slide.gap = std::max(slide.gap, length(scene.coupling.grip(grip).state().place - hand));
  }
  const Vec2 v = scene.coupling.body(*body).velocity();
  slide.energy = 0.5 * dot(v, v) / (g * (start.y - static_cast<double>(body->GetPosition().y)));
  return slide;
}

/// Each link that is passed turns the hand. Were it to slide on along the line of the link that it leaves, the gap
/// would be 12 mm with one substep. What the bends take from the motion is at most (90°)²/40 of it with one substep, as
/// if it were turned by half of each bend, and turned again by the other half in the next substep, each time without
/// rebound.
TEST(Grip, FollowsABend) {
  EXPECT_LE(slide_in_a_bend({1}).gap, 0.5e-3);
  EXPECT_LE(slide_in_a_bend({4}).gap, 0.1e-3);
  for (const int substeps : {1, 8}) {
    const SlideInABend slide = slide_in_a_bend({substeps});
    EXPECT_GE(slide.energy, 1.0 - 0.25 * std::numbers::pi * std::numbers::pi / 40.0 - 0.01) << substeps;
    EXPECT_LE(slide.energy, 1.0) << substeps;
  }
}

TEST(Grip, FollowsABendTheSameWayTowardsBothEnds) {
  const SlideInABend on = slide_in_a_bend({1});
  const SlideInABend back = slide_in_a_bend({.substeps = 1, .back = true});
  EXPECT_NEAR(back.gap, on.gap, 1e-5);
  EXPECT_NEAR(back.energy, on.energy, 1e-3);
}

/// Though it is held ahead of where it is, its friction is that of its strength.
TEST(Grip, IsSlowedInABendByItsStrength) {
  const double quarter = 0.5 * std::numbers::pi * 18.5 / 20.0;  // without the first one and a half links
  const double fall = 1.5 * (1.0 - std::cos(quarter));
  for (const int substeps : {1, 4}) {
    for (const double strength : {50.0, 100.0}) {
      const double loss = slide_in_a_bend({substeps}).energy - slide_in_a_bend({substeps, strength}).energy;
      const double expected = strength * 1.5 * quarter / (70.0 * g * fall);
      EXPECT_NEAR(loss, expected, 0.1 * expected) << substeps << ", " << strength;
    }
  }
}

}  // namespace
}  // namespace engine
