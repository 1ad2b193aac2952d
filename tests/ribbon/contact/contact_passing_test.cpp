#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/cord.h"
#include "tests/support/contact_world.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"

// Nothing passes through a cord at any speed.

namespace ribbon {
namespace {

using std::numbers::pi;
using test_support::ContactWorld;
using test_support::Dice;
using test_support::segments_cross;

constexpr double tick = 1.0 / 60.0;
constexpr double half_a_thickness = 0.02;  // m, of all cords here
constexpr int ample_work = 1'000'000;      // Accuracy::max_work that allows to halve all steps that do not converge

bool crosses(std::span<const Vec2> cord, Vec2 a, Vec2 b) {
  for (std::size_t p = 1; p < cord.size(); ++p) {
    if (segments_cross(cord[p - 1], cord[p], a, b)) return true;
  }
  return false;
}

/// Returns whether a ray from p straight up crosses the cord an odd number of times: p is below the cord, or inside it
/// if it is closed. Folds do not change that.
bool is_below(std::span<const Vec2> cord, Vec2 p) {
  bool below = false;
  for (std::size_t k = 1; k < cord.size(); ++k) {
    const Vec2 a = cord[k - 1];
    const Vec2 b = cord[k];
    if ((a.x <= p.x) == (b.x <= p.x)) continue;
    if (a.y + (b.y - a.y) * (p.x - a.x) / (b.x - a.x) > p.y) below = !below;
  }
  return below;
}

enum class Hung { taut, ring, free_end };

struct Shot {
  Hung hung;
  double radii_a_tick;
  bool with_contact = true;
  int max_work = ample_work;
};

struct Outcome {
  bool hit = false;      ///< the ball's free path crosses the cord
  bool through = false;  ///< the ball passed through
  bool stopped = false;  ///< the ball lost its way at a cord with a free end, which did not give way
  bool finite = true;
  double depth = 0.0;  ///< m
  int systems = 0;     ///< maximum number of linear systems in a tick
};

CordDef cord_to_hit(const Shot& shot, Dice& dice) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.radius = 0.02;
  def.mass_per_length = 0.25;
  def.friction = dice.coin() ? 0.0 : 0.4;
  def.accuracy.max_work = shot.max_work;
  def.pins = {0};
  if (shot.hung != Hung::free_end) def.pins.push_back(40);
  constexpr double ring_radius = 0.635;
  for (int i = 0; i < 41; ++i) {
    const double turned = 2.0 * pi * (i % 40) / 40;
    def.positions.push_back(shot.hung == Hung::ring   ? ring_radius * Vec2{std::sin(turned), std::cos(turned)}
                            : shot.hung == Hung::taut ? Vec2{0.1 * i, 0.0}
                                                      : Vec2{0.0, -0.1 * i});
  }
  return def;
}

/// A ball passed through:
/// - a ring with both ends pinned at one place, if it started inside and is outside;
/// - a taut cord between two pins, if it is between them on the other side, or left straight through. (It may slide
///   along the cord and around a pin.)
/// - a cord with a free end, if it is on the other side and the cord did not move. (If it passes around the end, the
///   cord moves.)
Outcome fly(ContactWorld& world, int ball, double radius, Hung hung) {
  Outcome outcome;
  const bool below = is_below(world.cord.positions(), world.body(ball).position);
  bool between = true;
  for (int k = 0; k < 20; ++k) {
    const std::vector<Vec2> before(world.cord.positions().begin(), world.cord.positions().end());
    const Vec2 start = world.body(ball).position;
    const bool crossing = crosses(before, start, start + tick * world.body(ball).velocity);
    world.step();
    const std::span<const Vec2> after = world.cord.positions();
    const Vec2 end = world.body(ball).position;
    outcome.finite = outcome.finite && is_finite(end) && is_finite(after[20]);
    outcome.depth = std::max(outcome.depth, world.depth());
    outcome.systems = std::max(outcome.systems, world.report.iterations);
    if (hung == Hung::ring) {
      outcome.through = outcome.through || !is_below(after, end);
    } else if (hung == Hung::taut) {
      between = between && end.x > 0.0 && end.x < 4.0;
      outcome.through = outcome.through || crosses(before, start, end) || (between && is_below(after, end) != below);
    } else if (crossing && !outcome.hit) {
      double most = 0.0;
      for (std::size_t p = 0; p < before.size(); ++p) most = std::max(most, length(after[p] - before[p]));
      const bool unmoved = most < 0.3 * radius;
      outcome.through = unmoved && (crosses(before, start, end) || crosses(after, start, end));
      outcome.stopped = unmoved && !outcome.through;
    }
    outcome.hit = outcome.hit || crossing;
  }
  return outcome;
}

/// Shoots a ball of a hundredth to a hundred times the cord's mass at a cord of 4 m.
Outcome shoot(const Shot& shot, unsigned seed) {
  Dice dice(seed);
  const CordDef def = cord_to_hit(shot, dice);
  const double radius = dice(0.05, 0.3);
  const double mass = std::pow(10.0, dice(-2.0, 2.0));
  const Vec2 aim = def.positions[static_cast<std::size_t>(dice(4.0, 37.0))];
  const double angle = dice(-0.6, 0.6);
  const double side = dice.coin() ? 1.0 : -1.0;
  const double away = dice(1.2, 3.0) * radius + 0.05;
  Vec2 from{side * std::cos(angle), std::sin(angle)};
  if (shot.hung == Hung::taut) from = {std::sin(angle), side * std::cos(angle)};
  if (shot.hung == Hung::ring) from = (-1.0 / length(aim)) * aim;
  ContactWorld world(def);
  if (dice.coin()) world.gravity = {};
  const int ball = world.add_ball(shot.hung == Hung::ring ? Vec2{} : aim + away * from, radius, mass, 0.4);
  world.body(ball).velocity = (-shot.radii_a_tick * radius / tick) * from;
  if (!shot.with_contact) world.circles.clear();
  return fly(world, ball, radius, shot.hung);
}

struct Tally {
  int hits = 0;
  int through = 0;
  int stopped = 0;
  int lost = 0;
  double depth = 0.0;
  int systems = 0;
  std::vector<unsigned> seeds{};

  void add(const Outcome& outcome, unsigned seed) {
    hits += outcome.hit ? 1 : 0;
    through += outcome.through ? 1 : 0;
    stopped += outcome.stopped ? 1 : 0;
    lost += outcome.finite ? 0 : 1;
    depth = std::max(depth, outcome.depth);
    systems = std::max(systems, outcome.systems);
    if (outcome.through || outcome.stopped || !outcome.finite) seeds.push_back(seed);
  }
};

Tally shoot_many(const Shot& shot, int tries) {
  Tally tally;
  for (int n = 0; n < tries; ++n) {
    const unsigned seed = static_cast<unsigned>(n) + 10000U * static_cast<unsigned>(shot.hung);
    tally.add(shoot(shot, seed), seed);
  }
  return tally;
}

void expect_none_through(Hung hung, double radii, int tries) {
  const Tally tally = shoot_many({hung, radii}, tries);
  EXPECT_EQ(tally.through, 0) << "seeds " << testing::PrintToString(tally.seeds);
  EXPECT_EQ(tally.stopped, 0) << "seeds " << testing::PrintToString(tally.seeds);
  EXPECT_EQ(tally.lost, 0) << "seeds " << testing::PrintToString(tally.seeds);
  EXPECT_GE(tally.hits, tries * 9 / 10);
  EXPECT_LE(tally.depth, half_a_thickness);
}

/// With bounded work per step an abrupt stop may stretch a rope between two pins, so that the ball passes the rope's
/// former place, and a ball may lose its velocity at a loose cord instead of pushing it away. But every tick ends, no
/// penetration is deep, and no ball goes through a loose cord or out of a ring.
TEST(CordPassing, WithBoundedWorkEveryTickEndsAndMostBallsAreStopped) {
  for (const Hung hung : {Hung::taut, Hung::ring, Hung::free_end}) {
    for (const double radii : {10.0, 100.0}) {
      const Tally tally = shoot_many({hung, radii, true, Accuracy{}.max_work}, 60);
      EXPECT_EQ(tally.lost, 0);
      EXPECT_LE(tally.through, hung == Hung::taut ? 1 : 0) << "seeds " << testing::PrintToString(tally.seeds);
      EXPECT_LE(tally.stopped, 24) << "seeds " << testing::PrintToString(tally.seeds);
      EXPECT_LE(tally.depth, 5.0 * half_a_thickness);
      EXPECT_LE(tally.systems, 480);
    }
  }
}

TEST(CordPassing, ShotAtTenAndAHundredRadiiATickNoBallGoesThrough) {
  for (const Hung hung : {Hung::taut, Hung::ring, Hung::free_end}) {
    for (const double radii : {10.0, 100.0}) expect_none_through(hung, radii, 60);
  }
}

/// Neither halves nor linearised contacts solve these, and the latter stretch the cord by a tenth. So what halves leave
/// unsolved is kept.
TEST(CordPassing, WhatLinearisedContactsStretchIsTakenByHalves) {
  for (const unsigned seed : {892U, 955U}) {
    const Outcome outcome = shoot({Hung::taut, 100.0}, seed);
    EXPECT_TRUE(outcome.hit) << seed;
    EXPECT_FALSE(outcome.through) << seed;
    EXPECT_LE(outcome.depth, half_a_thickness) << seed;
  }
}

TEST(LongCordPassing, ShotAThousandTimesNoBallGoesThrough) {
  for (const Hung hung : {Hung::taut, Hung::ring, Hung::free_end}) {
    for (const double radii : {10.0, 100.0}) expect_none_through(hung, radii, 1000);
  }
}

/// The check detects a ball that passes through: here nothing stops it.
TEST(CordPassing, WithoutContactTheTestFindsBallsThatGoThrough) {
  for (const Hung hung : {Hung::taut, Hung::ring, Hung::free_end}) {
    for (const double radii : {1.0, 10.0, 100.0}) {
      const Tally tally = shoot_many({hung, radii, false}, 100);
      EXPECT_GE(tally.hits, 90);
      EXPECT_GE(tally.through, tally.hits * 9 / 10);
    }
  }
}

// --- whips ----------------------------------------------------------------------------------------------------------

struct Whip {
  bool driven;  ///< both ends, or neither
  bool with_contact = true;
};

CordDef cord_to_throw(const Whip& scene, double slope) {
  CordDef def;
  def.points = 41;
  def.length = 4.0;
  def.radius = 0.02;
  def.mass_per_length = 0.25;
  const double half = scene.driven ? 1.9 : 2.0;
  for (int i = 0; i < 41; ++i) {
    const double s = (i - 20) / 20.0;
    const double fold = scene.driven ? 0.03 * (i % 2) : 0.0;  // links of 10 cm on 9.5 cm
    def.positions.push_back({half * s * std::cos(slope), half * s * std::sin(slope) + fold});
  }
  return def;
}

/// Moves the ends for a tick to both sides of the peg, and up until they are above it.
void drive_ends(ContactWorld& world, Vec2 peg) {
  for (const int p : {0, 40}) {
    const Vec2 at = world.cord.target(p);
    const double goal_x = peg.x + (p == 0 ? -0.6 : 0.6);
    const double rise = std::clamp(peg.y + 0.5 - at.y, -100.0 * tick, 100.0 * tick);
    world.cord.operate(p, {at.x + std::clamp(goal_x - at.x, -20.0 * tick, 20.0 * tick), at.y + rise});
  }
}

/// Throws a cord of 4 m up at a peg at 100 m/s, 1.7 m per tick. The cord passed through if the peg is no longer above
/// it. With driven ends, which move together to both sides of the peg and stop above it, this holds at any time. Free
/// ends may pass around the peg; for them it holds after the first tick.
Outcome whip(const Whip& scene, unsigned seed) {
  Dice dice(seed);
  const double friction = dice.coin() ? 0.0 : 0.4;
  const Accuracy accuracy = dice.coin() ? Accuracy::balanced() : Accuracy::fast();
  const double slope = dice(-0.3, 0.3);
  CordDef def = cord_to_throw(scene, slope);
  def.friction = friction;
  def.accuracy = accuracy;
  def.accuracy.max_work = ample_work;
  ContactWorld world(def);
  const double radius = dice(0.03, 0.3);
  const double x = dice(-0.5, 0.5);
  const double above = dice(0.1, 1.2) + radius + 0.1;
  const Vec2 peg{x, x * std::tan(slope) + above};
  world.add_peg(peg, radius, 0.4);
  if (!scene.with_contact) world.circles.clear();
  for (int p = 0; p < 41; ++p) world.cord.set_velocity(p, {0.0, 100.0});
  if (scene.driven) {
    for (const int p : {0, 40}) world.cord.operate(p, def.positions[static_cast<std::size_t>(p)]);
  }

  Outcome outcome;
  outcome.hit = true;
  for (int k = 0; k < 20; ++k) {
    if (scene.driven) drive_ends(world, peg);
    world.step();
    const std::span<const Vec2> after = world.cord.positions();
    outcome.finite = outcome.finite && is_finite(after[20]);
    outcome.depth = std::max(outcome.depth, world.depth());
    // A ray down from the peg is a ray up after both are turned upside down.
    std::vector<Vec2> turned;
    for (const Vec2 p : after) turned.push_back(-p);
    if (scene.driven || k == 0) outcome.through = outcome.through || !is_below(turned, -peg);
  }
  return outcome;
}

Tally whip_many(const Whip& scene, int tries) {
  Tally tally;
  for (int n = 0; n < tries; ++n) tally.add(whip(scene, static_cast<unsigned>(n)), static_cast<unsigned>(n));
  return tally;
}

void expect_none_through(const Whip& scene, int tries) {
  const Tally tally = whip_many(scene, tries);
  EXPECT_EQ(tally.through, 0) << "seeds " << testing::PrintToString(tally.seeds);
  EXPECT_EQ(tally.lost, 0) << "seeds " << testing::PrintToString(tally.seeds);
  EXPECT_LE(tally.depth, half_a_thickness);
}

TEST(CordPassing, WhippedAtAHundredMetresASecondItDoesNotGoThroughAPeg) {
  for (const bool driven : {false, true}) expect_none_through(Whip{driven}, 60);
}

TEST(LongCordPassing, WhippedAThousandTimesItDoesNotGoThroughAPeg) {
  for (const bool driven : {false, true}) expect_none_through(Whip{driven}, 1000);
}

TEST(CordPassing, WithoutContactTheTestFindsAWhipThatGoesThrough) {
  for (const bool driven : {false, true}) EXPECT_EQ(whip_many({driven, false}, 50).through, 50);
}

/// A drawn string is released towards a peg. It starts from rest, and its first tick is longer than any motion in the
/// tick before.
TEST(CordPassing, ASnappingStringDoesNotGoThroughAPeg) {
  for (const double stiffness : {1e3, 1e4}) {
    for (const int substeps : {1, 4}) {
      CordDef def;
      def.points = 41;
      def.length = 2.0;
      def.radius = half_a_thickness;
      def.stretch_stiffness = stiffness;
      def.pins = {0, 40};
      def.accuracy.substeps = substeps;
      ContactWorld world(def);
      for (int k = 1; k <= 80; ++k) {
        world.cord.operate(20, {1.0, -0.05 * std::min(k, 20)});
        world.step();
      }
      const Vec2 peg{1.03, -0.7};
      world.add_peg(peg, 0.1, 0.0);
      ASSERT_LT(world.depth(), 0.0);
      world.cord.release(20);
      for (int k = 0; k < 60; ++k) {
        world.step();
        std::vector<Vec2> turned;
        for (const Vec2 p : world.cord.positions()) turned.push_back(-p);
        ASSERT_TRUE(is_below(turned, -peg)) << stiffness << " " << substeps << " " << k;
        ASSERT_LE(world.depth(), half_a_thickness);
      }
    }
  }
}

}  // namespace
}  // namespace ribbon
