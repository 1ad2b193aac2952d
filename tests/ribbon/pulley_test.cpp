#include "ribbon/pulley.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

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

TEST(Tangent, TouchesTheWheelInTheDirectionOfTravel) {
  for (const double sense : {1.0, -1.0}) {
    const Vec2 r{0.3, -1.1};
    const TangentLine in = arriving_line(r, 0.4, sense);
    EXPECT_LT(length(r + in.length * in.along - 0.4 * in.normal), 1e-14);
    EXPECT_LT(length(in.along - sense * perp(in.normal)), 1e-14);
    const TangentLine out = leaving_line(r, 0.4, sense);
    EXPECT_LT(length(0.4 * out.normal + out.length * out.along - r), 1e-14);
    EXPECT_LT(length(out.along - sense * perp(out.normal)), 1e-14);
  }
}

TEST(Tangent, FindsAnglesAndPowers) {
  for (double angle = -3.14; angle < 3.14; angle += 0.01) {
    EXPECT_NEAR(angle_between(rotation(0.7), rotation(0.7 + angle)), angle, 1e-13);
  }
  EXPECT_DOUBLE_EQ(std::abs(angle_between({-1.0, 0.0}, {1.0, 0.0})), std::numbers::pi);
  for (double x = 0.0; x < 40.0; x += 0.37) EXPECT_NEAR(exponential(x) / std::exp(x), 1.0, 1e-12);
  EXPECT_EQ(exponential(600.0), exponential(40.0));
}

TEST(Reeving, LaysACordTautAroundWheels) {
  const ReevedCord tackle = test_support::reeve_tackle(181);
  // Five straight parts, of which two are 4 m between wheels of the same size, and four half turns.
  EXPECT_NEAR(tackle.length, 3.0 + 3.0 * 4.0 + 3.5 + 4.0 * 0.1 * std::numbers::pi, 1e-12);
  EXPECT_EQ(tackle.positions.front(), (Vec2{-0.1, 3.0}));
  EXPECT_EQ(tackle.positions.back(), (Vec2{0.7, 5.5}));
  const double link = tackle.length / 180.0;
  for (std::size_t p = 1; p < tackle.positions.size(); ++p) {
    const double size = length(tackle.positions[p] - tackle.positions[p - 1]);
    EXPECT_LE(size, link + 1e-12) << p;
    EXPECT_GE(size, 0.9 * link) << p;
  }
  ASSERT_EQ(tackle.pulleys.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_LT(tackle.pulleys[k].before, tackle.pulleys[k].after);
    if (k > 0) {
      EXPECT_GT(tackle.pulleys[k].before, tackle.pulleys[k - 1].after);
    }
  }
}

TEST(Reeving, WindsWholeTurns) {
  PulleyDef wheel{.center = {}, .radius = 0.5, .counterclockwise = false, .turns = 3};
  const ReevedCord wound = reeve({-0.5, -2.0}, {&wheel, 1}, {0.5, -2.0}, 101);
  EXPECT_NEAR(wound.length, 4.0 + 7.0 * 0.5 * std::numbers::pi, 1e-12);
}

TEST(Reeving, RefusesWhatCannotBeLaid) {
  const std::vector<PulleyDef> close{{.center = {0.0, 0.0}, .radius = 0.5},
                                     {.center = {0.1, 0.0}, .radius = 0.1, .counterclockwise = true}};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-2.0, 0.0}, close, {2.0, 0.0}, 50);
            }),
            "wheels of a cord overlap, or one holds an end; accepted are ones with a common tangent");
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({0.1, 0.0}, {close.data(), 1}, {2.0, 0.0}, 50);
            }),
            "wheels of a cord overlap, or one holds an end; accepted are ones with a common tangent");
  const std::vector<PulleyDef> near{{.center = {0.0, 0.0}, .radius = 0.1}, {.center = {1.0, 0.0}, .radius = 0.1}};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-9.0, 0.0}, near, {9.0, 0.0}, 8);
            }),
            "points are 8, too few for wheel 1; accepted are enough that two lie between neighbouring wheels");
  EXPECT_EQ(refusal<std::exception>([] { (void)reeve({}, {}, {1.0, 0.0}, 1); }), "points is 1; accepted is 2 to 1e+06");
  const PulleyDef flat{.center = {}, .radius = 0.0};
  EXPECT_EQ(refusal<std::exception>([&] {
              (void)reeve({-1.0, 0.0}, {&flat, 1}, {1.0, 0.0}, 9);
            }),
            "radius is 0; accepted is 1e-06 to 1e+06");
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
    return machine.cord.energy(gravity).total() + wheel;
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
  machine.cord.add_pulley(reeved.pulleys[0]);
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
  machine.cord.set_motor(0, 2.0, unlimited);
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
  machine.cord.set_motor(0, -5.0, 3.0);
  machine.step(60);
  const double mass = 20.0 + 0.5 / 0.04;
  EXPECT_NEAR(machine.pulley().speed / (3.0 / 0.2 / mass), 1.0, 2e-3);
  machine.step(120);
  EXPECT_NEAR(machine.pulley().turning, -5.0, 1e-9);
}

TEST(Pulley, IsHeldByABrakeUpToItsTorque) {
  Machine held((Atwood()));
  held.cord.set_motor(0, 0.0, 1.02 * 2.0 * g * 0.2);
  held.step(60);
  EXPECT_LT(std::abs(held.fall()), 1e-6);
  Machine overhauled((Atwood()));
  overhauled.cord.set_motor(0, 0.0, 0.5 * 2.0 * g * 0.2);
  overhauled.step(60);
  EXPECT_NEAR(overhauled.pulley().speed / (0.5 * acceleration(overhauled.atwood)), 1.0, 2e-3);
}

/// The tackle and what it carries.
struct Tackle {
  explicit Tackle(double hand_mass, double load = 40.0, const Accuracy& accuracy = {})
      : Tackle(make(accuracy), hand_mass, load) {}
  Tackle(const CordDef& def, double hand_mass, double load) : cord(def) {
    cord.attach_mass(0, hand_mass);
    const ReevedCord reeved = test_support::reeve_tackle(points);
    for (const PulleyDef& pulley : reeved.pulleys) cord.add_pulley(pulley);
    blocks[0].position = test_support::fixed_block;
    blocks[1].position = test_support::moving_block;
    blocks[1].inverse_mass = 1.0 / load;
    blocks[1].acceleration = gravity;
  }
  static CordDef make(const Accuracy& accuracy) {
    const ReevedCord reeved = test_support::reeve_tackle(points);
    CordDef def;
    def.points = points;
    def.length = reeved.length;
    def.positions = reeved.positions;
    def.mass_per_length = 1e-5;
    def.pins = {points - 1};
    def.accuracy = accuracy;
    return def;
  }
  /// Returns the kinetic energy of all, J.
  double kinetic() const {
    const RigidBody& block = blocks[1];
    return cord.energy(gravity).kinetic + 0.5 / block.inverse_mass * dot(block.velocity, block.velocity);
  }
  /// Returns the energy of all, J.
  double energy() const {
    return cord.energy(gravity).potential + kinetic() + g / blocks[1].inverse_mass * blocks[1].position.y;
  }
  void step(int times) {
    const std::vector<Axle> axles = test_support::axles_of_tackle();
    Surroundings surroundings;
    surroundings.bodies = blocks;
    surroundings.axles = axles;
    for (int k = 0; k < times; ++k) {
      RigidBody& block = blocks[1];
      block.impulse = {};
      block.angular_impulse = 0.0;
      unconverged += cord.step(dt, gravity, surroundings).unconverged;
      block.velocity += dt * block.acceleration + block.inverse_mass * block.impulse;
      block.position += block.moved;
    }
  }
  static constexpr int points = 181;
  Cord cord;
  std::vector<RigidBody> blocks{2};
  int unconverged = 0;
};

/// A block and tackle 4:1: a quarter of the load holds it, and the hand goes four times as far.
TEST(Pulley, DividesALoadInATackle) {
  Tackle balance(10.0);
  balance.step(120);
  EXPECT_NEAR(balance.blocks[1].position.y, test_support::moving_block.y, 1e-4);
  EXPECT_NEAR(balance.cord.pulleys()[0].tension_before / (10.0 * g), 1.0, 1e-3);
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    Tackle lifting(11.0, 40.0, accuracy);
    lifting.step(120);
    const double a = g * (44.0 - 40.0) / (16.0 * 11.0 + 40.0);  // of the load
    EXPECT_NEAR(lifting.blocks[1].velocity.y / (2.0 * a), 1.0, 1e-3);
    EXPECT_NEAR(-lifting.cord.velocities().front().y / (8.0 * a), 1.0, 1e-3);
    for (const Pulley& pulley : lifting.cord.pulleys()) {
      EXPECT_NEAR(pulley.tension_after / (11.0 * (g - 4.0 * a)), 1.0, 2e-3);
    }
    EXPECT_NEAR(lifting.blocks[1].position.x, test_support::moving_block.x, 1e-3);
    EXPECT_EQ(lifting.unconverged, 0);
  }
}

/// The cord on the wheels of the block rises and falls with it, and turns around it. Its gravity may be another one.
TEST(Pulley, KeepsTheEnergyOfATackleWithAHeavyCord) {
  for (const double scale : {1.0, 2.5}) {
    for (const double load : {10.0, 60.0}) {
      CordDef def = Tackle::make({});
      def.mass_per_length = 0.5;
      def.gravity_scale = scale;
      Tackle tackle(def, load < 20.0 ? 8.0 : 2.0, load);
      const double start = tackle.energy();
      tackle.step(20);
      EXPECT_EQ(tackle.blocks[1].velocity.y > 0.1, load < 20.0);
      EXPECT_NEAR((tackle.energy() - start) / tackle.kinetic(), 0.0, 0.005) << scale << ' ' << load;
    }
  }
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
        machine.cord.add_pulley(reeved.pulleys[0]);
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
  machine.cord.add_pulley(reeved.pulleys[0]);
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
  const int after = cord.pulleys()[0].def.after;
  CutPieces pieces = cut(cord, cut_through(cord, 50));
  ASSERT_TRUE(pieces.first && pieces.second);
  ASSERT_EQ(pieces.first->pulleys().size(), 1U);
  EXPECT_EQ(pieces.first->pulleys()[0].def.after, after);
  EXPECT_TRUE(pieces.second->pulleys().empty());
  pieces = cut(cord, cut_through(cord, 5));
  ASSERT_EQ(pieces.second->pulleys().size(), 1U);
  EXPECT_EQ(pieces.second->pulleys()[0].def.after, after - 6);
  pieces = cut(cord, cut_through(cord, 30));  // on the wheel
  EXPECT_TRUE(pieces.first->pulleys().empty());
  EXPECT_TRUE(pieces.second->pulleys().empty());
}

TEST(Pulley, FallsWhenTheCordIsTakenOff) {
  Machine machine(Atwood{});
  machine.step(10);
  machine.cord.remove_pulley(0);
  machine.step(60);
  EXPECT_LT(machine.cord.positions()[30].y, 3.0);
}

TEST(Pulley, RefusesWhatIsOutOfRange) {
  Cord cord(hanging(21, 4.0));
  EXPECT_EQ(refusal<std::exception>([&] {
              cord.add_pulley({.center = {0.1, -2.0}, .before = 9, .after = 25});
            }),
            "after is 25; accepted is 10 to 20");
  EXPECT_EQ(refusal<std::exception>([&] { cord.add_pulley({.center = {}, .radius = -1.0}); }),
            "radius is -1; accepted is 1e-06 to 1e+06");
  EXPECT_EQ(refusal<std::exception>([&] { cord.add_pulley({.center = {}, .friction = 11.0}); }),
            "friction of a groove is 11; accepted is 0 to 10");
  EXPECT_EQ(refusal<std::exception>([&] { cord.add_pulley({.center = {}, .motor_torque = -1.0}); }),
            "motor_torque is -1; accepted is 0 up to infinity");
  EXPECT_EQ(refusal<std::exception>([&] { cord.remove_pulley(0); }), "pulley is 0; the cord has none");
  const std::string misfit = refusal<std::exception>([&] {
    cord.add_pulley({.center = {3.0, -2.0}, .radius = 0.1, .before = 9, .after = 12});
  });
  EXPECT_NE(misfit.find("does not fit a path of"), std::string::npos) << misfit;
  EXPECT_TRUE(cord.pulleys().empty());
  Machine machine(Atwood{});
  EXPECT_NE(
      refusal<std::exception>([&] { machine.cord.add_pulley(machine.pulley().def); }).find("are on another wheel"),
      std::string::npos);
  EXPECT_EQ(refusal<std::exception>([&] { machine.cord.step(dt, gravity); }),
            "axles are 0; accepted is one for each of the 1 pulleys of the cord");
  EXPECT_EQ(refusal<std::exception>([&] { machine.cord.set_motor(0, 1e7, 1.0); }),
            "motor_speed is 1e+07; accepted is -1e+06 to 1e+06");
}

TEST(Pulley, IsNotForRibbonsAndStiffRopes) {
  CordDef def = hanging(21, 4.0);
  def.bending_stiffness = 0.1;
  Cord stiff(def);
  EXPECT_EQ(refusal<std::exception>([&] {
              stiff.add_pulley({.center = {0.1, -2.0}, .before = 9, .after = 12});
            }),
            "a ribbon or a stiff cord has no pulley; accepted is a rope without bending stiffness");
}

}  // namespace
}  // namespace ribbon
