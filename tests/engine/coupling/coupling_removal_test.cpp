#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <vector>

#include "ribbon/box2d/box2d.h"
#include "ribbon/ribbon.h"
#include "tests/engine/coupling/handle_cords.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

// Cords that are removed from a coupling.

namespace ribbon::box2d {
namespace {

using constants::dt;

TEST(RemovingACord, ReleasesItsHoldersAndEndsItsContactsInTheNextStep) {
  RopeWorld there;
  b2Body& resting = there.ball({1.0, 0.12});
  b2Body& holder = there.ball({0.5, -1.0});
  there.coupling.add(rope(-8.0));
  const CordId id = there.coupling.add(rope());
  there.coupling.hold(id, 5, holder, b2Vec2_zero);
  bool touches = false;
  for (int k = 0; k < 60 && !touches; ++k) {
    there.tick(1);
    touches = !there.coupling.cord(id).touching().empty();
  }
  ASSERT_TRUE(touches);
  const Vec2 velocity = there.coupling.body(holder).velocity();
  there.coupling.remove(id);
  EXPECT_FALSE(there.coupling.body(holder).held_place());
  EXPECT_NEAR(length(to_double(holder.GetLinearVelocity()) - velocity), 0.0, 1e-5) << "it keeps its velocity";
  there.tick(1);
  ASSERT_EQ(there.coupling.last_step().touch_events().size(), 1U);
  const TouchEvent& end = there.coupling.last_step().touch_events()[0];
  EXPECT_EQ(end.cord, id);
  EXPECT_FALSE(end.begins);
  EXPECT_EQ(end.fixture, resting.GetFixtureList());
  there.tick(1);
  EXPECT_TRUE(there.coupling.last_step().touch_events().empty());
  there.tick(60);
  EXPECT_LT(resting.GetPosition().y, -2.0F) << "it falls through";
}

TEST(RemovingACord, WakesTheBodyThatSleptOnIt) {
  RopeWorld there;
  CordDef def = rope().def();
  def.allow_sleep = true;
  def.drag = 5.0;
  const CordId id = there.coupling.add(Cord(def));
  b2Body& ball = there.ball({1.0, 0.12});
  ball.SetSleepingAllowed(true);
  ball.SetLinearDamping(5.0F);
  for (int k = 0; k < 2000 && ball.IsAwake(); ++k) there.tick(1);
  ASSERT_FALSE(ball.IsAwake());
  there.coupling.remove(id);
  there.tick(60);
  EXPECT_LT(ball.GetPosition().y, -1.0F) << "it falls";
}

TEST(RemovingACord, IsPartOfTheStateThatIsSaved) {
  RopeWorld there;
  there.ball({1.0, 0.12});
  there.coupling.add(rope(-8.0));
  const CordId id = there.coupling.add(rope());
  for (int k = 0; k < 60 && there.coupling.cord(id).touching().empty(); ++k) there.tick(1);
  const Coupling::State before = there.coupling.save(there.world);
  there.coupling.remove(id);
  there.coupling.restore(before, there.world);
  EXPECT_EQ(there.coupling.save(there.world), before) << "the cord is there again";
  there.coupling.remove(id);
  const Coupling::State after = there.coupling.save(there.world);
  ASSERT_EQ(after.ending.size(), 1U);
  EXPECT_EQ(after.next_cord, 2);
  there.tick(1);
  EXPECT_EQ(there.coupling.last_step().touch_events().size(), 1U);
  there.coupling.restore(after, there.world);
  EXPECT_EQ(there.coupling.save(there.world), after);
  there.tick(1);
  EXPECT_EQ(there.coupling.last_step().touch_events().size(), 1U) << "again";
}

TEST(RemovingACord, InAnyOrderGivesAStateThatCanBeRestored) {
  RopeWorld there;
  std::vector<CordId> cords;
  for (const double y : {0.0, -1.0, -2.0}) {
    there.ball({1.0, y + 0.12});
    cords.push_back(there.coupling.add(rope(y)));
  }
  there.tick(20);
  for (const CordId cord : cords) ASSERT_FALSE(there.coupling.cord(cord).touching().empty());
  for (const CordId cord : {cords[1], cords[2], cords[0]}) there.coupling.remove(cord);
  const Coupling::State state = there.coupling.save(there.world);
  ASSERT_EQ(state.ending.size(), 3U);
  there.coupling.restore(state, there.world);
  there.tick(1);
  ASSERT_EQ(there.coupling.last_step().touch_events().size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(there.coupling.last_step().touch_events()[k].cord, cords[k]);
}

/// A ball sleeps on one of two ropes and is near the other. It must not continue to sleep in the air.
TEST(RemovingACord, WakesABodyThatIsNearAnotherCord) {
  for (const bool removed : {false, true}) {
    RopeWorld there;
    CordDef def = rope().def();
    def.allow_sleep = true;
    def.drag = 5.0;
    const CordId upper = there.coupling.add(Cord(def));
    for (Vec2& x : def.positions) x.y -= 0.1;
    const CordId lower = there.coupling.add(Cord(def));
    b2Body& ball = there.ball({0.05, 0.11});
    ball.SetSleepingAllowed(true);
    ball.SetLinearDamping(5.0F);
    ball.SetAngularDamping(5.0F);
    const auto all_sleep = [&] { return !ball.IsAwake() && there.coupling.cord(lower).direct().is_asleep(); };
    for (int k = 0; k < 2000 && !all_sleep(); ++k) there.tick(1);
    ASSERT_TRUE(all_sleep());
    ASSERT_GT(there.coupling.cord(lower).near_count(), 0);
    const float height = ball.GetPosition().y;
    if (removed) {
      there.coupling.remove(upper);
    } else {
      there.coupling.cord(upper).set_enabled(false);
    }
    there.tick(20);
    EXPECT_LT(ball.GetPosition().y, height - 0.02F);
  }
}

TEST(RemovingACord, WakesACordThatSleepsOnIt) {
  RopeWorld there;
  CordDef def = rope().def();
  def.allow_sleep = true;
  def.cord_contact = true;
  def.drag = 5.0;
  def.radius = 0.02;
  const CordId lower = there.coupling.add(Cord(def));
  def.pins = {};
  def.positions.clear();
  def.points = 11;
  def.length = 1.0;
  def.positions = test_support::equally_spaced(def.points, {0.5, 0.05}, {0.1, 0.0});
  const CordId upper = there.coupling.add(Cord(def));
  const auto sleeps = [&] { return there.coupling.cord(upper).direct().is_asleep(); };
  for (int k = 0; k < 3000 && !sleeps(); ++k) there.tick(1);
  ASSERT_TRUE(sleeps());
  const double height = there.coupling.cord(upper).positions()[5].y;
  there.coupling.remove(lower);
  there.tick(20);
  EXPECT_FALSE(sleeps());
  EXPECT_LT(there.coupling.cord(upper).positions()[5].y, height - 0.1);
}

TEST(RemovingACord, BetweenGatherAndApplyIsSafe) {
  for (const bool after_step : {false, true}) {
    RopeWorld there;
    there.ball({1.0, 0.12});
    b2Body& holder = there.ball({0.5, -1.0});
    const CordId direct = there.coupling.add(rope());
    const CordId thesis = there.coupling.add(curtain());
    there.coupling.hold(direct, 5, holder, b2Vec2_zero);
    there.coupling.hold(thesis, 5, holder, b2Vec2_zero);
    there.tick(5);
    there.coupling.gather(there.world, dt);
    if (after_step) there.coupling.step();
    there.coupling.remove(direct);
    there.coupling.remove(thesis);
    if (!after_step) there.coupling.step();
    there.coupling.apply();
    there.world.Step(static_cast<float>(dt), 8, 3);
    EXPECT_FALSE(there.coupling.body(holder).held_place());
    const float speed = holder.GetLinearVelocity().y;
    there.tick(5);
    EXPECT_NEAR(holder.GetLinearVelocity().y, speed - 5.0F * 9.81F / 60.0F, 0.05F) << "it falls";
    EXPECT_EQ(there.coupling.size(), 0);
  }
}

}  // namespace
}  // namespace ribbon::box2d
