#include "ribbon/system/held_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ribbon/cord.h"
#include "ribbon/geometry/rotation.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/heavy_swing.h"

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

TEST(Rotation, IsSineAndCosine) {
  for (double angle = -12.0; angle <= 12.0; angle += 0.37) {
    EXPECT_NEAR(rotation(angle).x, std::cos(angle), 5e-14) << angle;
    EXPECT_NEAR(rotation(angle).y, std::sin(angle), 5e-14) << angle;
  }
  EXPECT_EQ(rotation(0.0), (Vec2{1.0, 0.0}));
}

/// Angles may exceed a turn; below two turns the bits do not change.
TEST(Rotation, IsSineAndCosineOfAnyAngle) {
  for (double angle = 12.57; angle < 1e18; angle *= 1.37) {
    for (const double a : {angle, -angle}) {
      EXPECT_NEAR(rotation(a).x, std::cos(a), 1e-12) << a;
      EXPECT_NEAR(rotation(a).y, std::sin(a), 1e-12) << a;
    }
  }
  for (double angle = 1e18; angle < std::numeric_limits<double>::max() / 1e3; angle *= 1e3) {
    EXPECT_NEAR(length(rotation(angle)), 1.0, 1e-15) << angle;
    EXPECT_EQ(rotation(-angle), (Vec2{rotation(angle).x, -rotation(angle).y})) << angle;
  }
  EXPECT_NEAR(length(rotation(std::numeric_limits<double>::max())), 1.0, 1e-15);
  EXPECT_EQ(rotation(1.0), (Vec2{0x1.14a280fb5068cp-1, 0x1.aed548f090cefp-1}));
  EXPECT_EQ(rotation(-11.3), (Vec2{0x1.32f0717a032d4p-2, 0x1.e875360c2af6cp-1}));
  EXPECT_EQ(rotation(12.5), (Vec2{0x1.fedf6a8227783p-1, -0x1.0fa78cc21c948p-4}));
}

RigidBody body_at(Vec2 position, double mass, double inertia) {
  RigidBody body;
  body.position = position;
  body.inverse_mass = 1.0 / mass;
  body.inverse_inertia = inertia > 0.0 ? 1.0 / inertia : 0.0;
  body.acceleration = gravity;
  return body;
}

/// A cord and the bodies that hold it. They move as the results of the cord's step say.
struct Held {
  Cord cord;
  std::vector<RigidBody> bodies;
  std::vector<Grip> grips;
  std::vector<RigidCircle> circles = {};

  IslandReport step() {
    const IslandReport report = cord.step(dt, gravity_on_cord, {bodies, circles, grips});
    for (RigidBody& body : bodies) {
      if (body.inverse_mass == 0.0) continue;
      body.position += body.moved;
      body.velocity += dt * body.acceleration + body.inverse_mass * body.impulse;
      body.angular_velocity += body.inverse_inertia * body.angular_impulse;
      const Vec2 turned = rotation(body.turned);
      for (Grip& grip : grips) {
        if (&bodies[static_cast<std::size_t>(grip.body)] != &body) continue;
        const Vec2 hand = grip.offset + grip.travel;
        grip.offset = {hand.x * turned.x - hand.y * turned.y, hand.x * turned.y + hand.y * turned.x};
      }
      body.impulse = {};
      body.angular_impulse = 0.0;
    }
    return report;
  }
  Vec2 gravity_on_cord = gravity;
};

Cord heavy_swing_without_load(double stiffness, const Accuracy& accuracy) {
  Cord cord = test_support::heavy_swing(stiffness, accuracy);
  cord.attach_mass(50, 0.0);
  return cord;
}

/// Returns where a rope with bending stiffness is that swings into a peg, with a body at its end, tick by tick.
std::vector<Vec2> swing_into_a_peg(double strength) {
  CordDef def;
  def.points = 16;
  def.length = 1.5;
  def.bending_stiffness = 0.02;
  def.stretch_stiffness = 1e4;
  def.drag = 0.5;
  def.pins = {0};
  def.accuracy.tolerance = 1e-10;
  RigidBody peg;
  peg.position = {0.3, -0.5};
  Held held{Cord(def), {body_at({1.5, 0.0}, 0.5, 0.01), peg}, {{15, 0, {}}}, {{1, {}, 0.1, 0.0, 0.0, 1}}};
  held.grips[0].strength = strength;
  std::vector<Vec2> path;
  for (int k = 0; k < 60; ++k) {
    EXPECT_EQ(held.step().unconverged, 0) << k;
    path.insert(path.end(), held.cord.positions().begin(), held.cord.positions().end());
  }
  EXPECT_FALSE(held.cord.touches().empty());
  return path;
}

/// A grip without a limit is condensed into the cord's own matrix until something touches; one with a limit is an
/// unknown of the coupled system from the start. Both are the same body.
TEST(CordHeldBody, MovesTheSameWhetherItIsCondensedOrCoupled) {
  const std::vector<Vec2> condensed = swing_into_a_peg(std::numeric_limits<double>::infinity());
  const std::vector<Vec2> coupled = swing_into_a_peg(1e9);
  double most = 0.0;
  for (std::size_t p = 0; p < condensed.size(); ++p) most = std::max(most, length(condensed[p] - coupled[p]));
  EXPECT_LT(most, 1e-6);
}

/// A rope of two links, both 1 m long, whose points are pinned.
CordDef corner(Vec2 end) {
  CordDef def;
  def.points = 3;
  def.length = 2.0;
  def.positions = {{0.0, 0.0}, {1.0, 0.0}, end};
  def.pins = {0, 1, 2};
  def.accuracy.integrator = Integrator::implicit_euler;
  return def;
}

/// A hand of 1 kg, 0.1 m before the corner, which goes on by 0.2 m in each substep.
Held sliding_into(const CordDef& def, double strength, Grip grip = {0, 0, {}}) {
  grip.along = 0.9;
  grip.strength = strength;
  Held held{Cord(def), {body_at({0.9, 0.0}, 1.0, 0.0)}, {grip}, {}};
  held.bodies[0].velocity = {0.2 / dt * def.accuracy.substeps, 0.0};
  held.bodies[0].acceleration = {};
  return held;
}

/// A hand whose anchor is beside the cord slides past a corner. From the second substep on it is held at the place that
/// is nearest to that anchor, on the other link. In a ribbon it stays in its row. The corner turns it by a right angle,
/// held across the direction between the links, so both components of its velocity are half of what it was.
TEST(CordHeldBody, FollowsTheCordToThePlaceThatIsNearestToItsAnchor) {
  CordDef rope = corner({1.0, 1.0});
  rope.accuracy.substeps = 2;
  CordDef ribbon = rope;
  ribbon.rows = 2;
  ribbon.width = 0.5;
  ribbon.stretch_stiffness = 1e3;
  ribbon.positions = {{0.0, -0.5}, {0.0, 0.0}, {1.5, -0.5}, {1.0, 0.0}, {1.5, 1.0}, {1.0, 1.0}};
  ribbon.pins = {0, 1, 2, 3, 4, 5};
  for (const CordDef& def : {rope, ribbon}) {
    const int row = def.rows - 1;
    Held held = sliding_into(def, 1e-6, {row, 0, {}});
    held.grips[0].beside = {0.0, 0.3};
    held.step();
    ASSERT_EQ(held.cord.holders().size(), 1U) << def.rows;
    EXPECT_EQ(held.cord.holders()[0].point, def.rows + row);
    const double on_second_link = 0.1 + 0.3 + 0.1;  // in the first substep, to the nearest place, in the second substep
    EXPECT_NEAR(held.cord.holders()[0].slid, 0.1 + on_second_link, 1e-6) << def.rows;
  }
}

/// Friction takes 0.05 m from its way. A corner turns it by half, so it gets less far than to the place at which it is
/// held. Newton's method and linearised contacts, which hold it along the cord by a limited force, agree.
TEST(CordHeldBody, SlidesPastACornerAgainstItsStrength) {
  for (const int newton_pause : {0, 3}) {
    Held held = sliding_into(corner({1.0, 1.0}), 0.05 / (dt * dt));
    Cord::State state = held.cord.save();
    state.newton_pause = newton_pause;
    held.cord.restore(state);
    held.step();
    ASSERT_EQ(held.cord.holders().size(), 1U);
    const double along = std::sqrt(0.5) * 0.2 - 0.05;     // m, in the direction between the links
    const double across = std::sqrt(0.5) * (0.1 - 0.05);  // to the place ahead
    EXPECT_NEAR(length(held.bodies[0].moved), std::hypot(along, across), 1e-6) << newton_pause;
    const double ahead = std::sqrt(0.5) * 0.15;
    EXPECT_NEAR(held.cord.holders()[0].slid, 0.15 + along - ahead, 1e-6) << newton_pause;
  }
}

/// What its strength stops before a corner is stopped, and not thrown back.
TEST(CordHeldBody, StopsBeforeACorner) {
  Held held = sliding_into(corner({1.0, 1.0}), 1.0 / (dt * dt));
  held.step();
  EXPECT_LE(length(held.bodies[0].moved), 1e-6);
}

/// Where the next link leads back, it goes no further: not along the line of the link that it is on, either.
TEST(CordHeldBody, SlidesNoFurtherThanASharpBend) {
  for (const bool forward : {true, false}) {
    CordDef def = corner({0.5, 0.5 * std::sqrt(3.0)});
    if (!forward) std::reverse(def.positions.begin(), def.positions.end());
    Held held = sliding_into(def, 1e-6, {forward ? 0 : 1, 0, {}});
    if (!forward) held.grips[0].along = 0.1;
    held.step();
    ASSERT_EQ(held.cord.holders().size(), 1U) << forward;
    EXPECT_EQ(held.cord.holders()[0].point, 1) << forward;
    EXPECT_NEAR(held.cord.holders()[0].slid, forward ? 0.1 : -0.1, 1e-9) << forward;
    EXPECT_NEAR(held.bodies[0].moved.x, 0.1, 1e-9) << forward;
  }
}

/// After the last column no other column follows, so a place between them does not exist.
TEST(CordHeldBody, BeyondTheLastPointIsRefused) {
  CordDef def;
  def.points = 5;
  def.rows = 2;
  def.width = 0.1;
  def.elements = Elements::bars;
  def.stretch_stiffness = 1e6;
  Cord cord(def);
  std::array<RigidBody, 1> bodies{};
  for (const double inverse_mass : {0.0, 1.0}) {
    bodies[0].inverse_mass = inverse_mass;
    for (const int point : {8, 9}) {
      const std::array<Grip, 1> grips{{{point, 0, {}, {}, 0.5}}};
      EXPECT_THROW(cord.step(dt, gravity, {bodies, {}, grips}), DefinitionError) << point;
    }
    const std::array<Grip, 1> grips{{{7, 0, {}, {}, 0.5}}};
    EXPECT_NO_THROW(cord.step(dt, gravity, {bodies, {}, grips}));
  }
}

/// A body that is held at its centre of mass acts as a point mass.
TEST(CordHeldBody, SwingsAsAnAttachedMassWhenHeldAtItsCentre) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double inertia : {0.0, 3.0}) {
    Held held{heavy_swing_without_load(infinity, Accuracy::balanced()),
              {body_at({10.0, 0.0}, 70.0, inertia)},
              {{50, 0, {}, {}}}};
    Cord attached = test_support::heavy_swing(infinity, Accuracy::balanced());
    for (int k = 0; k < 200; ++k) {
      held.step();
      attached.step(dt, gravity);
      ASSERT_NEAR(length(held.bodies[0].position - attached.positions()[50]), 0.0, 1e-6) << k;
      ASSERT_NEAR(length(held.bodies[0].position - held.cord.positions()[50]), 0.0, 1e-9) << k;
    }
    EXPECT_EQ(held.bodies[0].angular_velocity, 0.0);
  }
}

/// A compound pendulum: a massless link, and a body of radius of gyration i held at a distance a from its centre. Small
/// swings about the straight position of the two angles: (l + … ) by the exact frequencies of the double pendulum.
TEST(CordHeldBody, HeldOffItsCentreItSwingsAtTheFrequencyOfADoublePendulum) {
  constexpr double l = 1.0;
  constexpr double a = 0.5;
  constexpr double mass = 10.0;
  constexpr double inertia = 0.4;
  CordDef def;
  def.points = 2;
  def.length = l;
  def.mass_per_length = 1e-9;
  def.pins = {0};
  def.accuracy = {Integrator::tr_bdf2, 8, 12, 1e-12};
  // M·q̈ = −K·q for q = (angle of the link, angle of the body), M = m·[l² l·a; l·a a² + I/m], K = m·g·diag(l, a).
  const double g = 9.81;
  const double i2 = a * a + inertia / mass;
  const double p = l * i2 * l - l * a * l * a;  // det M / m²
  const double q = g * (l * l * a + l * i2);
  const double r = g * g * l * a;
  const double omega2 = (q - std::sqrt(q * q - 4.0 * p * r)) / (2.0 * p);
  const double ratio = (g * l - omega2 * l * l) / (omega2 * l * a);  // of the body's angle to the link's
  constexpr double small = 1e-3;
  const Vec2 end{l * small, -l};
  def.positions = {{0.0, 0.0}, end};
  Held held{
      Cord(def), {body_at(end + Vec2{a * ratio * small, -a}, mass, inertia)}, {{1, 0, {-a * ratio * small, a}, {}}}};
  double before = held.bodies[0].position.x;
  std::vector<double> zeros;
  for (int k = 1; k <= 1200; ++k) {
    held.step();
    const double now = held.bodies[0].position.x;
    if (before * now < 0.0) zeros.push_back(dt * (k - now / (now - before)));
    before = now;
  }
  ASSERT_GE(zeros.size(), 8U);
  const double found = 3.14159265358979 * static_cast<double>(zeros.size() - 1) / (zeros.back() - zeros.front());
  EXPECT_NEAR(found / std::sqrt(omega2), 1.0, 1e-3);
}

TEST(CordHeldBody, AtRestPullsWithItsWeight) {
  CordDef def;
  def.points = 21;
  def.length = 4.0;
  def.pins = {0};
  for (int p = 0; p <= 20; ++p) def.positions.push_back({0.0, -0.2 * p});
  for (const double mass : {0.01, 1.0, 168.0, 1e6}) {
    Held held{Cord(def), {body_at({0.0, -4.3}, mass, 0.1 * mass)}, {{20, 0, {0.0, 0.3}, {}}}};
    for (int k = 0; k < 600; ++k) held.step();
    const double own = held.cord.mass(20) * 9.81;
    EXPECT_NEAR(held.cord.tensions()[19], mass * 9.81 + own, 1e-3 * mass * 9.81);
    const Vec2 rest = held.bodies[0].position;
    held.step();
    EXPECT_LE(length(held.bodies[0].position - rest), 1e-6 * 4.0);
  }
}

TEST(CordHeldBody, AFreeCordAndItsHoldersConserveMomentum) {
  CordDef def;
  def.points = 21;
  def.length = 4.0;
  Held held{Cord(def),
            {body_at({0.0, 0.3}, 2.0, 0.3), body_at({4.0, -0.2}, 0.5, 0.02)},
            {{0, 0, {0.0, -0.3}, {}}, {20, 1, {0.0, 0.2}, {}}}};
  held.gravity_on_cord = {};
  for (RigidBody& body : held.bodies) body.acceleration = {};
  held.bodies[0].velocity = {1.0, 2.0};
  held.bodies[0].angular_velocity = 3.0;
  held.bodies[1].velocity = {-2.0, 0.5};
  const auto momentum = [&] {
    std::array<double, 3> sum{};  // linear, and angular about the origin
    const auto add = [&sum](double mass, Vec2 x, Vec2 v) {
      sum[0] += mass * v.x;
      sum[1] += mass * v.y;
      sum[2] += mass * cross(x, v);
    };
    for (int p = 0; p < held.cord.size(); ++p) {
      const auto i = static_cast<std::size_t>(p);
      add(held.cord.mass(p), held.cord.positions()[i], held.cord.velocities()[i]);
    }
    for (const RigidBody& body : held.bodies) {
      add(1.0 / body.inverse_mass, body.position, body.velocity);
      if (body.inverse_inertia > 0.0) sum[2] += body.angular_velocity / body.inverse_inertia;
    }
    return sum;
  };
  const auto before = momentum();
  for (int k = 0; k < 600; ++k) held.step();
  const auto after = momentum();
  EXPECT_NEAR(after[0], before[0], 1e-9);
  EXPECT_NEAR(after[1], before[1], 1e-9);
  EXPECT_NEAR(after[2], before[2], 0.02 * std::abs(before[2]));
}

/// An anchor away from its point pulls the point closer by a quarter of a link per step; a kinematic body carries the
/// point.
TEST(CordHeldBody, ADistantHolderPullsThePointAndAKinematicOneCarriesIt) {
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.pins = {0};
  for (int p = 0; p <= 10; ++p) def.positions.push_back({0.0, -0.1 * p});
  Held held{Cord(def), {body_at({0.3, -1.0}, 50.0, 1.0)}, {{10, 0, {0.0, 0.1}, {}}}};
  double fastest = 0.0;
  for (int k = 0; k < 30; ++k) {
    held.step();
    fastest = std::max(fastest, length(held.bodies[0].velocity));
  }
  EXPECT_LT(fastest, 6.0);
  const Vec2 hand = held.bodies[0].position + held.grips[0].offset;
  EXPECT_NEAR(length(hand - held.cord.positions()[10]), 0.0, 1e-6);

  RigidBody elevator;
  elevator.position = {0.5, -0.5};
  elevator.velocity = {0.0, 0.5};
  Held carried{Cord(def), {elevator}, {{5, 0, {-0.5, 0.0}, {}}}};
  for (int k = 0; k < 30; ++k) {
    carried.step();
    carried.bodies[0].position += dt * carried.bodies[0].velocity;
    ASSERT_NEAR(length(carried.cord.positions()[5] - (carried.bodies[0].position + Vec2{-0.5, 0.0})), 0.0, 1e-9);
  }
  EXPECT_NEAR(carried.cord.velocities()[5].y, 0.5, 1e-9);
}

TEST(CordHeldBody, RestoredContinuesWithoutAllocation) {
  Held held{heavy_swing_without_load(1e6, Accuracy::balanced()),
            {body_at({10.0, -0.4}, 70.0, 3.0)},
            {{50, 0, {0.0, 0.4}, {}}}};
  for (int k = 0; k < 40; ++k) {
    const Cord::State state = held.cord.save();
    Held other{Cord(held.cord.def()), held.bodies, held.grips};
    other.cord.restore(state);
    other.step();
    const test_support::AllocationCount count;
    held.step();
    EXPECT_EQ(count.so_far(), 0);
    ASSERT_EQ(other.cord.save(), held.cord.save()) << k;
    ASSERT_EQ(other.bodies[0].position, held.bodies[0].position);
  }
}

}  // namespace
}  // namespace ribbon
