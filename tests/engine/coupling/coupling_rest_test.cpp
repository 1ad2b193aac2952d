#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/layout.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// Cords that sleep with nothing near them are not stepped. A coupling with a watcher steps all cords, so it is the
// oracle: both have the same bits in every tick, whatever happens.

namespace engine {
namespace {

using ribbon::CordDef;
using ribbon::Vec2;
using ribbon::box2d::CordId;
using test_support::Dice;

constexpr int cords = 6;
constexpr double spacing = 4.0;  // m, between two cords

/// Counts the cords that are stepped.
class Counter : public ribbon::box2d::StepWatcher {
 public:
  void before(const ribbon::box2d::SolverInput& input) noexcept override { stepped = input.cords.size(); }
  void after(const ribbon::box2d::SolverInput& /*input*/, std::span<const ribbon::IslandReport> /*reports*/,
             const ribbon::IslandReport& /*total*/) noexcept override {}
  std::size_t stepped = 0;
};

CordDef resting_rope(int k) {
  CordDef def;
  def.points = 8;
  def.length = 0.7;
  def.radius = 0.02;
  def.drag = 4.0;
  def.allow_sleep = true;
  def.pins = {0};
  if (k % 3 == 1) def.stretch_stiffness = 200.0;
  if (k % 3 == 2) def.bending_stiffness = 1e-3;
  if (k == 4) {
    def.rows = 2;
    def.width = 0.1;
    def.bending_stiffness = 1e-3;
    def.damping = 0.05;
    ribbon::lay_along(def, std::vector<Vec2>{{spacing * k, 0.0}, {spacing * k + 0.7, 0.0}});
    return def;
  }
  def.positions = test_support::equally_spaced(def.points, {spacing * k, 0.0}, {0.0, -0.1});
  return def;
}

/// A row of cords far from each other, one of them of the thesis's solver.
struct RestingWorld : test_support::ShapeWorld {
  RestingWorld() {
    for (int k = 0; k < cords; ++k) coupling.add(ribbon::Cord(resting_rope(k)));
    ribbon::ThesisDef thesis;
    thesis.w = 5;
    thesis.h = 2;
    coupling.add(ribbon::ThesisCord(thesis));
  }
  std::uint64_t hash() const {
    ribbon::box2d::Hasher hasher;
    add_to(hasher, coupling.save(world));
    return hasher.value();
  }
  int asleep() const {
    int count = 0;
    for (int k = 0; k < cords; ++k) {
      const auto cord = std::as_const(coupling).cord(k);
      if (cord.is_valid() && cord.direct().is_asleep()) ++count;
    }
    return count;
  }
};

/// One disturbance, of a kind that a game may cause, near a random cord.
void disturb(RestingWorld& world, Dice& dice) {
  const auto id = static_cast<CordId>(dice(0.0, cords));
  const Vec2 place{spacing * id + dice(-0.5, 0.5), dice(-0.9, 0.3)};
  const int kind = static_cast<int>(dice(0.0, 14.0));
  const auto cord = world.coupling.cord(id);
  const bool exists = cord.is_valid() && cord.is_enabled();
  switch (kind) {
    case 0: world.add_ball(place, 0.1, 0.2); break;
    case 1: test_support::add_shape(world.add_body(place, b2_staticBody), test_support::box(0.1, 0.1), 0.0, 0.5); break;
    case 2:
      if (b2Body* const body = world.world.GetBodyList()) world.coupling.destroy(world.world, *body);
      break;
    case 3:
      if (b2Body* const body = world.world.GetBodyList()) body->SetTransform(ribbon::box2d::to_float(place), 0.3F);
      break;
    case 4:
      if (exists) cord.direct().set_velocity(4, {dice(-1.0, 1.0), 0.0});
      break;
    case 5:
      if (exists) cord.pin(0, {place.x, 0.0});
      break;
    case 6: world.world.SetGravity({static_cast<float>(dice(-1.0, 1.0)), -9.81F}); break;
    case 7:
      if (cord.is_valid()) cord.set_enabled(!cord.is_enabled());
      break;
    case 8:
      if (exists) cord.replace(ribbon::Cord(resting_rope(static_cast<int>(id))));
      break;
    case 9:
      if (exists) {
        b2Body* const held = world.add_ball({place.x, -0.7}, 0.05, 1.0);
        world.coupling.hold(id, 7, *held, b2Vec2_zero);
      }
      break;
    case 10: world.coupling.restore(world.coupling.save(world.world), world.world); break;
    case 11:
      if (exists) cord.direct().reel(2, 6, dice(0.3, 0.5), 0.5);
      break;
    case 12:
      if (exists && dice(0.0, 1.0) < 0.1) world.coupling.remove(id);
      break;
    default: {
      b2Body* const body = world.add_body({place.x, 6.0});
      test_support::add_shape(body, test_support::circle(0.1), 1.0, 0.5);
      body->SetLinearVelocity({0.0F, -20.0F});
      break;
    }
  }
}

TEST(CouplingRest, HasTheBitsOfACouplingThatStepsAllCords) {
  int most_asleep = 0;
  for (unsigned seed = 0; seed < 30; ++seed) {
    RestingWorld resting;
    RestingWorld stepped;
    Counter counter;
    stepped.coupling.watch(&counter);
    Dice first(seed);
    Dice second(seed);
    for (int tick = 0; tick < 900; ++tick) {
      if (tick % 90 == 60) {
        disturb(resting, first);
        disturb(stepped, second);
      }
      resting.tick();
      stepped.tick();
      ASSERT_EQ(resting.hash(), stepped.hash()) << "seed " << seed << ", tick " << tick;
      ASSERT_EQ(resting.coupling.last_step().islands(), stepped.coupling.last_step().islands())
          << "seed " << seed << ", tick " << tick;
      most_asleep = std::max(most_asleep, resting.asleep());
    }
  }
  EXPECT_EQ(most_asleep, cords) << "or the scenes test nothing";
}

TEST(CouplingRest, ACordThatIsHeldBetweenGatherAndStepWakes) {
  RestingWorld world;
  world.tick(300);
  ASSERT_EQ(world.asleep(), cords);
  b2Body* const ground = world.add_body({0.0, -2.0}, b2_staticBody);  // without a fixture
  world.coupling.gather(world.world, RestingWorld::dt);
  world.coupling.hold(0, 7, *ground, b2Vec2_zero);
  world.coupling.step();
  world.coupling.apply();
  world.tick(2);
  EXPECT_FALSE(world.coupling.cord(0).direct().is_asleep());
}

TEST(CouplingRest, ACordThatIsChangedBetweenGatherAndStepMovesInThatStep) {
  RestingWorld world;
  world.tick(300);
  ASSERT_EQ(world.asleep(), cords);
  world.coupling.gather(world.world, RestingWorld::dt);
  world.coupling.cord(0).direct().set_velocity(5, {1.0, 0.0});
  const Vec2 before = world.coupling.cord(0).positions()[5];
  world.coupling.step();
  world.coupling.apply();
  EXPECT_GT(world.coupling.cord(0).positions()[5].x, before.x);
}

TEST(CouplingRest, ACordThatSleepsWhenItIsAddedIsFoundWhereItIs) {
  RestingWorld world;
  world.tick(300);
  ASSERT_EQ(world.asleep(), cords);
  ribbon::Cord sleeping(resting_rope(0));
  sleeping.restore(world.coupling.cord(0).direct().save());
  world.coupling.gather(world.world, RestingWorld::dt);
  const CordId added = world.coupling.add(std::move(sleeping));
  world.coupling.step();
  world.coupling.apply();
  world.tick(5);
  EXPECT_TRUE(world.coupling.cord(added).direct().is_asleep());
  world.add_ball({0.15, -0.4}, 0.1, 0.2);
  world.tick();
  EXPECT_FALSE(world.coupling.cord(added).direct().is_asleep());
}

TEST(CouplingRest, OnlyCordsWithSomethingNearAreStepped) {
  RestingWorld world;
  Counter counter;
  world.tick(300);
  ASSERT_EQ(world.asleep(), cords);
  world.add_ball({0.15, -0.4}, 0.1, 0.2);
  world.tick();
  EXPECT_FALSE(world.coupling.cord(0).direct().is_asleep());
  EXPECT_EQ(world.coupling.last_step().report(), world.coupling.cord(0).island_report());
  EXPECT_EQ(world.asleep(), cords - 1);
  world.coupling.watch(&counter);
  world.tick();
  EXPECT_EQ(counter.stepped, static_cast<std::size_t>(cords));
}

TEST(CouplingRest, ATickOfAnotherLengthWakesNoCord) {
  RestingWorld world;
  world.tick(300);
  ASSERT_EQ(world.asleep(), cords);
  const std::vector<Vec2> before(world.coupling.cord(3).positions().begin(), world.coupling.cord(3).positions().end());
  for (const double dt : {1.0 / 60.0, 1.0 / 120.0, 1.0 / 30.0}) world.coupling.tick(world.world, dt);
  EXPECT_EQ(world.asleep(), cords);
  for (std::size_t p = 0; p < before.size(); ++p) EXPECT_EQ(world.coupling.cord(3).positions()[p], before[p]);
}

}  // namespace
}  // namespace engine
