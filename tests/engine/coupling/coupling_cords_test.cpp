#include <gtest/gtest.h>

#include "ribbon/box2d/coupling.h"

// What a coupling reports about a cord of either solver.

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double dt = 1.0 / 60.0;

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
  ribbon::CordReport sum;
  for (int k = 0; k < 5; ++k) {
    each.coupling.cord(1).drag(9, each.coupling.cord(1).positions()[9] + Vec2{0.0, 0.05});
    each.tick();
    sum += each.coupling.cord(1).island_report();
  }
  EXPECT_GT(sum.iterations, 5);
  EXPECT_EQ(each.coupling.cord(1).island_total(), sum);
  EXPECT_EQ(each.coupling.cord(0).island_total(), ribbon::CordReport{});
}

}  // namespace
}  // namespace engine
