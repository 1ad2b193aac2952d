#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/points.h"

// Cords that are driven: reels, loads, dragged points.

namespace ribbon {
namespace {

using constants::gravity;
using constants::infinity;
using constants::nan;
using test_support::all_finite;
using test_support::hanging;

double rest_length(const Cord& cord) {
  double sum = 0.0;
  for (int i = 0; i + 1 < cord.def().points; ++i) sum += cord.rest_length(i);
  return sum;
}

TEST(CordReel, LiftsItsLoadAtItsSpeedAndStops) {
  for (const double stiffness : {infinity, 1e6}) {
    CordDef def = hanging(51, 10.0);
    def.stretch_stiffness = stiffness;
    Cord cord(def);
    cord.attach_mass(50, 70.0);
    for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
    cord.reel(0, 50, 5.0, 1.0);
    double fastest = 0.0;
    for (int k = 0; k < 400; ++k) {
      cord.step(1.0 / 60.0, gravity);
      fastest = std::max(fastest, length(cord.velocities()[50]));
    }
    EXPECT_NEAR(rest_length(cord), 5.0, 1e-12);
    EXPECT_NEAR(cord.positions()[50].y, -5.0, stiffness == infinity ? 1e-6 : 0.06);
    EXPECT_NEAR(cord.positions()[50].x, 0.0, 1e-9);
    // An inextensible cord moves its load as fast as the winch; an elastic one oscillates.
    EXPECT_LT(fastest, stiffness == infinity ? 1.2 : 2.1);
  }
}

/// The work of the winch is Σ λ·(−dl) over the links: tension times change of rest length.
TEST(CordReel, AddsExactlyTheWorkOfTheWinch) {
  CordDef def = hanging(21, 4.0);
  def.accuracy = Accuracy::accurate();
  Cord cord(def);
  cord.attach_mass(20, 20.0);
  for (int p = 0; p <= 20; ++p) cord.set_velocity(p, {0.15 * p, 0.0});  // swinging
  cord.step(1.0 / 240.0, gravity);
  cord.reel(0, 20, 2.0, 0.5);
  double work = 0.0;
  double before = energy_of(cord, gravity).total();
  const double start = before;
  for (int k = 0; k < 4 * 240; ++k) {
    std::vector<double> rest;
    for (int i = 0; i < 20; ++i) rest.push_back(cord.rest_length(i));
    const std::vector<double> pull(cord.tensions().begin(), cord.tensions().end());
    cord.step(1.0 / 240.0, gravity);
    for (int i = 0; i < 20; ++i) {
      const auto e = static_cast<std::size_t>(i);
      work += 0.5 * (pull[e] + cord.tensions()[e]) * (rest[e] - cord.rest_length(i));
    }
  }
  const double gained = energy_of(cord, gravity).total() - start;
  EXPECT_GT(gained, 20.0 * 9.81 * 1.0);
  EXPECT_NEAR(gained / work, 1.0, 0.02);
}

/// Start, reversal and stop of a fast winch with a load of a thousand times the cord's mass: no point is faster than
/// the winch, and after the stop the energy only decreases.
TEST(CordReel, StartsReversesAndStopsWithoutAJerk) {
  CordDef def = hanging(31, 3.0);
  Cord cord(def);
  cord.attach_mass(30, 300.0);
  double fastest = 0.0;
  IslandReport report;
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k) {
      report += cord.step(1.0 / 60.0, gravity);
      for (const Vec2 v : cord.velocities()) fastest = std::max(fastest, length(v));
    }
  };
  run(30);
  cord.reel(0, 30, 0.3, 3.0);
  run(20);
  cord.reel(0, 30, 3.0, 3.0);
  run(20);
  cord.reel(0, 30, 0.03, 3.0);
  run(120);
  EXPECT_NEAR(rest_length(cord), 0.03, 1e-12);
  // The fall is limited by the winch: 3 m/s up, and 3 m/s plus g/3 s down.
  EXPECT_LT(fastest, 3.0 + 9.81 / 3.0 + 0.5);
  EXPECT_EQ(report.unconverged, 0);
  double last = energy_of(cord, gravity).total();
  for (int k = 0; k < 300; ++k) {
    cord.step(1.0 / 60.0, gravity);
    const double now = energy_of(cord, gravity).total();
    EXPECT_LE(now, last + 1e-3 * 301.0 * 9.81 * 3.0);
    last = std::min(last, now);
  }
}

TEST(CordReel, TakesPartOfTheCord) {
  Cord cord(hanging(11, 1.0));
  cord.reel(0, 3, 0.15, 0.5);
  for (int k = 0; k < 60; ++k) cord.step(1.0 / 60.0, gravity);
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(cord.rest_length(i), i < 3 ? 0.05 : 0.1, 1e-15);
  EXPECT_NEAR(length(cord.positions()[2] - cord.positions()[1]), 0.05, 1e-7);
  EXPECT_NEAR(cord.positions()[10].y, -0.85, 0.01);
}

TEST(CordReel, WorksForBendingRopesAndRibbons) {
  CordDef rope = hanging(11, 1.0);
  rope.bending_stiffness = 0.01;
  CordDef ribbon;
  ribbon.points = 11;
  ribbon.rows = 3;
  ribbon.length = 1.0;
  ribbon.width = 0.2;
  ribbon.damping = 0.02;
  solid(1e6, 0.2, 0.05, 0.2).apply_to(ribbon);
  ribbon.pins = {0, 1, 2};
  for (int i = 0; i < 11; ++i) {
    for (int j = 0; j < 3; ++j) ribbon.positions.push_back({0.1 * j, -0.1 * i});
  }
  for (const CordDef& def : {rope, ribbon}) {
    Cord cord(def);
    cord.reel(0, 10, 0.6, 0.5);
    IslandReport report;
    for (int k = 0; k < 600; ++k) report += cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(report.unconverged, 0);
    EXPECT_NEAR(cord.positions().back().y, -0.6, 5e-3) << def.rows;
  }
}

/// Repeated reeling of a part leaves every link with a length.
TEST(CordReel, EveryLinkKeepsAPositiveLength) {
  Cord cord(hanging(11, 1.0));
  int refused = 0;
  for (int k = 0; k < 40; ++k) {
    try {
      cord.reel(0, 2, 2.0002e-4, 1e6);
    } catch (const DefinitionError&) {
      ++refused;
    }
    cord.step(1.0 / 60.0, gravity);
    try {
      cord.reel(1, 2, 0.1, 1e6);
    } catch (const DefinitionError&) {
      ++refused;
    }
    cord.step(1.0 / 60.0, gravity);
    for (int i = 0; i < 10; ++i) ASSERT_GE(cord.rest_length(i), 0.99e-4);
  }
  EXPECT_GT(refused, 0);
  EXPECT_TRUE(all_finite(cord.positions()));
}

TEST(CordReel, RefusesInvalidArguments) {
  Cord cord(hanging(11, 1.0));
  const Cord::State before = cord.save();
  EXPECT_THROW(cord.reel(-1, 5, 0.5, 1.0), DefinitionError);
  EXPECT_THROW(cord.reel(5, 5, 0.5, 1.0), DefinitionError);
  EXPECT_THROW(cord.reel(0, 11, 0.5, 1.0), DefinitionError);
  EXPECT_THROW(cord.reel(0, 10, 0.0, 1.0), DefinitionError);
  EXPECT_THROW(cord.reel(0, 10, nan, 1.0), DefinitionError);
  EXPECT_THROW(cord.reel(0, 10, 0.5, 0.0), DefinitionError);
  EXPECT_THROW(cord.reel(0, 10, 0.5, infinity), DefinitionError);
  EXPECT_EQ(cord.save(), before);
}

TEST(CordLoad, PullsUntilItIsSetAgain) {
  Cord cord(hanging(11, 1.0));
  cord.set_load(10, {50.0, 0.0});
  for (int k = 0; k < 2000; ++k) cord.step(1.0, gravity);
  // Force balance at the lowest link: its direction is that of the load and half a link's weight.
  const Vec2 link = cord.positions()[10] - cord.positions()[9];
  EXPECT_NEAR(link.y / link.x, -cord.mass(10) * 9.81 / 50.0, 1e-9);
  EXPECT_NEAR(cord.tensions()[9], std::hypot(50.0, cord.mass(10) * 9.81), 1e-6);
  cord.set_load(10, {});
  for (int k = 0; k < 2000; ++k) cord.step(1.0, gravity);
  EXPECT_NEAR(cord.positions()[10].x, 0.0, 1e-6);
}

TEST(CordDragged, FollowsTheTargetAndKeepsItsVelocityWhenReleased) {
  Cord cord(hanging(11, 1.0));
  EXPECT_EQ(cord.kind(0), PointKind::constrained);
  EXPECT_EQ(cord.kind(5), PointKind::free);
  for (int k = 1; k <= 30; ++k) {
    const Vec2 hand = Vec2{0.02 * k, -0.5 + 0.005 * k};
    cord.operate(5, hand);
    EXPECT_EQ(cord.kind(5), PointKind::operated);
    EXPECT_EQ(cord.target(5), hand);
    cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(cord.positions()[5], hand);
  }
  cord.release(5);
  EXPECT_EQ(cord.kind(5), PointKind::free);
  EXPECT_NEAR(cord.velocities()[5].x, 1.2, 1e-9);
}

/// A target beyond the length of an inextensible cord: all numbers stay finite, and the cord's length shows the error.
TEST(CordDragged, StaysFiniteWhenDraggedTooFar) {
  Cord cord(hanging(11, 1.0));
  for (int k = 1; k <= 60; ++k) {
    cord.operate(10, {0.1 * k, -1.0});
    cord.step(1.0 / 60.0, gravity);
    ASSERT_TRUE(all_finite(cord.positions()));
  }
  cord.release(10);
  for (int k = 0; k < 120; ++k) cord.step(1.0 / 60.0, gravity);
  double sum = 0.0;
  for (std::size_t p = 1; p < 11; ++p) sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

/// A dragged pin that arrives at its target stops. The next step restarts the integrator, as after an explicit stop.
TEST(CordDragged, APinThatStopsByItselfStopsTheCordSmoothly) {
  const auto end = [](bool told) {
    Cord cord(hanging(21, 2.0));
    for (int k = 0; k < 30; ++k) {
      if (k < 10) cord.constrain(0, {0.05 * (k + 1), 0.0});
      if (k >= 10 && told) cord.constrain(0, {0.5, 0.0});
      cord.step(1.0 / 60.0, gravity);
      if (k == 10) return cord.save();
    }
    return cord.save();
  };
  EXPECT_EQ(end(false), end(true));
}

TEST(CordLoad, PotentialIsTheWorkDone) {
  Cord cord(hanging(3, 1.0));
  const double before = energy_of(cord, {}).potential;
  cord.set_load(2, {3.0, -4.0});
  EXPECT_EQ(before, 0.0);
  EXPECT_NEAR(energy_of(cord, {}).potential, -(-4.0 * -1.0), 1e-12);
}

TEST(CordAccuracy, AChangeTakesEffectInTheNextStep) {
  Cord changed(hanging(21, 2.0));
  changed.set_velocity(20, {3.0, 0.0});
  for (int k = 0; k < 10; ++k) changed.step(1.0 / 60.0, gravity);
  const Accuracy fine{Integrator::tr_bdf2, 16, 8, 1e-7};
  CordDef def = hanging(21, 2.0);
  def.accuracy = fine;
  Cord other(def);
  other.restore(changed.save());
  changed.set_accuracy(fine);
  for (int k = 0; k < 10; ++k) {
    const IslandReport report = changed.step(1.0 / 60.0, gravity);
    EXPECT_EQ(report.stages, 32);
    EXPECT_TRUE(report == other.step(1.0 / 60.0, gravity));
  }
  EXPECT_TRUE(changed.save() == other.save());
  changed.set_accuracy(Accuracy::fast());
  EXPECT_EQ(changed.step(1.0 / 60.0, gravity).stages, 1);
  EXPECT_THROW(changed.set_accuracy({Integrator::tr_bdf2, 0, 8, 1e-7}), DefinitionError);
  EXPECT_TRUE(changed.def().accuracy == Accuracy::fast());
}

/// Returns the energy of a cord and its loads in the inertial frame that moves at `velocity` [m/s] and was at the
/// origin at the time 0, J.
double energy_in_frame(const Cord& cord, Vec2 velocity, double time) {
  const CordEnergy energy = energy_of(cord, gravity);
  double sum = energy.elastic;
  for (int p = 0; p < cord.def().points; ++p) {
    const auto k = static_cast<std::size_t>(p);
    const Vec2 v = cord.velocities()[k] - velocity;
    sum += cord.mass(p) * (0.5 * dot(v, v) - dot(gravity, cord.positions()[k] - time * velocity));
  }
  return sum;
}

/// A load falls into its rope. A pin that moves steadily is at rest in an inertial frame: there the jerk may not throw
/// the load back. Drag, whose medium moves in that frame, may do a little work.
TEST(CordDrive, GivesNoEnergyToAJerk) {
  for (const Vec2 velocity : {Vec2{}, Vec2{0.01, 0.0}, Vec2{2.0, 0.5}, Vec2{-20.0, 3.0}}) {
    for (const double drag : {0.0, 0.8}) {
      for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
        CordDef def = hanging(21, 4.0);
        def.drag = drag;
        def.accuracy = accuracy;
        Cord cord(def);
        cord.attach_mass(20, 70.0);
        for (int p = 0; p <= 20; ++p) cord.set_velocity(p, velocity + (p == 20 ? Vec2{0.3, 6.0} : Vec2{}));
        double lowest = energy_in_frame(cord, velocity, 0.0);
        IslandReport report;
        for (int k = 1; k <= 300; ++k) {
          const double time = k / 60.0;
          cord.constrain(0, time * velocity);
          report += cord.step(1.0 / 60.0, gravity);
          const double now = energy_in_frame(cord, velocity, time);
          const double drag_work = drag * 1.0 * length(velocity) * (10.0 + length(velocity)) / 60.0;
          ASSERT_LE(now, lowest + 2e-3 * 71.0 * 9.81 * 4.0 + k * drag_work) << velocity.x << " m/s, tick " << k;
          lowest = std::min(lowest, now);
        }
        EXPECT_EQ(report.unconverged, 0) << velocity.x << " m/s";
      }
    }
  }
}

}  // namespace
}  // namespace ribbon
