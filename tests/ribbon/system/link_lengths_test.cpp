#include "ribbon/system/link_lengths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "ribbon/system/stretch.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"

namespace ribbon {
namespace {

using test_support::AllocationCount;
using test_support::Dice;

constexpr int points = 9;  // of each rope; its links are 1 m long

CordDef rope() {
  CordDef def;
  def.points = points;
  def.length = points - 1.0;
  return def;
}

/// Ropes whose points are displaced from a straight line at random, as after a solve that was ended early.
struct Ropes {
  std::vector<CordParts> parts;
  IslandState state;
  std::vector<double> inertia;  // N/m
  LinkLengths link_lengths;

  Ropes(const std::vector<CordDef>& defs, double displacement) {
    Dice dice(7);
    for (const CordDef& def : defs) parts.emplace_back(def);
    state.points = parts.size() * points;
    state.resize(state.points, 0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Member member;
      member.cord = &parts[k];
      member.first_point = k * points;
      member.points = points;
      state.members.push_back(member);
    }
    for (std::size_t p = 0; p < state.points; ++p) {
      const std::size_t row = p / points;
      const Vec2 straight{static_cast<double>(p % points), static_cast<double>(row)};
      state.positions[p] = straight + Vec2{dice(-displacement, displacement), dice(-displacement, displacement)};
      inertia.push_back(dice(1.0, 100.0));
    }
    link_lengths.resize(state.points);
  }
  void restore() { link_lengths.restore(state, inertia); }
  double strain() const { return largest_strain(state, state.positions); }
  Vec2 moment() const {
    Vec2 sum;
    for (std::size_t p = 0; p < state.points; ++p) sum += inertia[p] * state.positions[p];
    return sum;
  }
};

TEST(LinkLengths, AreRestLengthsAgain) {
  Ropes ropes({rope(), rope()}, 0.1);
  const Vec2 before = ropes.moment();
  ASSERT_GT(ropes.strain(), 0.1);
  ropes.restore();
  EXPECT_LE(ropes.strain(), 1e-3);
  // Internal forces leave the centre of mass, and with it the linear momentum.
  EXPECT_NEAR(ropes.moment().x, before.x, 1e-10 * std::abs(before.x));
  EXPECT_NEAR(ropes.moment().y, before.y, 1e-10 * std::abs(before.x));
}

/// The displacement is the least that gives the lengths, so light points move more than heavy ones.
TEST(LinkLengths, HeavyPointsMoveLess) {
  Ropes ropes({rope()}, 0.0);
  ropes.state.positions.back().x += 0.1;
  ropes.inertia.assign(points, 1.0);
  ropes.inertia[points - 2] = 999.0;
  const double moved = ropes.state.positions[points - 1].x;
  ropes.restore();
  EXPECT_LE(ropes.strain(), 1e-3);
  EXPECT_NEAR(moved - ropes.state.positions[points - 1].x, 0.1, 2e-3);
}

TEST(LinkLengths, WhatIsConstrainedOrHeldStays) {
  Ropes ropes({rope()}, 0.03);
  IslandState& state = ropes.state;
  state.constrained[0] = 1;
  HeldBody between;
  between.point = 4;
  between.next = 5;
  between.along = 0.5;
  state.held = {between};
  state.positions[2].y += 0.5;  // the first four links are longer than the distance between what is fixed
  for (std::size_t p = 3; p < points; ++p) state.positions[p].x -= 0.2;
  state.positions[5] = state.positions[4] + Vec2{1.0, 0.0};
  const std::vector<Vec2> before = state.positions;
  ropes.restore();
  EXPECT_LE(ropes.strain(), 1e-3);
  for (const std::size_t p : {0U, 4U, 5U}) EXPECT_EQ(state.positions[p], before[p]) << p;
}

/// There is no solution for two fixed points that are further apart than the rope is long.
TEST(LinkLengths, ATautRopeIsNotStretchedMore) {
  Ropes ropes({rope()}, 0.1);
  IslandState& state = ropes.state;
  state.positions.front() = {};
  state.positions.back() = {points, 0.0};  // m, one more than its length
  state.constrained.front() = state.constrained.back() = 1;
  for (int k = 0; k < 5; ++k) {
    const double before = ropes.strain();
    ropes.restore();
    EXPECT_LE(ropes.strain(), before);
  }
}

TEST(LinkLengths, SlackLinksOfTensionOnlyRopesStay) {
  CordDef def = rope();
  def.tension_only = true;
  Ropes ropes({def}, 0.0);
  IslandState& state = ropes.state;
  for (std::size_t p = 0; p < 5; ++p) state.positions[p].x += 0.2;  // compresses one link
  state.positions.back().x += 0.1;                                  // stretches another one
  ropes.restore();
  EXPECT_LE(ropes.strain(), 1e-3);
  EXPECT_LT(state.positions[5].x - state.positions[4].x, 0.85);  // m; the stretched link pulls the others a little
}

TEST(LinkLengths, ExtensibleCordsAndGoodLengthsStay) {
  CordDef elastic = rope();
  elastic.stretch_stiffness = 1e3;
  Ropes ropes({elastic, rope()}, 0.1);
  for (std::size_t p = points; p < 2 * points; ++p) {
    ropes.state.positions[p] = {1.0 * static_cast<double>(p), 0.0};
  }
  const std::vector<Vec2> before = ropes.state.positions;
  ropes.restore();
  EXPECT_EQ(ropes.state.positions, before);
}

TEST(LinkLengths, CoincidentPointsGiveFinitePositions) {
  Ropes ropes({rope()}, 0.1);
  ropes.state.positions[3] = ropes.state.positions[4];
  ropes.restore();
  for (const Vec2 x : ropes.state.positions) EXPECT_TRUE(is_finite(x));
}

TEST(LinkLengths, AllocateNothing) {
  Ropes ropes({rope(), rope()}, 0.1);
  const std::vector<Vec2> start = ropes.state.positions;
  const AllocationCount count;
  ropes.restore();
  ropes.state.positions = start;
  ropes.restore();
  EXPECT_EQ(count.so_far(), 0);
}

}  // namespace
}  // namespace ribbon
