#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/box2d/box2d.h"
#include "ribbon/ribbon.h"
#include "tests/engine/coupling/handle_cords.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/refusal.h"

// Ids and handles of cords and grips: what they refer to, and what they do after it is removed.

namespace ribbon::box2d {
namespace {

using constants::dt;
using test_support::refusal;

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
  RopeWorld there;
  b2Body& ball = there.ball({1.0, -1.0});
  there.coupling.add(rope());
  there.coupling.add(rope(5.0));
  there.coupling.remove(0);
  const CordRef gone = there.coupling.cord(0);
  const std::string said = "cord is 0; accepted is the id of a cord that was added and not removed";
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.solver(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.shape(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.direct(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.thesis(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.positions(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.kind(0); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.is_enabled(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.user_data(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.touching(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.near(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.near_count(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.swept_aabb(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.island_report(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.island_total(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.error(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.thesis_report(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.thesis_total(); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.drag(0, {}); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.pin(0, {}); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.free(0); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.set_enabled(true); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.set_user_data(1); }), said);
  EXPECT_EQ(refusal<CallError>([&] { gone.replace(rope()); }), said);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.remove(0); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.position(3); }), said);
  EXPECT_EQ(refusal<CallError>([&] { (void)gone.arc(3); }), said);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.hold(0, 3, ball, b2Vec2_zero); }), said);
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
  EXPECT_EQ(refusal<CallError>([&] { (void)coupling.cord(0).thesis(); }),
            "cord 0 is of the direct solver; accepted is one of the thesis solver");
  EXPECT_EQ(refusal<CallError>([&] { (void)coupling.cord(1).direct(); }),
            "cord 1 is of the thesis solver; accepted is one of the direct solver");
  EXPECT_EQ(refusal<CallError>([&] { coupling.cord(1).replace(rope()); }),
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

TEST(Tick, IsGatherStepApplyAndTheWorldsStep) {
  RopeWorld one;
  RopeWorld other;
  for (RopeWorld* world : {&one, &other}) {
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
  RopeWorld there;
  there.coupling.add(rope());
  const Coupling::State before = there.coupling.save(there.world);
  const std::string no_gather = "step does not follow gather; accepted is gather, step, apply";
  const std::string no_step = "apply does not follow step; accepted is gather, step, apply";
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.step(); }), no_gather);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.apply(); }), no_step);
  there.coupling.gather(there.world, dt);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.apply(); }), no_step);
  EXPECT_EQ(there.coupling.save(there.world), before);
  there.coupling.gather(there.world, dt);  // a second gather discards the first
  there.coupling.step();
  const Coupling::State stepped = there.coupling.save(there.world);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.step(); }), no_gather);
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.gather(there.world, dt); }),
            "gather follows step; accepted is gather, step, apply");
  EXPECT_EQ(there.coupling.save(there.world), stepped);
  there.coupling.apply();
  EXPECT_EQ(refusal<CallError>([&] { there.coupling.apply(); }), no_step);
  there.coupling.tick(there.world, dt);
}

TEST(Holding, RefusedInAnotherWorldChangesNothing) {
  RopeWorld there;
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

TEST(Places, OutsideACordAreRefused) {
  Coupling coupling;
  const CordView cord = coupling.cord(coupling.add(rope()));
  EXPECT_EQ(cord.position(20).x, 2.0);
  EXPECT_THROW((void)cord.position(21), DefinitionError);
  EXPECT_THROW((void)cord.position(-1), DefinitionError);
  EXPECT_THROW((void)cord.position(20, 0.5), DefinitionError);
  EXPECT_THROW((void)cord.arc(3, 1.5), DefinitionError);
}

TEST(Holding, TwiceMakesASecondGripAndDoesNotMoveTheFirst) {
  RopeWorld there;
  for (const CordId cord : {there.coupling.add(rope()), there.coupling.add(curtain())}) {
    b2Body& body = there.ball({0.5, -2.0});
    const GripId first = there.coupling.hold(cord, 4, body, {0.0F, 0.1F});
    EXPECT_EQ(refusal<CallError>([&] {
                there.coupling.hold(cord, 4, body, {0.3F, 0.0F});
              }),
              "the body holds cord " + std::to_string(cord) + " at point 4 already, by grip " + std::to_string(first) +
                  "; accepted is another place, or a move of that grip");
    const GripMemory kept = there.coupling.save(there.world).grips.back().memory;
    EXPECT_EQ(kept.local_anchor, b2Vec2(0.0F, 0.1F)) << "the refused one has not moved it";
    EXPECT_EQ(kept.next_anchor, b2Vec2(0.0F, 0.1F));
    const GripId second = there.coupling.hold(cord, 10, body, {0.0F, -0.1F});
    EXPECT_EQ(there.coupling.body(body).first_grip(), first);
    EXPECT_EQ(there.coupling.grip(first).state().point, 4);
    EXPECT_EQ(there.coupling.grip(second).state().point, 10);
    there.tick(30);
    EXPECT_TRUE(there.coupling.grip(first).release());
    EXPECT_FALSE(there.coupling.grip(first).release());
    EXPECT_TRUE(there.coupling.body(body).held_place()) << "by the second";
    there.tick(30);
    EXPECT_TRUE(there.coupling.body(body).release());
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

/// Two grips, one above the other, at the end of a ribbon: only both together keep the body from turning.
TEST(Holding, TwoRowsOfARibbonCarryTheBodyAtBoth) {
  for (const Solver solver : {Solver::thesis, Solver::direct}) {
    RopeWorld there;
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
  RopeWorld there;
  const CordId cord = there.coupling.add(rope());
  const GripRef grip = there.coupling.grip(there.coupling.hold(cord, 4, there.ball({0.4, -1.0}), b2Vec2_zero));
  EXPECT_TRUE(grip.is_valid());
  there.coupling.remove(cord);
  EXPECT_FALSE(grip.is_valid());
  EXPECT_EQ(refusal<CallError>([&] { (void)grip.state(); }),
            "grip is " + std::to_string(grip.id()) + "; accepted is the id of one that has not been released");
}

TEST(Handles, AllocateNothing) {
  RopeWorld there;
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
    RopeWorld there;
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
