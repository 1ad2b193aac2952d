#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/box2d/box2d.h"
#include "ribbon/ribbon.h"
#include "tests/support/allocations.h"
#include "tests/support/shape_world.h"

// Ids and handles of cords and grips: what they refer to, and what happens once it is gone.

namespace ribbon::box2d {
namespace {

constexpr double dt = 1.0 / 60.0;

/// A rope of 2 m at height y, fixed at both ends.
Cord rope(double y = 0.0) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  for (int p = 0; p < def.points; ++p) def.positions.push_back({0.1 * p, y});
  def.pins = {0, 20};
  return Cord(def);
}

ThesisCord curtain() {
  ThesisDef def;
  def.pins = {0, 1};
  return ThesisCord(def);
}

struct World : test_support::ShapeWorld {
  b2Body& ball(Vec2 position) { return *add_ball(position, 0.1, 0.3); }
};

/// Returns the message of the CallError that a call throws, or "accepted".
template <typename Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const CallError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CordIds, AreNeverReused) {
  Coupling coupling;
  EXPECT_EQ(coupling.add(rope()), 0);
  EXPECT_EQ(coupling.add(curtain()), 1);
  coupling.remove(0);
  EXPECT_EQ(coupling.add(rope(1.0)), 2);
  EXPECT_EQ(coupling.size(), 2);
  EXPECT_TRUE(std::ranges::equal(coupling.cords(), std::vector<CordId>{1, 2}));
  EXPECT_FALSE(coupling.cord(0).is_valid());
  EXPECT_TRUE(coupling.cord(1).is_valid());
  EXPECT_EQ(coupling.cord(1).solver(), Solver::thesis);
  EXPECT_EQ(coupling.cord(2).positions()[3].y, 1.0);
}

TEST(CordIds, OfARemovedCordAreRefusedByEveryCall) {
  World there;
  b2Body& ball = there.ball({1.0, -1.0});
  there.coupling.add(rope());
  there.coupling.add(rope(5.0));
  there.coupling.remove(0);
  const CordRef gone = there.coupling.cord(0);
  const std::string said = "cord is 0; accepted is the id of a cord that was added and not removed";
  EXPECT_EQ(refusal([&] { (void)gone.solver(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.shape(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.direct(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.thesis(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.positions(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.kind(0); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.is_enabled(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.user_data(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.touching(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.near(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.near_count(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.swept_aabb(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.island_report(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.island_total(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.error(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.thesis_report(); }), said);
  EXPECT_EQ(refusal([&] { (void)gone.thesis_total(); }), said);
  EXPECT_EQ(refusal([&] { gone.drag(0, {}); }), said);
  EXPECT_EQ(refusal([&] { gone.pin(0, {}); }), said);
  EXPECT_EQ(refusal([&] { gone.free(0); }), said);
  EXPECT_EQ(refusal([&] { gone.set_enabled(true); }), said);
  EXPECT_EQ(refusal([&] { gone.set_user_data(1); }), said);
  EXPECT_EQ(refusal([&] { gone.replace(rope()); }), said);
  EXPECT_EQ(refusal([&] { there.coupling.remove(0); }), said);
  EXPECT_EQ(refusal([&] { (void)there.coupling.position({0, 3}); }), said);
  EXPECT_EQ(refusal([&] { (void)there.coupling.arc({0, 3}); }), said);
  EXPECT_EQ(refusal([&] { there.coupling.hold(0, 3, ball, b2Vec2_zero); }), said);
}

TEST(CordRef, StaysUsableWhileCordsComeAndGoAndTheCouplingMoves) {
  Coupling coupling;
  const CordId first = coupling.add(rope());
  const CordId second = coupling.add(rope(2.0));
  const CordRef handle = coupling.cord(second);
  const Cord& cord = handle.direct();
  for (int k = 0; k < 100; ++k) coupling.add(rope(3.0 + k));
  coupling.remove(first);
  const Coupling moved = std::move(coupling);
  EXPECT_EQ(&handle.direct(), &cord);
  EXPECT_EQ(&moved.cord(second).direct(), &cord);
  EXPECT_EQ(handle.positions()[0].y, 2.0);
}

TEST(CordRef, RefusesTheOtherSolverAndPointsThatDoNotExist) {
  Coupling coupling;
  coupling.add(rope());
  coupling.add(curtain());
  EXPECT_EQ(refusal([&] { (void)coupling.cord(0).thesis(); }),
            "cord 0 is of the direct solver; accepted is one of the thesis solver");
  EXPECT_EQ(refusal([&] { (void)coupling.cord(1).direct(); }),
            "cord 1 is of the thesis solver; accepted is one of the direct solver");
  EXPECT_EQ(refusal([&] { coupling.cord(1).replace(rope()); }),
            "cord 1 is of the thesis solver; accepted is one of the direct solver");
  EXPECT_THROW((void)coupling.cord(0).kind(21), DefinitionError);
  EXPECT_THROW((void)coupling.cord(1).kind(-1), DefinitionError);
}

TEST(CordRef, KeepsUserDataWhenTheCordIsReplaced) {
  Coupling coupling;
  const CordId id = coupling.add(rope());
  EXPECT_EQ(coupling.cord(id).user_data(), 0U);
  coupling.cord(id).set_user_data(77);
  coupling.cord(id).replace(rope(1.0));
  EXPECT_EQ(std::as_const(coupling).cord(id).user_data(), 77U);
}

TEST(RemovingACord, ReleasesItsHoldersAndEndsItsContactsInTheNextStep) {
  World there;
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
  const Vec2 velocity = there.coupling.velocity(holder);
  there.coupling.remove(id);
  EXPECT_FALSE(there.coupling.held_by(holder));
  EXPECT_NEAR(length(to_double(holder.GetLinearVelocity()) - velocity), 0.0, 1e-5) << "it keeps its velocity";
  there.tick(1);
  ASSERT_EQ(there.coupling.touch_events().size(), 1U);
  const TouchEvent& end = there.coupling.touch_events()[0];
  EXPECT_EQ(end.cord, id);
  EXPECT_FALSE(end.begins);
  EXPECT_EQ(end.fixture, resting.GetFixtureList());
  there.tick(1);
  EXPECT_TRUE(there.coupling.touch_events().empty());
  there.tick(60);
  EXPECT_LT(resting.GetPosition().y, -2.0F) << "it falls through";
}

TEST(RemovingACord, WakesTheBodyThatSleptOnIt) {
  World there;
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
  World there;
  there.ball({1.0, 0.12});
  there.coupling.add(rope(-8.0));
  const CordId id = there.coupling.add(rope());
  for (int k = 0; k < 60 && there.coupling.cord(id).touching().empty(); ++k) there.tick(1);
  const Coupling::State before = there.coupling.save(there.world);
  there.coupling.remove(id);
  EXPECT_THROW(there.coupling.restore(before, there.world), DefinitionError) << "the state is of two cords";
  const Coupling::State after = there.coupling.save(there.world);
  ASSERT_EQ(after.ending.size(), 1U);
  EXPECT_EQ(after.next_cord, 2);
  there.tick(1);
  EXPECT_EQ(there.coupling.touch_events().size(), 1U);
  there.coupling.restore(after, there.world);
  EXPECT_EQ(there.coupling.save(there.world), after);
  there.tick(1);
  EXPECT_EQ(there.coupling.touch_events().size(), 1U) << "again";
}

TEST(RemovingACord, InAnyOrderGivesAStateThatCanBeRestored) {
  World there;
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
  ASSERT_EQ(there.coupling.touch_events().size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(there.coupling.touch_events()[k].cord, cords[k]);
}

/// A ball sleeps on one of two ropes and is near the other. It must not go on sleeping in the air.
TEST(RemovingACord, WakesABodyThatIsNearAnotherCord) {
  for (const bool removed : {false, true}) {
    World there;
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
  World there;
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
  for (int p = 0; p < def.points; ++p) def.positions.push_back({0.5 + 0.1 * p, 0.05});
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
    World there;
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
    EXPECT_FALSE(there.coupling.held_by(holder));
    const float speed = holder.GetLinearVelocity().y;
    there.tick(5);
    EXPECT_NEAR(holder.GetLinearVelocity().y, speed - 5.0F * 9.81F / 60.0F, 0.05F) << "it falls";
    EXPECT_EQ(there.coupling.size(), 0);
  }
}

TEST(Tick, IsGatherStepApplyAndTheWorldsStep) {
  World one;
  World other;
  for (World* world : {&one, &other}) {
    world->coupling.add(rope());
    world->ball({1.0, 0.3});
  }
  for (int k = 0; k < 60; ++k) {
    one.coupling.tick(one.world, dt);
    other.coupling.gather(other.world, dt);
    other.coupling.step();
    other.coupling.apply();
    other.world.Step(static_cast<float>(dt), 8, 3);
  }
  EXPECT_EQ(one.coupling.save(one.world), other.coupling.save(other.world));
  EXPECT_EQ(one.world.GetBodyList()->GetPosition(), other.world.GetBodyList()->GetPosition());
}

TEST(Tick, PartsOutOfOrderAreRefusedAndChangeNothing) {
  World there;
  there.coupling.add(rope());
  const Coupling::State before = there.coupling.save(there.world);
  const std::string no_gather = "step does not follow gather; accepted is gather, step, apply";
  const std::string no_step = "apply does not follow step; accepted is gather, step, apply";
  EXPECT_EQ(refusal([&] { there.coupling.step(); }), no_gather);
  EXPECT_EQ(refusal([&] { there.coupling.apply(); }), no_step);
  there.coupling.gather(there.world, dt);
  EXPECT_EQ(refusal([&] { there.coupling.apply(); }), no_step);
  EXPECT_EQ(there.coupling.save(there.world), before);
  there.coupling.gather(there.world, dt);  // a second gather discards the first
  there.coupling.step();
  const Coupling::State stepped = there.coupling.save(there.world);
  EXPECT_EQ(refusal([&] { there.coupling.step(); }), no_gather);
  EXPECT_EQ(refusal([&] { there.coupling.gather(there.world, dt); }),
            "gather follows step; accepted is gather, step, apply");
  EXPECT_EQ(there.coupling.save(there.world), stepped);
  there.coupling.apply();
  EXPECT_EQ(refusal([&] { there.coupling.apply(); }), no_step);
  there.coupling.tick(there.world, dt);
}

TEST(Holding, RefusedInAnotherWorldChangesNothing) {
  World there;
  const CordId cord = there.coupling.add(rope());
  there.coupling.hold(cord, 4, there.ball({0.4, -1.0}), b2Vec2_zero);
  there.tick(10);
  const Coupling::State before = there.coupling.save(there.world);
  ASSERT_EQ(before.carries.size(), 1U);
  b2World elsewhere({0.0F, 0.0F});
  const b2BodyDef at;
  b2Body& stranger = *elsewhere.CreateBody(&at);
  EXPECT_THROW(there.coupling.hold(cord, 21, stranger, b2Vec2_zero), DefinitionError);
  EXPECT_THROW(there.coupling.hold(stranger, {.cord = cord, .strength = -1.0}), DefinitionError);
  EXPECT_EQ(there.coupling.save(there.world), before);
}

TEST(Places, ThatACordDoesNotHaveAreRefused) {
  Coupling coupling;
  const CordId cord = coupling.add(rope());
  EXPECT_EQ(coupling.position({cord, 20}).x, 2.0);
  EXPECT_THROW((void)coupling.position({cord, 21}), DefinitionError);
  EXPECT_THROW((void)coupling.position({cord, -1}), DefinitionError);
  EXPECT_THROW((void)coupling.position({cord, 20, 0.0, 0.5}), DefinitionError);
  EXPECT_THROW((void)coupling.arc({cord, 3, 0.0, 1.5}), DefinitionError);
}

TEST(Holding, AgainIsASecondGripAndNeverMovesTheFirst) {
  World there;
  for (const CordId cord : {there.coupling.add(rope()), there.coupling.add(curtain())}) {
    b2Body& body = there.ball({0.5, -2.0});
    const GripId first = there.coupling.hold(cord, 4, body, {0.0F, 0.1F});
    EXPECT_EQ(refusal([&] {
                there.coupling.hold(cord, 4, body, {0.3F, 0.0F});
              }),
              "the body holds cord " + std::to_string(cord) + " at point 4 already, by grip " + std::to_string(first) +
                  "; accepted is another place, or a move of that grip");
    const GripMemory kept = there.coupling.save(there.world).grips.back().memory;
    EXPECT_EQ(kept.local_anchor, b2Vec2(0.0F, 0.1F)) << "the refused one has not moved it";
    EXPECT_EQ(kept.next_anchor, b2Vec2(0.0F, 0.1F));
    const GripId second = there.coupling.hold(cord, 10, body, {0.0F, -0.1F});
    EXPECT_EQ(there.coupling.first_grip(body), first);
    EXPECT_EQ(there.coupling.grip(first).state().point, 4);
    EXPECT_EQ(there.coupling.grip(second).state().point, 10);
    there.tick(30);
    EXPECT_TRUE(there.coupling.grip(first).release());
    EXPECT_FALSE(there.coupling.grip(first).release());
    EXPECT_TRUE(there.coupling.held_by(body)) << "by the second";
    there.tick(30);
    EXPECT_TRUE(there.coupling.release(body));
    EXPECT_FALSE(there.coupling.grip(second).is_valid());
  }
}

/// A ribbon of two rows that hangs from (0, 0) and touches nothing, of either solver.
CordId hang_ribbon(Coupling& coupling, Solver solver) {
  b2Filter nothing;
  nothing.maskBits = 0;
  if (solver == Solver::thesis) {
    ThesisDef def;
    def.pins = {0, 1};
    def.drag = 2.0;
    return coupling.add(ThesisCord(def), nothing);
  }
  CordDef def;
  def.points = 11;
  def.rows = 2;
  def.length = 1.0;
  def.width = 0.1;
  def.stretch_stiffness = 1e4;
  def.drag = 2.0;
  def.pins = {0, 1};
  return coupling.add(Cord(def), nothing);
}

/// One above the other at the end of a ribbon: only both together keep the body from turning.
TEST(Holding, TwoRowsOfARibbonCarryTheBodyAtBoth) {
  for (const Solver solver : {Solver::thesis, Solver::direct}) {
    World there;
    const CordId cord = hang_ribbon(there.coupling, solver);
    const auto positions = there.coupling.cord(cord).positions();
    const int last = static_cast<int>(positions.size()) - 1;
    const Vec2 middle = 0.5 * (positions.back() + positions[static_cast<std::size_t>(last - 1)]);
    b2Body& body = there.ball(middle);
    SCOPED_TRACE(solver_name(solver));
    const Vec2 arm = positions.back() - middle;
    const GripId one = there.coupling.hold(cord, last, body, to_float(arm));
    const GripId other = there.coupling.hold(cord, last - 1, body, to_float(-1.0 * arm));
    there.tick(1200);
    EXPECT_NEAR(length(there.coupling.grip(one).state().place - to_double(body.GetWorldPoint(to_float(arm)))), 0.0,
                0.01);
    EXPECT_NEAR(length(there.coupling.grip(other).state().place - to_double(body.GetWorldPoint(to_float(-1.0 * arm)))),
                0.0, 0.01);
  }
}

TEST(GripRef, OfARemovedCordIsNotValid) {
  World there;
  const CordId cord = there.coupling.add(rope());
  const GripRef grip = there.coupling.grip(there.coupling.hold(cord, 4, there.ball({0.4, -1.0}), b2Vec2_zero));
  EXPECT_TRUE(grip.is_valid());
  there.coupling.remove(cord);
  EXPECT_FALSE(grip.is_valid());
  EXPECT_EQ(refusal([&] { (void)grip.state(); }),
            "grip is " + std::to_string(grip.id()) + "; accepted is the id of one that has not been released");
}

TEST(Handles, AllocateNothing) {
  World there;
  const CordId cord = there.coupling.add(rope());
  const GripId grip = there.coupling.hold(cord, 4, there.ball({0.4, -1.0}), b2Vec2_zero);
  there.tick(2);
  const test_support::AllocationCount count;
  Vec2 sum;
  sum += there.coupling.cord(cord).positions()[3];
  sum += there.coupling.grip(grip).state().pull;
  there.coupling.cord(cord).drag(7, {0.7, 0.1});
  there.coupling.grip(grip).move_anchor({0.0F, 0.1F});
  EXPECT_EQ(count.so_far(), 0);
  EXPECT_TRUE(is_finite(sum));
}

/// Contacts are compliant: at rest a body penetrates by 1/2000 of the distance g·dt² that it would fall in one step,
/// and by 1/100 with soft contacts, whatever the integrator.
TEST(SoftContacts, AreAFieldOfTheAccuracyAndNotOfTheIntegrator) {
  const auto penetration = [](Integrator integrator, bool soft) {
    World there;
    CordDef def;
    def.points = 2;
    def.length = 0.4;
    def.radius = 0.05;
    def.positions = {{0.8, 0.0}, {1.2, 0.0}};
    def.pins = {0, 1};
    def.accuracy.integrator = integrator;
    def.accuracy.soft_contacts = soft;
    def.accuracy.tolerance = 1e-7;
    there.coupling.add(Cord(def));
    b2Body& ball = there.ball({1.0, 0.15});
    ball.SetFixedRotation(true);
    there.tick(300);
    return 0.15 - static_cast<double>(ball.GetPosition().y);
  };
  const double fall = 9.81 * dt * dt;
  for (const Integrator integrator : {Integrator::tr_bdf2, Integrator::implicit_euler}) {
    EXPECT_NEAR(penetration(integrator, false) / fall, 1.0 / 2000.0, 3e-4);
    EXPECT_NEAR(penetration(integrator, true) / fall, 1.0 / 100.0, 3e-3);
  }
}

}  // namespace
}  // namespace ribbon::box2d
