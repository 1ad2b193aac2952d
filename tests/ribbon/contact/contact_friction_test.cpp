#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/cord.h"
#include "tests/support/constants.h"
#include "tests/support/contact_world.h"

// Friction of a cord of the direct solver, and the energy of impacts.

namespace ribbon {
namespace {

using constants::infinity;
using std::numbers::pi;
using test_support::bridge_def;
using test_support::bridge_mass;
using test_support::ContactWorld;

/// Returns the ratio of the pulls at both ends at which a weightless cord slips on a circle by 3 cm. (It creeps a
/// little before.) The cord touches the circle along `angle`, with links of a 32nd of a turn. One pull is constant, the
/// other grows.
double capstan_ratio(double angle, double friction_of_cord, double friction_of_circle) {
  constexpr int links_a_turn = 32;
  constexpr double turn = 2.0 * pi / links_a_turn;
  CordDef def;
  def.radius = 0.01;
  constexpr double radius = 0.5;
  const double l = 2.0 * (radius + def.radius) * std::tan(0.5 * turn);  // links that touch it in their middles
  const int turned = static_cast<int>(std::lround(angle / turn));
  constexpr int straight = 6;
  def.points = turned + 2 * straight + 1;
  def.length = l * (def.points - 1);
  def.friction = friction_of_cord;
  // From the left along +x, then clockwise around the circle below.
  Vec2 x{-(straight - 0.5) * l, radius + def.radius};
  double heading = 0.0;
  for (int i = 0; i < def.points; ++i) {
    def.positions.push_back(x);
    if (i >= straight && i < straight + turned) heading -= turn;
    x += l * Vec2{std::cos(heading), std::sin(heading)};
  }
  ContactWorld world(def);
  world.gravity = {};
  world.add_peg({0.0, 0.0}, radius, friction_of_circle);
  const Vec2 end{std::cos(heading), std::sin(heading)};
  constexpr double pull = 10.0;
  world.cord.set_load(0, {-pull, 0.0});
  const Vec2 start = world.cord.positions()[0];
  const double expected = std::exp(std::sqrt(friction_of_cord * friction_of_circle) * angle);
  for (double ratio = 1.0;; ratio += ratio < 0.9 * expected ? 4e-3 : 1e-3) {
    world.cord.set_load(def.points - 1, ratio * pull * end);
    world.step();
    if (length(world.cord.positions()[0] - start) > 0.03 || ratio > 20.0) return ratio;
  }
}

TEST(CordContact, SlipsAroundACircleByEulersCapstanEquation) {
  for (const double angle : {pi, 2.0 * pi}) {
    const double expected = std::exp(0.3 * angle);
    const double r = capstan_ratio(angle, 0.3, 0.3);
    EXPECT_NEAR(r / expected, 1.0, 0.03) << angle;
  }
  // The friction of the two surfaces is mixed as in Box2D.
  const double r = capstan_ratio(pi, 0.1, 0.9);
  EXPECT_NEAR(r / std::exp(0.3 * pi), 1.0, 0.03);
  EXPECT_LT(capstan_ratio(pi, 0.0, 0.9), 1.05);
}

/// A straight cord on an incline of 1 in 2.
struct Incline {
  explicit Incline(double friction, const Accuracy& accuracy = {}) : world(def(friction, accuracy)) {
    const int ground = world.add_body(-0.03 * perp(down), 0.0, 0.0);
    world.add_edge(ground, -5.0 * down, 30.0 * down, 0.01, friction);
  }
  static CordDef def(double friction, const Accuracy& accuracy) {
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.02;
    def.friction = friction;
    def.accuracy = accuracy;
    for (int i = 0; i < 21; ++i) def.positions.push_back(0.1 * i * down);
    return def;
  }
  double way() const { return dot(world.cord.positions()[10], down); }
  double speed() const { return dot(world.cord.velocities()[10], down); }

  static constexpr Vec2 down{0.89442719099991586, -0.44721359549995793};
  ContactWorld world;
};

TEST(CordContact, SlidesOnAnInclineByCoulombsLaw) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    for (const double friction : {0.0, 0.2, 0.4}) {
      Incline incline(friction, accuracy);
      const double acceleration = 9.81 * (-Incline::down.y - friction * Incline::down.x);
      for (int k = 0; k < 60; ++k) incline.world.step();
      const double before = incline.speed();
      const double landing = 9.81 * friction * Incline::down.x * incline.world.dt;  // friction begins a step later
      EXPECT_NEAR(before, acceleration, 0.02 * acceleration + landing) << friction;
      for (int k = 0; k < 60; ++k) incline.world.step();
      EXPECT_NEAR((incline.speed() - before) / acceleration, 1.0, 1e-3) << friction << " " << accuracy.substeps;
      EXPECT_LE(incline.world.depth(), 1e-3);
    }
  }
}

TEST(CordContact, SticksToAnInclineWithoutCreep) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    for (const double friction : {0.505, 0.55, 0.8, 2.0}) {
      Incline incline(friction, accuracy);
      for (int k = 0; k < 180; ++k) incline.world.step();  // it lands and slides a little
      const double before = incline.way();
      for (int k = 0; k < 120; ++k) {
        incline.world.step();
        EXPECT_LE(incline.world.fastest(), 1e-9) << friction;
      }
      EXPECT_NEAR(incline.way(), before, 1e-12) << friction;
    }
  }
}

/// A ball that falls 1.5 m on a slack or taut bridge gains no energy.
void expect_no_gain(bool taut, double stiffness, const Accuracy& accuracy, double mass, double deepest) {
  CordDef def = bridge_def();
  def.stretch_stiffness = stiffness;
  def.accuracy = accuracy;
  if (taut) {
    for (int i = 0; i < 41; ++i) def.positions[static_cast<std::size_t>(i)] = {0.105 * i, 0.0};
  }
  ContactWorld world(def);
  world.add_ball(def.positions[18] + Vec2{0.0, 1.5}, 0.25, mass, 0.5);
  const double scale = 9.81 * (mass + bridge_mass) * def.length;
  const double before = world.energy();
  double gain = 0.0;
  double depth = 0.0;
  for (int k = 0; k < 180; ++k) {
    world.step();
    gain = std::max(gain, world.energy() - before);
    depth = std::max(depth, world.depth());
  }
  EXPECT_LE(gain, 1e-3 * scale) << taut << " " << stiffness << " " << accuracy.substeps << " " << mass;
  EXPECT_LE(depth, deepest) << taut << " " << stiffness << " " << accuracy.substeps << " " << mass;
}

/// (Excluded is the heaviest ball on a taut inextensible cord: it gains energy.) With bounded work an impact may be
/// solved with linearised contacts, which keep their normals in the piece of the step that takes it. A ball that weighs
/// twice the cord or more may then penetrate, and is depenetrated: in 270 such falls from 1.2 to 1.8 m by 0.02 to 0.8
/// mm in the median, by 2.4 mm in one of ten of the heaviest, and by 5.4 mm at most.
TEST(CordContact, NoImpactOfAFallingBallGainsEnergy) {
  for (const bool ample : {false, true}) {
    for (Accuracy accuracy : {Accuracy::balanced(), Accuracy::accurate()}) {
      if (ample) accuracy.max_work = 1'000'000;
      for (const double mass : {0.01, 1.0, 100.0}) {
        const double deepest = ample || mass < 1.0 ? 1e-3 : 6e-3;
        for (const double stiffness : {1e4, 1e6, 1e8}) {
          for (const bool taut : {true, false}) expect_no_gain(taut, stiffness, accuracy, mass, deepest);
        }
        expect_no_gain(false, infinity, accuracy, mass, deepest);
        if (mass <= 1.0) expect_no_gain(true, infinity, accuracy, mass, deepest);
      }
    }
  }
}

}  // namespace
}  // namespace ribbon
