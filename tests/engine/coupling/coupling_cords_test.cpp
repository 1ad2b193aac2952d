#include <gtest/gtest.h>

#include "ribbon/box2d/coupling.h"
#include "tests/support/constants.h"
#include "tests/support/coupled_world.h"
#include "tests/support/points.h"

// What a coupling reports about a cord of either solver.

namespace engine {
namespace {

using constants::dt;
using ribbon::Vec2;

/// A ribbon of 5 × 2 points of each solver, 2 m long and 0.5 m wide, in a world without gravity.
struct OneOfEach {
  b2World world{{0.0F, 0.0F}};
  ribbon::box2d::Coupling coupling;

  OneOfEach() {
    ribbon::ThesisDef thesis;
    thesis.w = 5;
    thesis.spacing = 0.5;
    thesis.pins = {0};
    coupling.add(ribbon::ThesisCord(thesis));
    ribbon::CordDef direct;
    direct.points = 5;
    direct.rows = 2;
    direct.length = 2.0;
    direct.width = 0.5;
    direct.radius = 0.01;
    direct.stretch_stiffness = 1000.0;
    direct.pins = {0};
    coupling.add(ribbon::Cord(direct));
  }
  void tick() { coupling.tick(world, dt); }
};

TEST(CouplingCords, KnowsWhichSolverACordHas) {
  const OneOfEach each;
  EXPECT_EQ(each.coupling.cord(0).solver(), ribbon::box2d::Solver::thesis);
  EXPECT_EQ(each.coupling.cord(1).solver(), ribbon::box2d::Solver::direct);
  EXPECT_EQ(ribbon::box2d::solver_name(ribbon::box2d::Solver::thesis), "thesis");
  EXPECT_EQ(ribbon::box2d::solver_name(ribbon::box2d::Solver::direct), "direct");
}

TEST(CouplingCords, ReportsTheShapeOfEither) {
  const OneOfEach each;
  for (const ribbon::box2d::CordId cord : {0, 1}) {
    EXPECT_EQ(each.coupling.cord(cord).shape().columns, 5);
    EXPECT_EQ(each.coupling.cord(cord).shape().rows, 2);
    EXPECT_EQ(each.coupling.cord(cord).positions().size(), 10U);
  }
  EXPECT_DOUBLE_EQ(each.coupling.cord(0).shape().thickness, 0.5);
  EXPECT_DOUBLE_EQ(each.coupling.cord(1).shape().thickness, 0.52);
  EXPECT_TRUE(each.coupling.cord(0).shape().braced);
  EXPECT_FALSE(each.coupling.cord(1).shape().braced);
}

TEST(CouplingCords, DragsAndFreesAPointOfEither) {
  OneOfEach each;
  for (const ribbon::box2d::CordId cord : {0, 1}) {
    EXPECT_EQ(each.coupling.cord(cord).kind(0), ribbon::PointKind::constrained);
    EXPECT_EQ(each.coupling.cord(cord).kind(9), ribbon::PointKind::free);
    const Vec2 target = each.coupling.cord(cord).positions()[9] + Vec2{-0.01, 0.02};
    each.coupling.cord(cord).drag(9, target);
    EXPECT_EQ(each.coupling.cord(cord).kind(9), ribbon::PointKind::operated);
    each.tick();
    EXPECT_LT(length(each.coupling.cord(cord).positions()[9] - target), 1e-12);
    each.coupling.cord(cord).free(9);
    EXPECT_EQ(each.coupling.cord(cord).kind(9), ribbon::PointKind::free);
    EXPECT_THROW(each.coupling.cord(cord).drag(10, target), ribbon::DefinitionError);
    EXPECT_THROW(each.coupling.cord(cord).free(-1), ribbon::DefinitionError);
  }
}

TEST(CouplingCords, SumsUpTheReportsOfADirectCord) {
  OneOfEach each;
  ribbon::IslandReport sum;
  for (int k = 0; k < 5; ++k) {
    each.coupling.cord(1).drag(9, each.coupling.cord(1).positions()[9] + Vec2{0.0, 0.05});
    each.tick();
    sum += each.coupling.cord(1).island_report();
  }
  EXPECT_GT(sum.iterations, 5);
  EXPECT_EQ(each.coupling.cord(1).island_total(), sum);
  EXPECT_EQ(each.coupling.cord(0).island_total(), ribbon::IslandReport{});
}

/// Two ropes across each other, and a third one elsewhere under a ball.
TEST(CouplingCords, ReportsTheContactsOfEachCord) {
  test_support::CoupledWorld world({});
  const auto across = [](Vec2 start, Vec2 step) {
    ribbon::CordDef def;
    def.points = 11;
    def.length = 10.0 * length(step);
    def.radius = 0.02;
    def.cord_contact = true;
    def.pins = {0, 10};
    def.positions = test_support::equally_spaced(11, start, step);
    return def;
  };
  const int below = world.add(across({-0.5, 0.0}, {0.1, 0.0}));
  ribbon::CordDef falling = across({-0.05, 0.05}, {0.01, 0.0});
  falling.pins = {};
  const int above = world.add(falling);
  ribbon::CordDef apart = across({9.5, 0.0}, {0.1, 0.0});
  apart.cord_contact = false;
  const int under_ball = world.add(apart);
  const b2Body& ball = world.add_circle(b2_dynamicBody, {10.0, 0.13}, 0.1, 2.0, 0.3);
  world.settle(240);

  const auto report = [&world](int cord) { return world.coupling.cord(cord).report(); };
  EXPECT_EQ(report(below).island, report(above).island);
  EXPECT_NE(report(below).island, report(under_ball).island);
  EXPECT_GT(report(above).contacts, 0);
  EXPECT_EQ(report(below).contacts, report(above).contacts);
  EXPECT_EQ(report(below).max_normal_force, report(above).max_normal_force);
  EXPECT_LT(report(above).max_normal_force, 9.81 * falling.length * falling.mass_per_length);
  const double weight = 9.81 * static_cast<double>(ball.GetMass());
  EXPECT_EQ(report(under_ball).contacts, 2) << "both links at the point under its centre";
  EXPECT_NEAR(report(under_ball).max_normal_force, 0.5 * weight, 0.01 * weight);
  EXPECT_EQ(report(under_ball).position_error, 0.0);
  world.coupling.restore(world.coupling.save(world.world), world.world);
  EXPECT_EQ(report(under_ball), ribbon::CordReport{});
}

/// Of two ropes of an island only the one that is pulled beyond its length has an error.
TEST(CouplingCords, ReportsTheErrorOfTheCordThatHasIt) {
  test_support::CoupledWorld world({});
  ribbon::CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.pins = {0};
  def.positions = test_support::equally_spaced(11, {0.0, 0.0}, {0.0, -0.1});
  const int hanging = world.add(def);
  def.positions = test_support::equally_spaced(11, {2.0, 0.0}, {0.0, -0.1});
  const int torn = world.add(def);
  b2Body& body = world.add_circle(b2_dynamicBody, {1.0, -1.2}, 0.1, 1.0, 0.3);
  for (const int cord : {hanging, torn}) world.hold(cord, 10, body);
  world.coupling.cord(torn).drag(5, {3.0, 0.0});
  ribbon::CordReport last;
  for (int k = 0; k < 20 && last.position_error == 0.0; ++k) {
    world.tick();
    last = world.coupling.cord(torn).report();
    EXPECT_EQ(world.coupling.cord(torn).report().island, world.coupling.cord(hanging).report().island);
  }
  EXPECT_GT(last.position_error, world.coupling.cord(hanging).report().position_error);
  EXPECT_GE(world.coupling.last_step().report().position_error, last.position_error);
}

}  // namespace
}  // namespace engine
