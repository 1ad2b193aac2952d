#include "ribbon/thesis/thesis_cord.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "tests/support/allocations.h"
#include "tests/support/thesis_scenes.h"

namespace ribbon {
namespace {

using test_support::earth_gravity;
using test_support::frame_dt;
using test_support::thesis_conditions;

/// A free cord of 20 × 2 points without drag.
ThesisDef free_def() {
  ThesisDef def = test_support::thesis_def(thesis_conditions[0]);
  def.w = 20;
  def.drag = 0.0;
  return def;
}

std::vector<int> first_column(int h) {
  std::vector<int> pins(static_cast<std::size_t>(h));
  std::iota(pins.begin(), pins.end(), 0);
  return pins;
}

TEST(ThesisCord, FallsAtTheSameRateWithAnyNumberOfSubsteps) {
  // y = −½·g·t·(t + δ) exactly: symplectic Euler with the substep δ.
  for (const int substeps : {1, 4, 32}) {
    ThesisDef def = free_def();
    def.substeps = substeps;
    ThesisCord cord(def);
    for (int frame = 0; frame < 12; ++frame) cord.step(frame_dt, earth_gravity);
    const double expected = -0.5 * 9.81 * 0.2 * (0.2 + frame_dt / substeps);
    EXPECT_NEAR(cord.positions()[10].y - (ThesisCord(def).positions()[10].y), expected, 1e-9);
  }
}

TEST(ThesisCord, DragReducesSpeedAtItsRate) {
  ThesisDef def = free_def();
  def.drag = 0.7;
  ThesisCord cord(def);
  for (int p = 0; p < cord.mesh().size(); ++p) cord.set_velocity(p, {3.0, 0.0});
  for (int frame = 0; frame < 60; ++frame) cord.step(frame_dt, {});
  EXPECT_NEAR(cord.velocities()[5].x, 3.0 * std::exp(-0.7), 1e-3);
  EXPECT_NEAR(cord.velocities()[5].x, 3.0 * std::pow(1.0 / (1.0 + 0.7 * frame_dt / 8), 480), 1e-10);
}

TEST(ThesisCord, ConservesLinearMomentum) {
  ThesisCord cord(free_def());
  for (int p = 0; p < cord.mesh().size(); ++p) {
    cord.set_velocity(p, {std::sin(3.0 * p), std::cos(5.0 * p)});
  }
  const Vec2 before = test_support::momentum(cord);
  const Vec2 centre = test_support::centre_of_mass(cord);
  StepReport total;
  for (int frame = 0; frame < 300; ++frame) {
    const StepReport report = cord.step(frame_dt, {});
    total.self_contacts += report.self_contacts;
    total.motion_limited += report.motion_limited;
  }
  EXPECT_EQ(total.motion_limited, 0);
  const double mass = cord.mesh().size() * cord.def().point_mass;
  EXPECT_NEAR(length(test_support::momentum(cord) - before), 0.0, 1e-9 * mass);
  EXPECT_NEAR(length(test_support::centre_of_mass(cord) - centre - (5.0 / mass) * before), 0.0, 1e-9);
}

/// The report shows errors: bars off their length, inverted triangles, spurious energy. At rest it shows none.
TEST(ThesisCord, ReportsErrorsOfItsStep) {
  ThesisDef def = free_def();
  const ThesisCord rest(def);
  ThesisCord still(def);
  for (int frame = 0; frame < 60; ++frame) EXPECT_EQ(still.step(frame_dt, {}), StepReport{}) << frame;

  def.positions.assign(rest.positions().begin(), rest.positions().end());
  for (Vec2& p : def.positions) p.x *= 1.2;
  ThesisCord longer(def);
  EXPECT_GT(longer.step(frame_dt, {}).strained_bars, 0);

  def.positions.assign(rest.positions().begin(), rest.positions().end());
  for (Vec2& p : def.positions) p.y = -p.y;
  def.area_stiffness = 0.0;
  ThesisCord reflected(def);
  EXPECT_EQ(reflected.step(frame_dt, {}).turned_over, static_cast<int>(rest.mesh().triangles.size()));
}

/// A circle that appears inside the cord adds energy, which is reported. While a point is dragged, that is unknown.
TEST(ThesisCord, ReportsSpuriousEnergy) {
  const auto gains = [](bool dragged) {
    ThesisCord cord(free_def());
    std::vector<RigidBody> bodies(1);
    bodies[0].position = cord.positions()[20] + Vec2{0.0, -0.01};
    const std::vector<RigidCircle> circles = {{0, {}, 0.05}};
    int total = 0;
    for (int frame = 0; frame < 10; ++frame) {
      if (dragged) cord.operate(0, cord.positions()[0] + Vec2{1e-9, 0.0});
      total += cord.step(frame_dt, {}, {bodies, circles, {}}).energy_gains;
    }
    return total;
  };
  EXPECT_GT(gains(false), 0);
  EXPECT_EQ(gains(true), 0);
}

TEST(ThesisCord, IsInvariantUnderRotationAndTranslation) {
  // The same swing, turned by the angle of (0.6, 0.8) and 10 km off.
  const auto swing = [](Vec2 x_axis, Vec2 origin) {
    ThesisDef def = free_def();
    def.positions = lay_along(std::array{origin, origin + x_axis}, def.w, def.h, def.spacing);
    def.pins = first_column(2);
    ThesisCord cord(def);
    for (int frame = 0; frame < 60; ++frame) cord.step(frame_dt, -9.81 * perp(x_axis));
    const Vec2 tip = cord.positions().back() - origin;
    return Vec2{dot(tip, x_axis), dot(tip, perp(x_axis))};
  };
  const Vec2 here = swing({1.0, 0.0}, {0.0, 0.0});
  EXPECT_NEAR(length(swing({0.6, 0.8}, {0.0, 0.0}) - here), 0.0, 1e-9);
  EXPECT_NEAR(length(swing({1.0, 0.0}, {1e4, -1e4}) - here), 0.0, 1e-6);
}

TEST(ThesisCord, DraggingAPointPullsItsNeighboursTheSameWay) {
  for (const Vec2 way : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{-0.6, -0.8}}) {
    ThesisCord cord(free_def());
    const int dragged = cord.mesh().index(10, 0);
    const std::vector<Vec2> before(cord.positions().begin(), cord.positions().end());
    for (int frame = 1; frame <= 5; ++frame) {
      cord.operate(dragged, before[static_cast<std::size_t>(dragged)] + (0.01 * frame) * way);
      cord.step(frame_dt, {});
    }
    EXPECT_EQ(cord.kind(dragged), PointKind::operated);
    for (const Connection& bar : cord.mesh().connections) {
      if (bar.a != dragged && bar.b != dragged) continue;
      const auto neighbour = static_cast<std::size_t>(bar.a == dragged ? bar.b : bar.a);
      EXPECT_GT(dot(cord.positions()[neighbour] - before[neighbour], way), 0.005);
    }
  }
}

TEST(ThesisCord, DrivenPointsMoveEvenlyAndArriveExactly) {
  ThesisCord cord(free_def());
  cord.operate(0, {-0.3, 0.2});
  cord.step(frame_dt, earth_gravity);
  EXPECT_EQ(cord.positions()[0], (Vec2{-0.3, 0.2}));
  cord.step(frame_dt, earth_gravity);
  EXPECT_EQ(cord.positions()[0], (Vec2{-0.3, 0.2}));
  EXPECT_EQ(cord.velocities()[0], (Vec2{0.0, 0.0}));
  cord.release(0);
  cord.step(frame_dt, earth_gravity);
  EXPECT_NE(cord.positions()[0], (Vec2{-0.3, 0.2}));
}

/// If the inertia is lost beside the stiffness in double precision, the system of a free cord is singular.
TEST(ThesisCord, ContinuesWithSpringsAfterAFailedSolveAndCountsIt) {
  ThesisDef def = free_def();
  def.point_mass = 1e-9;
  def.bar_damping = 1e15;
  def.spring_stiffness = 1.0;
  ThesisCord cord(def);
  int skipped = 0;
  for (int frame = 0; frame < 60; ++frame) skipped += cord.step(frame_dt, earth_gravity).fem_skipped;
  EXPECT_GT(skipped, 0);
  EXPECT_TRUE(test_support::all_finite(cord));
  EXPECT_LT(test_support::centre_of_mass(cord).y, -0.1);  // it did fall

  class NeverSolves final : public LinearSolver {
    bool solve(BandedMatrix&, std::span<double>) override { return false; }
  };
  ThesisDef springs_alone = free_def();
  springs_alone.bar_damping = 0.0;
  ThesisCord failing(free_def(), std::make_unique<NeverSolves>());
  ThesisCord without(springs_alone);
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_EQ(failing.step(frame_dt, earth_gravity).fem_skipped, def.substeps);
    EXPECT_EQ(without.step(frame_dt, earth_gravity).fem_skipped, 0);
  }
  EXPECT_EQ(failing.save(), without.save());
}

TEST(ThesisCord, AStepAfterTheFirstAllocatesNothing) {
  for (const auto& condition : thesis_conditions) {
    ThesisCord cord(test_support::hanging(condition));
    std::array<RigidBody, 2> bodies;
    bodies[0].position = {0.03, -0.4};
    bodies[0].inverse_mass = 2.0;
    const std::array<RigidCircle, 2> circles = {RigidCircle{0, {0.0, 0.0}, 0.1}, RigidCircle{1, {2.0, 0.0}, 0.1}};
    const std::array<Grip, 1> grips = {Grip{cord.mesh().size() - 1, 1, {0.0, -1.0}}};
    cord.step(frame_dt, earth_gravity, {bodies, circles, grips});
    const test_support::AllocationCount count;
    for (int frame = 0; frame < 60; ++frame) cord.step(frame_dt, earth_gravity, {bodies, circles, grips});
    EXPECT_EQ(count.so_far(), 0) << condition.name;
  }
}

TEST(ThesisCord, ATermThatIsOffIsNotRun) {
  ThesisDef def = free_def();
  def.spring_stiffness = 0.0;
  def.bar_damping = 0.0;
  def.area_stiffness = 0.0;
  def.self_collision = false;
  ThesisCord cord(def);
  cord.set_velocity(7, {1.0, 0.0});
  const Vec2 start = cord.positions()[7];
  const Vec2 neighbour = cord.positions()[9];
  for (int frame = 0; frame < 60; ++frame) cord.step(frame_dt, {});
  EXPECT_NEAR(cord.positions()[7].x - start.x, 1.0, 1e-12);  // a free particle: no term connects it to its neighbours
  EXPECT_EQ(cord.positions()[9], neighbour);
}

TEST(ThesisCord, RefusesBadNumbersAndChangesNothing) {
  ThesisCord cord(free_def());
  const ThesisCord::State before = cord.save();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cord.step(nan, {}), DefinitionError);
  EXPECT_THROW(cord.step(0.0, {}), DefinitionError);
  EXPECT_THROW(cord.step(frame_dt, {nan, 0.0}), DefinitionError);
  EXPECT_THROW(cord.add_momentum({0.0, nan}), DefinitionError);
  const std::array circles{RigidCircle{0, {}, 0.1}};
  EXPECT_THROW(cord.step(frame_dt, {}, {{}, circles, {}, {}}), DefinitionError);  // of a body that is not there
  ThesisCord::State state = before;
  state.kinds[0] = static_cast<PointKind>(3);
  EXPECT_THROW(cord.restore(state), DefinitionError);
  EXPECT_EQ(cord.save(), before);
}

TEST(ThesisCordSameBits, ARestoredCordRunsTheSame) {
  ThesisCord cord(test_support::hanging(thesis_conditions[1]));
  cord.operate(49, {0.3, -0.1});
  for (int frame = 0; frame < 20; ++frame) cord.step(frame_dt, earth_gravity);
  for (int round = 0; round < 10; ++round) {
    const ThesisCord::State state = cord.save();
    for (int frame = 0; frame < 5; ++frame) cord.step(frame_dt, earth_gravity);
    const ThesisCord::State after = cord.save();
    ThesisCord other(test_support::hanging(thesis_conditions[1]));
    other.restore(state);
    for (int frame = 0; frame < 5; ++frame) other.step(frame_dt, earth_gravity);
    EXPECT_EQ(other.save(), after);
    cord.restore(state);
    for (int frame = 0; frame < 7; ++frame) cord.step(frame_dt, earth_gravity);
  }
}

}  // namespace
}  // namespace ribbon
