#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "ribbon/cord.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/shape_world.h"

namespace engine {
namespace {

using constants::dt;
using ribbon::Accuracy;
using ribbon::Integrator;
using ribbon::Vec2;

ribbon::CordDef swinging(const Accuracy& accuracy) {
  ribbon::CordDef def;
  def.points = 21;
  def.length = 4.0;
  def.pins = {0};
  def.drag = 0.5;
  def.accuracy = accuracy;
  return def;  // starts along +x, and falls
}

struct SwingWorld {
  explicit SwingWorld(const Accuracy& accuracy) {
    coupling.add(ribbon::Cord(swinging(accuracy)));
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.position.Set(4.0F, 0.0F);
    load = box2d.CreateBody(&body);
    const b2MassData mass{5.0F, b2Vec2_zero, 1.0F};
    load->SetMassData(&mass);
    coupling.hold(0, 20, *load, b2Vec2_zero);
  }
  void tick() { coupling.tick(box2d, dt); }

  b2World box2d{b2Vec2(0.0F, -9.81F)};
  b2Body* load = nullptr;
  ribbon::box2d::Coupling coupling;
};

/// The sum of the estimated errors of 40 ticks, and the error of the cord at their end, m.
struct Outcome {
  double estimated = 0.0;
  double actual = 0.0;
};

Outcome run(const Accuracy& accuracy) {
  SwingWorld world(accuracy);
  SwingWorld exact({Integrator::tr_bdf2, 256, 20, 1e-9});
  world.coupling.estimate_errors(true);
  Outcome outcome;
  for (int k = 0; k < 40; ++k) {
    world.tick();
    exact.tick();
    outcome.estimated += world.coupling.cord(0).error();
  }
  for (std::size_t p = 0; p < 21; ++p) {
    outcome.actual =
        std::max(outcome.actual, length(world.coupling.cord(0).positions()[p] - exact.coupling.cord(0).positions()[p]));
  }
  return outcome;
}

TEST(ErrorEstimate, HasTheSizeAndTheOrderOfTheError) {
  std::vector<Outcome> tr_bdf2;
  for (const int substeps : {1, 2, 4}) tr_bdf2.push_back(run({Integrator::tr_bdf2, substeps, 8, 1e-6}));
  const Outcome euler = run({Integrator::implicit_euler, 1, 8, 1e-4});
  for (const Outcome& outcome : {tr_bdf2[0], tr_bdf2[1], tr_bdf2[2], euler}) {
    EXPECT_GT(outcome.estimated, 0.3 * outcome.actual);
    EXPECT_LT(outcome.estimated, 10.0 * outcome.actual);
  }
  EXPECT_NEAR(std::log2(tr_bdf2[0].estimated / tr_bdf2[2].estimated) / 2.0, 2.0, 0.4);
  EXPECT_GT(euler.estimated, 3.0 * tr_bdf2[0].estimated);
}

TEST(ErrorEstimate, ChangesNoBitOfTheRun) {
  SwingWorld watched(Accuracy::balanced());
  SwingWorld alone(Accuracy::balanced());
  for (int k = 0; k < 60; ++k) {
    watched.coupling.estimate_errors(k % 3 == 0);
    watched.tick();
    alone.tick();
    EXPECT_EQ(watched.coupling.cord(0).error() > 0.0, k % 3 == 0);
    EXPECT_EQ(alone.coupling.cord(0).error(), 0.0);
  }
  EXPECT_TRUE(watched.coupling.cord(0).direct().save() == alone.coupling.cord(0).direct().save());
  EXPECT_EQ(watched.load->GetPosition().x, alone.load->GetPosition().x);
  EXPECT_TRUE(watched.coupling.cord(0).island_report() == alone.coupling.cord(0).island_report());
}

/// The estimate copies each cord's state in every tick, and does not accumulate copies.
TEST(ErrorEstimate, UsesBoundedMemory) {
  SwingWorld world(Accuracy::balanced());
  world.coupling.estimate_errors(true);
  const auto taken_in_a_tick = [&] {
    const test_support::AllocationCount count;
    test_support::step_cords(world.coupling, world.box2d, dt);
    const long taken = count.so_far();
    world.box2d.Step(static_cast<float>(dt), 8, 3);
    return taken;
  };
  for (int k = 0; k < 10; ++k) taken_in_a_tick();
  const test_support::AllocationCount count;
  const long first = taken_in_a_tick();
  for (int k = 0; k < 3000; ++k) ASSERT_EQ(taken_in_a_tick(), first);
  EXPECT_EQ(count.held(), 0);
}

/// Cords that are added while errors are estimated, and those of the thesis's solver beside them.
TEST(ErrorEstimate, FollowsAddedAndRemovedCords) {
  SwingWorld world(Accuracy::balanced());
  world.coupling.estimate_errors(true);
  world.tick();
  ribbon::ThesisDef thesis;
  thesis.w = 5;
  thesis.h = 2;
  const ribbon::box2d::CordId other = world.coupling.add(ribbon::ThesisCord(thesis));
  const ribbon::box2d::CordId third = world.coupling.add(ribbon::Cord(swinging(Accuracy::fast())));
  world.tick();
  EXPECT_EQ(world.coupling.cord(other).error(), 0.0);
  EXPECT_GT(world.coupling.cord(third).error(), world.coupling.cord(0).error());
  EXPECT_GT(world.coupling.cord(0).error(), 0.0);
}

}  // namespace
}  // namespace engine
