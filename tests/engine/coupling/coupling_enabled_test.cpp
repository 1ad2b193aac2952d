#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/refusal.h"
#include "tests/support/shape_world.h"

// Cords that are disabled and enabled.

namespace engine {
namespace {

using ribbon::CallError;
using ribbon::CordDef;
using ribbon::Vec2;
using test_support::refusal;

std::vector<Vec2> level(double left, double y, int points, double length) {
  std::vector<Vec2> positions;
  for (int p = 0; p < points; ++p) positions.push_back({left + length * p / (points - 1.0), y});
  return positions;
}

/// A rope of 2 m at height y from x = `left`, fixed at both ends or at none.
ribbon::Cord rope(double y = 0.0, double left = 0.0, bool fixed = true) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.cord_contact = true;
  def.positions = level(left, y, 21, 2.0);
  if (fixed) def.pins = {0, 20};
  return ribbon::Cord(def);
}

ribbon::ThesisCord thesis_ribbon() {
  ribbon::ThesisDef def;
  def.pins = {0, 1};
  return ribbon::ThesisCord(def);
}

struct BallWorld : test_support::ShapeWorld {
  b2Body& ball(Vec2 position, double radius = 0.1) { return *add_ball(position, radius, 0.3); }
  std::vector<Vec2> points(ribbon::box2d::CordId cord) const {
    return {coupling.cord(cord).positions().begin(), coupling.cord(cord).positions().end()};
  }
};

TEST(CouplingEnabled, ADisabledCordDoesNotMoveOrCollide) {
  BallWorld there;
  there.coupling.add(rope());
  there.coupling.add(thesis_ribbon());
  b2Body& ball = there.ball({1.0, 0.2});
  b2Body& other = there.ball({0.5, 0.2});
  there.tick(3);
  const std::array before = {there.points(0), there.points(1)};
  const int stages = there.coupling.cord(0).island_total().stages;
  for (const ribbon::box2d::CordId cord : {0, 1}) {
    EXPECT_TRUE(there.coupling.cord(cord).is_enabled());
    there.coupling.cord(cord).set_enabled(false);
    EXPECT_FALSE(there.coupling.cord(cord).is_enabled());
  }
  there.tick(60);
  for (const ribbon::box2d::CordId cord : {0, 1}) {
    EXPECT_EQ(there.points(cord), before.at(static_cast<std::size_t>(cord)));
    EXPECT_EQ(there.coupling.cord(cord).near_count(), 0);
  }
  EXPECT_EQ(there.coupling.cord(0).island_total().stages, stages);
  EXPECT_EQ(there.coupling.cord(0).island_report().stages, 0);
  EXPECT_EQ(there.coupling.last_step().islands(), 0);
  for (const b2Body* body : {&ball, &other}) EXPECT_LT(body->GetPosition().y, -4.0F) << "it fell through";
}

TEST(CouplingEnabled, DisablingReleasesHoldersWithTheirVelocity) {
  for (const bool direct : {true, false}) {
    SCOPED_TRACE(direct ? "direct" : "thesis");
    BallWorld there;
    if (direct) {
      there.coupling.add(rope());
    } else {
      there.coupling.add(thesis_ribbon());
    }
    b2Body& hand = there.ball(there.coupling.cord(0).positions()[10], 0.02);
    there.coupling.hold(0, 10, hand, {0.0F, 0.0F});
    there.tick(5);
    ASSERT_TRUE(there.coupling.body(hand).held_place());
    const Vec2 velocity = there.coupling.body(hand).velocity();
    there.coupling.cord(0).set_enabled(false);
    EXPECT_FALSE(there.coupling.body(hand).held_place());
    EXPECT_LT(length(ribbon::box2d::to_double(hand.GetLinearVelocity()) - velocity), 1e-6);
    there.tick(60);
    EXPECT_NEAR(hand.GetLinearVelocity().y, static_cast<float>(velocity.y) - 9.81F, 1e-3F);
  }
}

TEST(CouplingEnabled, ADisabledCordCannotBeHeld) {
  BallWorld there;
  there.coupling.add(rope());
  there.coupling.cord(0).set_enabled(false);
  b2Body& hand = there.ball({1.0, -1.0});
  const std::string said = "cord 0 is disabled; accepted is one that is enabled";
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.hold(0, 3, hand, {0.0F, 0.0F}); }), said);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.hold(hand, {.cord = 0, .arc = 0.5}); }), said);
  EXPECT_FALSE(there.coupling.body(hand).held_place());
  for (const ribbon::box2d::CordId none : {-1, 1}) {
    EXPECT_EQ(refusal<CallError>([&] { there.coupling.cord(none).set_enabled(false); }),
              "cord is " + std::to_string(none) + "; accepted is the id of a cord that was added and not removed");
  }
  there.coupling.cord(0).set_enabled(true);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.hold(hand, {.cord = 0, .arc = 0.5}); }), "no error");
}

/// Also if no cord is enabled.
TEST(CouplingEnabled, ContactsEndAndBeginAgain) {
  BallWorld there;
  there.coupling.add(rope());
  b2Body& ball = there.ball({1.0, 0.11});
  ball.SetGravityScale(0.0F);
  ball.SetLinearVelocity({0.0F, -0.1F});
  for (int k = 0; k < 60 && there.coupling.last_step().touch_events().empty(); ++k) there.tick();
  ASSERT_EQ(there.coupling.last_step().touch_events().size(), 1U);
  ASSERT_TRUE(there.coupling.last_step().touch_events()[0].begins);
  ball.SetType(b2_staticBody);
  there.tick();
  ASSERT_EQ(there.coupling.cord(0).touching().size(), 1U);

  there.coupling.cord(0).set_enabled(false);
  there.tick();
  ASSERT_EQ(there.coupling.last_step().touch_events().size(), 1U);
  EXPECT_FALSE(there.coupling.last_step().touch_events()[0].begins);
  EXPECT_EQ(there.coupling.last_step().touch_events()[0].fixture, ball.GetFixtureList());
  EXPECT_TRUE(there.coupling.cord(0).touching().empty());
  there.tick();
  EXPECT_TRUE(there.coupling.last_step().touch_events().empty()) << "reported once";

  there.coupling.cord(0).set_enabled(true);
  for (int k = 0; k < 60 && there.coupling.last_step().touch_events().empty(); ++k) there.tick();
  ASSERT_EQ(there.coupling.last_step().touch_events().size(), 1U);
  EXPECT_TRUE(there.coupling.last_step().touch_events()[0].begins);
}

TEST(CouplingEnabled, QueriesSkipADisabledCord) {
  BallWorld there;
  there.coupling.add(rope(0.0));
  there.coupling.add(rope(1.0));
  there.coupling.cord(0).set_enabled(false);
  const Vec2 here{1.02, 0.0};
  EXPECT_FALSE(there.coupling.nearest_point(here, 0.5));
  EXPECT_FALSE(there.coupling.nearest_place(here, 0.5));
  ASSERT_TRUE(there.coupling.nearest_place(here, 2.0));
  EXPECT_EQ(there.coupling.nearest_place(here, 2.0)->cord, 1);
  EXPECT_EQ(there.coupling.nearest_point(here, 2.0)->cord, 1);
  there.coupling.cord(0).set_enabled(true);
  EXPECT_EQ(there.coupling.nearest_place(here, 0.5)->cord, 0);
}

/// A rope falls on another one; by index a third cord is between them. Positions, contacts and all other state have the
/// same bits if that cord is enabled and far away, or disabled and amid them.
TEST(CouplingEnabled, OtherCordsMoveWithTheSameBits) {
  const auto run = [](bool off) {
    BallWorld there;
    there.coupling.add(rope(0.0));
    there.coupling.add(off ? rope(0.02) : rope(50.0, 50.0));
    there.coupling.add(rope(0.06, 0.2, false));
    if (off) there.coupling.cord(1).set_enabled(false);
    there.ball({1.0, 0.3});
    there.tick(30);
    return std::array{there.coupling.cord(0).direct().save(), there.coupling.cord(2).direct().save()};
  };
  const auto with = run(false);
  const auto without = run(true);
  const auto touches_a_cord = [](const ribbon::Touch& touch) { return touch.other >> 63U != 0; };
  EXPECT_TRUE(std::any_of(with[1].touches.begin(), with[1].touches.end(), touches_a_cord) ||
              std::any_of(with[0].touches.begin(), with[0].touches.end(), touches_a_cord));
  EXPECT_TRUE(with[0] == without[0]);
  EXPECT_TRUE(with[1] == without[1]);
}

TEST(CouplingEnabled, AnEnabledCordContinuesAsIfNoTimeHadPassed) {
  const auto run = [](int pause) {
    BallWorld there;
    there.coupling.add(rope());
    there.coupling.add(thesis_ribbon());
    there.tick(20);
    for (const ribbon::box2d::CordId cord : {0, 1}) there.coupling.cord(cord).set_enabled(false);
    there.tick(pause);
    for (const ribbon::box2d::CordId cord : {0, 1}) there.coupling.cord(cord).set_enabled(true);
    there.tick(20);
    return std::array{there.points(0), there.points(1)};
  };
  EXPECT_EQ(run(0), run(7));
}

TEST(CouplingEnabled, IsSavedAndRestored) {
  BallWorld there;
  there.coupling.add(rope());
  const ribbon::box2d::Coupling::State on = there.coupling.save(there.world);
  there.coupling.cord(0).set_enabled(false);
  const ribbon::box2d::Coupling::State off = there.coupling.save(there.world);
  there.coupling.restore(on, there.world);
  EXPECT_TRUE(there.coupling.cord(0).is_enabled());
  there.coupling.restore(off, there.world);
  EXPECT_FALSE(there.coupling.cord(0).is_enabled());
}

/// After a cord is disabled, the next one takes its place.
TEST(CouplingEnabled, ReplacingADisabledCordEnablesIt) {
  BallWorld there;
  there.coupling.add(rope());
  there.coupling.cord(0).set_enabled(false);
  there.coupling.cord(0).replace(rope(1.0));
  EXPECT_TRUE(there.coupling.cord(0).is_enabled());
  there.tick(5);
  EXPECT_LT(there.coupling.cord(0).positions()[10].y, 1.0);
}

/// A change between gather and apply is not intended, but is safe.
TEST(CouplingEnabled, AChangeDuringATickIsSafe) {
  for (const bool first : {true, false}) {
    BallWorld there;
    there.coupling.add(rope());
    there.coupling.cord(0).set_enabled(first);
    b2Body& ball = there.ball({1.0, 0.11});
    if (first) there.coupling.hold(ball, {.cord = 0, .arc = 1.0, .local_anchor = {0.0F, -0.1F}});
    there.coupling.gather(there.world, BallWorld::dt);
    there.coupling.cord(0).set_enabled(!first);
    there.coupling.step();
    there.coupling.apply();
    there.tick(10);
    EXPECT_TRUE(ball.GetPosition().IsValid());
    for (const Vec2 x : there.coupling.cord(0).positions()) EXPECT_LT(length(x), 10.0);
  }
}

}  // namespace
}  // namespace engine
