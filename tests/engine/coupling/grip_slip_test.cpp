#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/grip_table.h"
#include "ribbon/cord_forces.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/points.h"

// Grips that slip along their cord.

namespace engine {
namespace {

using test_support::all_finite;

/// The body slides down with the acceleration g − F/m.
TEST(Grip, SlipsAgainstItsStrength) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  scene.coupling.cord(0).direct().attach_mass(50, 20.0);  // keeps the cord straight
  b2Body* body = scene.add_body({0.0, -3.0}, 70.0);
  const double mass = static_cast<double>(body->GetMass());
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 3.0, .strength = 500.0});
  scene.tick(48);
  const double fall = 0.5 * (g - 500.0 / mass) * 0.8 * 0.8;
  EXPECT_TRUE(scene.coupling.grip(grip).state().slips);
  EXPECT_NEAR(scene.coupling.grip(grip).state().pull.y, 500.0, 1.0);
  EXPECT_NEAR(body->GetPosition().y, -3.0 - fall, 1e-3);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 3.0 + fall, 1e-3);
}

/// A solve that uses the line search from its first step on has the same result: one body, held by two cords, slips.
TEST(Grip, SlipsTheSameByTheLineSearch) {
  const auto slid = [](int max_iterations, int& searches) {
    GripWorld scene;
    for (const double x : {-0.5, 0.5}) {
      CordDef def = hanging(x);
      def.accuracy.max_iterations = max_iterations;
      scene.coupling.add(Cord(def));
      scene.coupling.cord(scene.coupling.size() - 1).direct().attach_mass(50, 20.0);
    }
    b2Body* body = scene.add_body({0.0, -3.0}, 70.0);
    scene.coupling.hold(*body, {.cord = 0, .arc = 3.0, .local_anchor = {-0.5F, 0.0F}, .strength = 200.0});
    const ribbon::box2d::GripId other =
        scene.coupling.hold(*body, {.cord = 1, .arc = 3.0, .local_anchor = {0.5F, 0.0F}, .strength = 200.0});
    scene.tick(30);
    searches = scene.coupling.cord(0).island_total().searches;
    EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
    EXPECT_TRUE(scene.coupling.grip(other).state().slips);
    return scene.coupling.grip(other).state().arc;
  };
  int by_newton = 0;
  int by_search = 0;
  const double full = slid(8, by_newton);
  EXPECT_NEAR(full, 3.0 + 0.5 * (g - 400.0 / 70.0) * 0.5 * 0.5, 0.02);
  EXPECT_NEAR(slid(1, by_search), full, 1e-2);
  EXPECT_GT(by_search, by_newton + 20);
}

/// A grip that may slip draws the cord to a hand that is beside it as one that may not.
TEST(Grip, CatchesTheSameWhetherItMaySlipOrNot) {
  const auto caught = [](double strength, double& gap) {
    GripWorld scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.2, -5.0}, 70.0);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 5.0, .strength = strength});
    scene.tick(5);
    gap = length(ribbon::box2d::to_double(body->GetWorldCenter()) - scene.coupling.grip(grip).state().place);
    scene.tick(115);
    return ribbon::box2d::to_double(body->GetWorldCenter());
  };
  double gap = 0.0;  // m, after five ticks
  const Vec2 fixed = caught(std::numeric_limits<double>::infinity(), gap);
  EXPECT_LE(gap, 1e-5);
  const Vec2 strong = caught(5000.0, gap);
  EXPECT_LE(gap, 1e-5);
  EXPECT_LE(length(strong - fixed), 0.01);
}

/// A heavy body slides down a slack rope, to and fro past the bend at its bottom. The line of the link that it leaves
/// runs below the next link. What pulled it onto that link in one tick, as if by work of its own, threw it 200 m away.
TEST(Grip, GainsNoEnergyWhereItSlipsPastABend) {
  for (const ribbon::Accuracy& accuracy :
       {ribbon::Accuracy::fast(), ribbon::Accuracy::balanced(), ribbon::Accuracy::accurate()}) {
    GripWorld scene;
    CordDef def;
    def.points = 9;
    def.length = 4.8;
    def.pins = {0, 8};
    def.accuracy = accuracy;
    for (int i = 0; i < 9; ++i) def.positions.push_back({0.48 * (i - 4), 0.36 * std::abs(i - 4)});
    scene.coupling.add(Cord(def));
    constexpr double mass = 40.0;  // kg
    const b2Vec2 hand{0.05F, 0.2F};
    b2Body* body = scene.add_body({-0.7, 0.3}, mass);
    const ribbon::box2d::GripId grip =
        scene.coupling.hold(*body, {.cord = 0, .arc = 1.5, .local_anchor = hand, .strength = 8.0});
    const auto energy = [&] {
      const ribbon::box2d::BodyView view = scene.coupling.body(*body);
      const double turning = view.angular_velocity() * view.angular_velocity();
      const Vec2 center = ribbon::box2d::to_double(body->GetWorldCenter());
      return 0.5 * (mass * dot(view.velocity(), view.velocity()) + static_cast<double>(body->GetInertia()) * turning) +
             mass * g * center.y + energy_of(scene.coupling.cord(0).direct(), {0.0, -g}).total();
    };
    double gain = 0.0;  // J, the largest of a tick
    double gap = 0.0;   // m
    double slid = 0.0;  // m
    scene.tick();
    for (int k = 0; k < 600; ++k) {
      const double before = energy();
      const double arc = scene.coupling.grip(grip).state().arc;
      scene.tick();
      const ribbon::box2d::GripState now = scene.coupling.grip(grip).state();
      slid += std::abs(now.arc - arc);
      gain = std::max(gain, energy() - before);
      gap = std::max(gap, length(ribbon::box2d::to_double(body->GetWorldPoint(hand)) - now.place));
    }
    EXPECT_GT(slid, 2.0);
    EXPECT_LE(gain, 2e-3 * mass * g * def.length);
    EXPECT_LE(gap, 1e-3);
  }
}

/// A body that slips off the free end of its cord has lost it, and falls freely.
TEST(Grip, IsReleasedWhereItSlipsOffAnEnd) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -9.9}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.9, .strength = 200.0});
  int ticks = 0;
  for (; ticks < 60 && scene.coupling.grip(grip).is_valid(); ++ticks) scene.tick();
  EXPECT_NEAR(ticks * dt, std::sqrt(2.0 * 0.1 / (g - 200.0 / 70.0)), 0.02);
  EXPECT_FALSE(scene.coupling.body(*body).held_place().has_value());
  const float before = body->GetLinearVelocity().y;
  scene.tick(6);
  EXPECT_NEAR(body->GetLinearVelocity().y - before, -6 * g * dt, 1e-4);
}

/// At an end that is pinned, or held by another body, it stops.
TEST(Grip, StopsAtAnEndThatIsFixed) {
  for (const bool pinned : {true, false}) {
    GripWorld scene;
    CordDef def = hanging();
    if (pinned) def.pins = {0, 50};
    scene.coupling.add(Cord(def));
    if (!pinned) scene.coupling.hold(*scene.add_body({0.0, -10.0}, 500.0), {.cord = 0, .point = 50});
    b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0, .strength = 50.0});
    scene.tick(180);
    ASSERT_TRUE(scene.coupling.grip(grip).is_valid()) << pinned;
    EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 10.0, 1e-6) << pinned;
    EXPECT_NEAR(body->GetPosition().y, -10.0, 0.01) << pinned;
    EXPECT_NEAR(scene.coupling.grip(grip).state().pull.y, 70.0 * g, 1.0) << pinned;
  }
}

/// Two bodies that slip do not stop each other at a free end.
TEST(Grip, SlipsOffAnEndPastAnotherThatSlips) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  std::vector<ribbon::box2d::GripId> grips;
  for (int k = 0; k < 2; ++k) {
    b2Body* body = scene.add_body({0.0, -10.0}, 70.0);
    grips.push_back(scene.coupling.hold(*body, {.cord = 0, .arc = 10.0, .strength = 50.0}));
  }
  scene.tick(10);
  for (const ribbon::box2d::GripId grip : grips) EXPECT_FALSE(scene.coupling.grip(grip).is_valid()) << grip;
}

/// With such angular velocities the motion is arbitrary, but a grip is at a place of its cord, and no tick throws.
TEST(Grip, StaysOnItsCordWhileItSlips) {
  for (const float turning : {1e4F, 1e5F, 1e7F, 1e9F}) {
    GripWorld scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -3.05}, 70.0);
    std::vector<ribbon::box2d::GripId> grips;
    grips.push_back(
        scene.coupling.hold(*body, {.cord = 0, .arc = 3.05, .local_anchor = {0.0F, 0.1F}, .strength = 5.0}));
    grips.push_back(
        scene.coupling.hold(*body, {.cord = 0, .arc = 3.55, .local_anchor = {0.1F, 0.0F}, .strength = 5.0}));
    scene.coupling.cord(0).direct().reel(0, 50, 5.0, 10.0);
    for (int k = 0; k < 20; ++k) {
      body->SetAngularVelocity(turning);
      ASSERT_NO_THROW(scene.tick()) << turning << " " << k;
      for (const ribbon::box2d::GripId grip : grips) {
        if (!scene.coupling.grip(grip).is_valid()) continue;  // it slipped off the end
        EXPECT_GE(scene.coupling.grip(grip).state().arc, 0.0);
        EXPECT_LE(scene.coupling.grip(grip).state().arc, 10.0);
      }
      ASSERT_TRUE(all_finite(scene.coupling.cord(0).positions())) << turning << " " << k;
      ASSERT_NO_THROW(scene.coupling.restore(scene.coupling.save(scene.world), scene.world)) << turning << " " << k;
    }
  }
}

}  // namespace
}  // namespace engine
