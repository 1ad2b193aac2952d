#include <gtest/gtest.h>

#include "ribbon/box2d/coupling.h"

// What a coupling tells of a cord, whichever solver moves it.

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double dt = 1.0 / 60.0;

/// A ribbon of 5 × 2 points of each solver, 2 m long and 0.5 m wide, in a world without gravity.
struct OneOfEach {
  b2World world{{0.0F, 0.0F}};
  Coupling coupling;

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
  void tick() {
    coupling.gather(world, dt);
    coupling.step();
    coupling.apply();
    world.Step(static_cast<float>(dt), 8, 3);
  }
};

TEST(CouplingCords, KnowsWhichSolverACordHas) {
  const OneOfEach each;
  EXPECT_EQ(each.coupling.solver(0), Solver::thesis);
  EXPECT_EQ(each.coupling.solver(1), Solver::direct);
  EXPECT_EQ(solver_name(Solver::thesis), "thesis");
  EXPECT_EQ(solver_name(Solver::direct), "direct");
}

TEST(CouplingCords, TellsTheShapeOfEither) {
  const OneOfEach each;
  for (const CordIndex cord : {0, 1}) {
    EXPECT_EQ(each.coupling.shape(cord).columns, 5);
    EXPECT_EQ(each.coupling.shape(cord).rows, 2);
    EXPECT_EQ(each.coupling.positions(cord).size(), 10U);
  }
  EXPECT_DOUBLE_EQ(each.coupling.shape(0).thickness, 0.5);
  EXPECT_DOUBLE_EQ(each.coupling.shape(1).thickness, 0.52);
  EXPECT_TRUE(each.coupling.shape(0).braced);
  EXPECT_FALSE(each.coupling.shape(1).braced);
}

TEST(CouplingCords, DragsAndLetsGoAPointOfEither) {
  OneOfEach each;
  for (const CordIndex cord : {0, 1}) {
    EXPECT_EQ(each.coupling.kind(cord, 0), ribbon::PointKind::constrained);
    EXPECT_EQ(each.coupling.kind(cord, 9), ribbon::PointKind::free);
    const Vec2 target = each.coupling.positions(cord)[9] + Vec2{-0.01, 0.02};
    each.coupling.operate(cord, 9, target);
    EXPECT_EQ(each.coupling.kind(cord, 9), ribbon::PointKind::operated);
    each.tick();
    EXPECT_LT(length(each.coupling.positions(cord)[9] - target), 1e-12);
    each.coupling.release(cord, 9);
    EXPECT_EQ(each.coupling.kind(cord, 9), ribbon::PointKind::free);
    EXPECT_THROW(each.coupling.operate(cord, 10, target), ribbon::DefinitionError);
    EXPECT_THROW(each.coupling.release(cord, -1), ribbon::DefinitionError);
  }
}

TEST(CouplingCords, SumsUpTheReportsOfADirectCord) {
  OneOfEach each;
  ribbon::CordReport sum;
  for (int k = 0; k < 5; ++k) {
    each.coupling.operate(1, 9, each.coupling.positions(1)[9] + Vec2{0.0, 0.05});
    each.tick();
    sum += each.coupling.report(1);
  }
  EXPECT_GT(sum.iterations, 5);
  EXPECT_EQ(each.coupling.total(1), sum);
  EXPECT_EQ(each.coupling.total(0), ribbon::CordReport{});
}

}  // namespace
}  // namespace engine
