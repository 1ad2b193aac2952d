#include "ribbon/pulley.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/geometry/rotation.h"
#include "ribbon/geometry/tangent.h"
#include "ribbon/linear/index.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"
#include "tests/support/pulleys.h"
#include "tests/support/refusal.h"

// Cords that run around wheels.

namespace ribbon {
namespace {

using constants::dt;
using constants::g;
using constants::gravity;
using test_support::Atwood;
using test_support::hanging;
using test_support::Machine;
using test_support::refusal;
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Returns the acceleration of Atwood's machine with a wheel of this inertia, m/s².
double acceleration(const Atwood& of) {
  const double wheel = of.wheel.inertia / (of.wheel.radius * of.wheel.radius);
  return (of.right - of.left) * g / (of.left + of.right + wheel);
}

/// The bar: within 0.1 % of the formula, the inertia of the wheel included.
TEST(Pulley, FollowsAtwoodsFormula) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    for (const double inertia : {0.0, 0.5, 5.0}) {
      for (const int points : {21, 61, 201}) {
        Atwood atwood;
        atwood.wheel.inertia = inertia;
        atwood.accuracy = accuracy;
        atwood.points = points;
        Machine machine(atwood);
        machine.step(120);
        const double speed = 2.0 * acceleration(atwood);
        EXPECT_NEAR(-machine.cord.velocities().back().y / speed, 1.0, 1e-3) << inertia << ' ' << points;
        EXPECT_NEAR(machine.cord.velocities().front().y / speed, 1.0, 1e-3);
        // The time step of implicit Euler shifts the way by half of a step.
        const double shift = accuracy.integrator == Integrator::implicit_euler ? 0.5 * dt / accuracy.substeps : 0.0;
        EXPECT_NEAR(machine.fall() / (0.5 * speed * (2.0 + 2.0 * shift)), 1.0, 1e-3);
        EXPECT_NEAR(machine.pulley().speed / speed, 1.0, 1e-3);
        EXPECT_NEAR(machine.pulley().turning, -machine.pulley().speed / 0.2, 1e-9);
        EXPECT_EQ(machine.unconverged, 0);
      }
    }
  }
}

TEST(Pulley, ShowsTheTensionsOnBothSides) {
  Machine machine(Atwood{});
  machine.step(60);
  const double a = acceleration(machine.atwood);
  EXPECT_NEAR(machine.pulley().tension_before / (10.0 * (g + a)), 1.0, 1e-3);
  EXPECT_NEAR(machine.pulley().tension_after / (12.0 * (g - a)), 1.0, 1e-3);
  EXPECT_NEAR(machine.cord.tensions().front() / (10.0 * (g + a)), 1.0, 1e-3);
  EXPECT_NEAR(machine.cord.tensions().back() / (12.0 * (g - a)), 1.0, 1e-3);
}

/// What hangs on a side pulls as it gets longer: y″ = (Δm + 2·μ·y)·g/M, so y = Δm/(2·μ)·(cosh(k·t) − 1) with k² =
/// 2·μ·g/M.
TEST(Pulley, WeighsTheCordOnEachSide) {
  Atwood atwood;
  atwood.mass_per_length = 0.1;
  Machine machine(atwood);
  const double mass = 22.0 + 0.5 / 0.04 + 0.1 * machine.cord.def().length;
  machine.step(150);
  const double k = std::sqrt(0.2 * g / mass);
  const double fall = 2.0 / 0.2 * (std::cosh(k * 150.0 * dt) - 1.0);
  EXPECT_NEAR(machine.fall() / fall, 1.0, 2e-3);
}

TEST(Pulley, RunsTheOtherWayRound) {
  Atwood atwood;
  atwood.wheel.counterclockwise = true;
  Machine machine(atwood);
  machine.step(60);
  EXPECT_NEAR(-machine.cord.velocities().back().y / acceleration(atwood), 1.0, 1e-3);
  EXPECT_GT(machine.pulley().turning, 0.0);
}

/// Points that leave and reach the wheel do not change the energy by more than the integrator does.
TEST(Pulley, KeepsTheEnergyAndTheLength) {
  Machine machine(Atwood{});
  const auto energy = [&machine] {
    const double wheel = 0.5 * 0.5 * machine.pulley().turning * machine.pulley().turning;
    return energy_of(machine.cord, gravity).total() + wheel;
  };
  const double before = energy();
  const double length_before = machine.cord.def().length;
  for (int k = 0; k < 150; ++k) {
    machine.step();
    EXPECT_NEAR(energy(), before, 1e-3 * 22.0 * g * 3.5);
    const Pulley& pulley = machine.pulley();
    double rest = 0.0;
    for (int link = pulley.def.before; link < pulley.def.after; ++link) rest += machine.cord.rest_length(link);
    const Vec2 x = machine.cord.positions()[at(pulley.def.after)] - machine.atwood.wheel.center;
    const double behind = leaving_line(x, 0.2, -1.0).length;
    EXPECT_NEAR(pulley.lead + 0.2 * pulley.arc + behind, rest, 1e-4 * length_before);
  }
}

/// Besides those on the arc, a wheel has at most the points within 0.7 of a link and one and a half steps on each side.
TEST(Pulley, TakesPointsUpAndLetsThemGo) {
  for (const double right : {20.0, 5.0}) {
    Atwood atwood;
    atwood.right = right;
    Machine machine(atwood);
    const int before = machine.pulley().def.before;
    for (int k = 0; k < 70; ++k) {
      machine.step();
      const Pulley& pulley = machine.pulley();
      const double link = machine.cord.rest_length(0);
      const double side = 1.7 * link + 1.5 * std::abs(pulley.speed) * dt;
      EXPECT_LE((pulley.def.after - pulley.def.before) * link, 0.2 * pulley.arc + 2.0 * side) << right << ' ' << k;
      EXPECT_GT(pulley.lead, 0.0);
    }
    EXPECT_GT(std::abs(machine.pulley().def.before - before), 5) << right;
  }
}

/// A cord over a wheel between two ends that are lifted above it bends away from it, and lies against a keeper.
TEST(Pulley, KeepsACordThatBendsAway) {
  const PulleyDef wheel{.center = {}, .radius = 0.2, .counterclockwise = false};
  const ReevedCord reeved = reeve({-1.0, -0.5}, {&wheel, 1}, {1.0, -0.5}, 41);
  CordDef def;
  def.points = 41;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.stretch_stiffness = 1e4;
  def.pins = {0, 40};
  Machine machine((Atwood()));
  machine.wall.position = {};
  machine.cord = Cord(def);
  add_pulley(machine.cord, reeved.pulleys[0]);
  const auto move_ends = [&](double y) {
    const double from = machine.cord.positions()[0].y;
    for (int k = 1; k <= 120; ++k) {
      const double now = from + (y - from) * k / 120.0;
      machine.cord.constrain(0, {-1.0, now});
      machine.cord.constrain(40, {1.0, now});
      machine.step();
    }
    machine.step(60);
  };
  move_ends(1.0);
  EXPECT_TRUE(machine.pulley().kept);
  EXPECT_EQ(machine.pulley().arc, 0.0);
  EXPECT_LT(length(machine.pulley().arrival - Vec2{0.0, 1.0}), 0.05) << "at the top of the wheel";
  const double side = length(Vec2{1.0, 0.8});
  EXPECT_NEAR(machine.pulley().tension_before / (1e4 * (2.0 * side / def.length - 1.0)), 1.0, 0.02);
  move_ends(-0.5);
  EXPECT_FALSE(machine.pulley().kept);
  EXPECT_GT(machine.pulley().arc, 0.5);
  EXPECT_EQ(machine.unconverged, 0);
}

/// Slipping, the tensions have the ratio e^(μ·π), and the masses the acceleration (m₂ − κ·m₁)·g/(m₂ + κ·m₁).
TEST(Pulley, SlipsAsTheCapstanEquationSays) {
  for (const int turns : {0, 1, 2}) {
    for (const bool heavy_right : {true, false}) {
      Atwood atwood;
      atwood.wheel.friction = 0.3;
      atwood.wheel.turns = turns;
      atwood.wheel.motor_torque = unlimited;  // it holds still
      atwood.points = 121;
      const double ratio = std::exp(0.3 * std::numbers::pi * (1 + 2 * turns));
      atwood.left = heavy_right ? 1.0 : 2.0 * ratio;
      atwood.right = heavy_right ? 2.0 * ratio : 1.0;
      Machine machine(atwood);
      machine.step(50);
      const double a = (heavy_right ? 1.0 : -1.0) * g / 3.0;
      EXPECT_NEAR(-machine.cord.velocities().back().y / (a * 50.0 * dt), 1.0, 2e-3) << turns;
      const Pulley& pulley = machine.pulley();
      EXPECT_NEAR(pulley.tension_after / pulley.tension_before / (heavy_right ? ratio : 1.0 / ratio), 1.0, 1e-3);
      EXPECT_EQ(pulley.turning, 0.0);
      EXPECT_EQ(machine.unconverged, 0);
    }
  }
}

TEST(Pulley, HoldsWhatTheFrictionCanHold) {
  Atwood atwood;
  atwood.wheel.friction = 0.3;
  atwood.wheel.motor_torque = unlimited;
  atwood.right = 10.0 * std::exp(0.3 * std::numbers::pi) * 0.98;
  Machine machine(atwood);
  machine.step(120);
  EXPECT_LT(std::abs(machine.fall()), 1e-6);
  EXPECT_EQ(machine.pulley().slip_sign, 0.0);
}

/// A drum that turns lifts a load by a tail that is held with little force.
TEST(Pulley, LiftsALoadWithADrum) {
  Atwood atwood;
  atwood.left = 1.0;
  atwood.right = 100.0;
  atwood.depth = 6.0;
  atwood.wheel.friction = 0.3;
  atwood.wheel.turns = 2;
  atwood.wheel.motor_torque = unlimited;
  Machine machine(atwood);
  set_motor(machine.cord, 0, 2.0, unlimited);
  machine.step(240);
  EXPECT_NEAR(machine.fall(), -0.2 * 2.0 * (4.0 - 0.5), 0.4);
  EXPECT_NEAR(-machine.cord.velocities().back().y, -0.4, 1e-3);
  EXPECT_NEAR(machine.pulley().tension_after / (100.0 * g), 1.0, 2e-3);
}

/// A motor of limited torque τ accelerates the machine by τ/(R·M), and then holds its speed.
TEST(Pulley, TurnsWithTheTorqueOfItsMotor) {
  Atwood atwood;
  atwood.right = 10.0;
  Machine machine(atwood);
  set_motor(machine.cord, 0, -5.0, 3.0);
  machine.step(60);
  const double mass = 20.0 + 0.5 / 0.04;
  EXPECT_NEAR(machine.pulley().speed / (3.0 / 0.2 / mass), 1.0, 2e-3);
  machine.step(120);
  EXPECT_NEAR(machine.pulley().turning, -5.0, 1e-9);
}

TEST(Pulley, IsHeldByABrakeUpToItsTorque) {
  Machine held((Atwood()));
  set_motor(held.cord, 0, 0.0, 1.02 * 2.0 * g * 0.2);
  held.step(60);
  EXPECT_LT(std::abs(held.fall()), 1e-6);
  Machine overhauled((Atwood()));
  set_motor(overhauled.cord, 0, 0.0, 0.5 * 2.0 * g * 0.2);
  overhauled.step(60);
  EXPECT_NEAR(overhauled.pulley().speed / (0.5 * acceleration(overhauled.atwood)), 1.0, 2e-3);
}

/// Mass ratios and steps far from any scene that was tuned.
TEST(Pulley, IsStableAtTheExtremes) {
  for (const double ratio : {1.0, 1e3}) {
    for (const double mass_per_length : {1e-6, 1e-3, 1.0}) {
      for (const double stiffness : {1e3, 1e6, unlimited}) {
        Atwood atwood;
        atwood.left = 1.0;
        atwood.right = ratio;
        atwood.mass_per_length = mass_per_length;
        CordDef def = atwood.cord().def();
        def.stretch_stiffness = stiffness;
        const ReevedCord reeved = reeve({-0.2, 1.5}, {&atwood.wheel, 1}, {0.2, 1.5}, atwood.points);
        Machine machine(atwood);
        machine.cord = Cord(def);
        machine.cord.attach_mass(0, 1.0);
        machine.cord.attach_mass(atwood.points - 1, ratio);
        add_pulley(machine.cord, reeved.pulleys[0]);
        machine.step(240);
        for (const Vec2 x : machine.cord.positions()) {
          ASSERT_TRUE(is_finite(x));
          ASSERT_LT(length(x - atwood.wheel.center), 1.3 * (8.0 + ratio * g * 8.0 / stiffness))
              << ratio << ' ' << mass_per_length << ' ' << stiffness;
        }
        EXPECT_LE(machine.unconverged, 6) << ratio << ' ' << mass_per_length << ' ' << stiffness;
      }
    }
  }
}

TEST(Pulley, SavesAndRestoresWithTheSameBits) {
  Machine machine(Atwood{});
  machine.step(50);
  const Cord::State state = machine.cord.save();
  machine.step(40);
  const Cord::State after = machine.cord.save();
  machine.cord.restore(state);
  machine.step(40);
  EXPECT_EQ(machine.cord.save(), after);
  Cord fresh(machine.cord.def());
  fresh.restore(state);
  machine.cord = std::move(fresh);
  machine.step(40);
  EXPECT_EQ(machine.cord.save(), after);
}

TEST(Pulley, AllocatesNothingInASteadyStep) {
  Atwood atwood;
  atwood.wheel.friction = 0.3;
  atwood.wheel.motor_torque = unlimited;
  atwood.right = 60.0;
  Machine machine(atwood);
  machine.step(10);
  const test_support::AllocationCount allocations;
  machine.step(30);
  EXPECT_EQ(allocations.so_far(), 0);
}

TEST(Pulley, TouchesNothingOnTheWheel) {
  Atwood atwood;
  CordDef def = atwood.cord().def();
  def.self_contact = true;
  atwood.wheel.turns = 3;
  atwood.points = 121;
  const ReevedCord reeved = reeve({-0.2, 1.5}, {&atwood.wheel, 1}, {0.2, 1.5}, atwood.points);
  def.points = atwood.points;
  def.length = reeved.length;
  def.positions = reeved.positions;
  Machine machine(atwood);
  machine.cord = Cord(def);
  machine.cord.attach_mass(0, 10.0);
  machine.cord.attach_mass(120, 12.0);
  add_pulley(machine.cord, reeved.pulleys[0]);
  const RigidCircle rim{0, {}, 0.19, 0.5, 0.0, 1};
  const Axle axle{0, {}};
  Surroundings surroundings;
  surroundings.bodies = {&machine.wall, 1};
  surroundings.axles = {&axle, 1};
  surroundings.circles = {&rim, 1};
  for (int k = 0; k < 60; ++k) {
    (void)machine.cord.step(dt, gravity, surroundings);
    EXPECT_TRUE(machine.cord.touches().empty()) << k;
  }
  EXPECT_NEAR(-machine.cord.velocities().back().y / acceleration(atwood), 1.0, 1e-2);
}

TEST(Pulley, GoesToThePieceThatHasIt) {
  Machine machine(Atwood{});
  machine.step(10);
  const Cord& cord = machine.cord;
  const int after = pulleys_of(cord)[0].def.after;
  CutPieces pieces = cut(cord, cut_through(cord, 50));
  ASSERT_TRUE(pieces.first && pieces.second);
  ASSERT_EQ(pulleys_of(*pieces.first).size(), 1U);
  EXPECT_EQ(pulleys_of(*pieces.first)[0].def.after, after);
  EXPECT_TRUE(pulleys_of(*pieces.second).empty());
  pieces = cut(cord, cut_through(cord, 5));
  ASSERT_EQ(pulleys_of(*pieces.second).size(), 1U);
  EXPECT_EQ(pulleys_of(*pieces.second)[0].def.after, after - 6);
  pieces = cut(cord, cut_through(cord, 30));  // on the wheel
  EXPECT_TRUE(pulleys_of(*pieces.first).empty());
  EXPECT_TRUE(pulleys_of(*pieces.second).empty());
}

TEST(Pulley, FallsWhenTheCordIsTakenOff) {
  Machine machine(Atwood{});
  machine.step(10);
  remove_pulley(machine.cord, 0);
  machine.step(60);
  EXPECT_LT(machine.cord.positions()[30].y, 3.0);
}

TEST(Pulley, RefusesWhatIsOutOfRange) {
  Cord cord(hanging(21, 4.0));
  EXPECT_EQ(refusal<std::exception>([&] {
              add_pulley(cord, {.center = {0.1, -2.0}, .before = 9, .after = 25});
            }),
            "after is 25; accepted is 10 to 20");
  EXPECT_EQ(refusal<std::exception>([&] { add_pulley(cord, {.center = {}, .radius = -1.0}); }),
            "radius is -1; accepted is 1e-06 to 1e+06");
  EXPECT_EQ(refusal<std::exception>([&] { add_pulley(cord, {.center = {}, .friction = 11.0}); }),
            "friction of a groove is 11; accepted is 0 to 10");
  EXPECT_EQ(refusal<std::exception>([&] { add_pulley(cord, {.center = {}, .motor_torque = -1.0}); }),
            "motor_torque is -1; accepted is 0 up to infinity");
  EXPECT_EQ(refusal<std::exception>([&] { remove_pulley(cord, 0); }), "pulley is 0; the cord has none");
  const std::string misfit = refusal<std::exception>([&] {
    add_pulley(cord, {.center = {3.0, -2.0}, .radius = 0.1, .before = 9, .after = 12});
  });
  EXPECT_NE(misfit.find("does not fit a path of"), std::string::npos) << misfit;
  EXPECT_TRUE(pulleys_of(cord).empty());
  Machine machine(Atwood{});
  EXPECT_NE(
      refusal<std::exception>([&] { add_pulley(machine.cord, machine.pulley().def); }).find("are on another wheel"),
      std::string::npos);
  EXPECT_EQ(refusal<std::exception>([&] { machine.cord.step(dt, gravity); }),
            "axles are 0; accepted is one for each of the 1 pulleys of the cord");
  EXPECT_EQ(refusal<std::exception>([&] { set_motor(machine.cord, 0, 1e7, 1.0); }),
            "motor_speed is 1e+07; accepted is -1e+06 to 1e+06");
}

TEST(Pulley, IsNotForRibbonsAndStiffRopes) {
  CordDef def = hanging(21, 4.0);
  def.bending_stiffness = 0.1;
  Cord stiff(def);
  EXPECT_EQ(refusal<std::exception>([&] {
              add_pulley(stiff, {.center = {0.1, -2.0}, .before = 9, .after = 12});
            }),
            "a ribbon or a stiff cord has no pulley; accepted is a rope without bending stiffness");
}

}  // namespace
}  // namespace ribbon
