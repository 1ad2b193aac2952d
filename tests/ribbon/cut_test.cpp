#include "ribbon/cut.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "ribbon/cord_forces.h"
#include "tests/support/constants.h"
#include "tests/support/cord_sums.h"
#include "tests/support/hanging.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
using test_support::hanging;
using test_support::refusal;
using test_support::says;
using test_support::Sums;
using test_support::sums_of;

/// A rope of 2 m that starts level, swings about its first point and carries a mass and a load.
Cord swinging(const CordDef& terms) {
  CordDef def = terms;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0};
  Cord cord(def);
  cord.attach_mass(15, 0.5);
  cord.set_load(7, {0.3, 0.2});
  for (int k = 0; k < 40; ++k) cord.step(dt, gravity);
  return cord;
}

std::vector<CordDef> ropes() {
  std::vector<CordDef> defs(5);
  defs[1].stretch_stiffness = 1e4;
  defs[2].stretch_stiffness = 1e4;
  defs[2].damping = 0.01;
  defs[3].bending_stiffness = 0.02;
  defs[4].stretch_stiffness = 1e3;
  defs[4].bending_stiffness = 0.02;
  defs[4].damping = 0.02;
  return defs;
}

TEST(Cut, ConservesMassMomentumAndTheEnergyOfWhatIsNotBentAtTheCut) {
  for (const CordDef& terms : ropes()) {
    const Cord cord = swinging(terms);
    const Sums before = sums_of(cord, gravity);
    for (const double arc : {0.04, 0.3, 0.77, 1.0, 1.949, 1.97}) {
      const Sums after = sums_of(cut(cord, cut_at(cord, arc)), gravity);
      EXPECT_NEAR(after.mass, before.mass, 1e-14);
      EXPECT_LE(length(after.momentum - before.momentum), 1e-14 * length(before.momentum));
      EXPECT_NEAR(after.turning, before.turning, 1e-14 * std::abs(before.turning));
      EXPECT_LE(after.energy, before.energy + 1e-14);
      if (terms.bending_stiffness > 0.0) continue;
      EXPECT_NEAR(after.energy, before.energy, 1e-13) << arc;
    }
  }
}

/// The bend at the cut is the only one that is lost: ½·EI/l³·|x₋ − 2x + x₊|².
TEST(Cut, LosesTheEnergyOfTheBendAtTheCut) {
  CordDef terms;
  terms.bending_stiffness = 0.02;
  const Cord cord = swinging(terms);
  const auto x = cord.positions();
  const Vec2 turn = x[9] - 2.0 * x[10] + x[11];
  const double bend = 0.5 * 0.02 / 1e-3 * dot(turn, turn);
  EXPECT_GT(bend, 1e-6);
  const double after = sums_of(cut(cord, cut_at(cord, 1.0)), gravity).energy;
  EXPECT_NEAR(sums_of(cord, gravity).energy - after, bend, 1e-12);
}

TEST(Cut, DividesTheDriftOfTheEnergyByLength) {
  CordDef terms;
  terms.stretch_stiffness = 1e3;
  terms.damping = 0.02;
  const Cord cord = swinging(terms);
  const double drift = cord.save().energy_drift;
  ASSERT_NE(drift, 0.0);
  const auto [first, second] = cut(cord, cut_at(cord, 0.5));
  EXPECT_DOUBLE_EQ(first->save().energy_drift, 0.25 * drift);
  EXPECT_DOUBLE_EQ(second->save().energy_drift, 0.75 * drift);
}

/// Otherwise a piece could hang in the penetration that the cord had stopped removing, and fail at what has just
/// failed.
TEST(Cut, PiecesRememberWhatFailed) {
  Cord cord = swinging({});
  Cord::State state = cord.save();
  state.depenetration_share = 0.25;
  state.newton_pause = 2;
  cord.restore(state);
  const CutPieces pieces = cut(cord, cut_at(cord, 0.5));
  EXPECT_EQ(pieces.first->save().depenetration_share, 0.25);
  EXPECT_EQ(pieces.second->save().depenetration_share, 0.25);
  EXPECT_EQ(pieces.first->save().newton_pause, 2);
  EXPECT_EQ(pieces.second->save().newton_pause, 2);
}

TEST(Cut, GivesWhatIsAttachedToItsSide) {
  Cord cord = swinging({});
  cord.constrain(10, cord.positions()[10]);
  for (const auto& [arc, owner] : {std::pair(0.98, 1), std::pair(1.0, 0), std::pair(1.02, 0)}) {
    const CutPieces pieces = cut(cord, cut_at(cord, arc));
    ASSERT_TRUE(pieces.first && pieces.second);
    EXPECT_EQ(pieces.first->size(), 11);
    EXPECT_EQ(pieces.second->size(), 11);
    EXPECT_EQ(pieces.first->kind(0), PointKind::constrained);
    EXPECT_EQ(pieces.first->kind(10), owner == 0 ? PointKind::constrained : PointKind::free) << arc;
    EXPECT_EQ(pieces.second->kind(0), owner == 1 ? PointKind::constrained : PointKind::free) << arc;
    EXPECT_NEAR(pieces.second->mass(5), 0.51, 1e-15);
    EXPECT_NEAR(pieces.first->mass(10) + pieces.second->mass(0), cord.mass(10), 1e-17);
    EXPECT_EQ(pieces.first->save().loads[7], (Vec2{0.3, 0.2}));
  }
}

TEST(Cut, CloseToAnEndFreesThatEnd) {
  const Cord cord = swinging({});
  const CutPieces at_pin = cut(cord, cut_at(cord, 0.01));
  EXPECT_FALSE(at_pin.first);
  ASSERT_TRUE(at_pin.second);
  EXPECT_EQ(at_pin.second->size(), 21);
  EXPECT_EQ(at_pin.second->kind(0), PointKind::free);
  EXPECT_NEAR(at_pin.second->mass(15), 0.51, 1e-15);
  const CutPieces at_end = cut(cord, cut_at(cord, 1.99));
  EXPECT_FALSE(at_end.second);
  ASSERT_TRUE(at_end.first);
  EXPECT_EQ(at_end.first->kind(0), PointKind::constrained);
}

TEST(Cut, OutsideOfTheCordIsRefused) {
  const Cord cord = swinging({});
  for (const double arc : {-1.0, 0.0, 2.1, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(says(refusal<DefinitionError>([&] { cut_at(cord, arc); }), "accepted is a place inside the cord"))
        << arc;
  }
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { cut_through(cord, 20); }), "link is 20; accepted is 0 to 19"));
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { cut(cord, {21, 21.0}); }), "column of a cut is 21"));
}

TEST(Cut, PiecesMoveOnAsCordsOfTheirOwn) {
  Cord cord(hanging(21, 2.0));
  for (int k = 0; k < 10; ++k) cord.step(dt, gravity);
  CutPieces pieces = cut(cord, cut_at(cord, 1.0));
  for (int k = 0; k < 30; ++k) {
    pieces.first->step(dt, gravity);
    pieces.second->step(dt, gravity);
  }
  EXPECT_NEAR(pieces.first->positions()[10].y, -1.0, 1e-9) << "it hangs";
  EXPECT_NEAR(pieces.second->positions()[10].y, -2.0 - 0.5 * 9.81 * 0.25, 1e-3) << "it falls freely";
  EXPECT_NEAR(pieces.second->velocities()[3].y, -9.81 * 0.5, 1e-9);
}

TEST(Cut, ReelsGoOnOnBothSides) {
  Cord cord(hanging(21, 2.0));
  cord.reel(0, 20, 1.0, 1.0);
  for (int k = 0; k < 30; ++k) cord.step(dt, gravity);
  CutPieces pieces = cut(cord, cut_at(cord, 0.75));
  for (int k = 0; k < 90; ++k) {
    pieces.first->step(dt, gravity);
    pieces.second->step(dt, gravity);
  }
  EXPECT_NEAR(pieces.first->rest_length(3), 0.05, 1e-12);
  EXPECT_NEAR(pieces.second->rest_length(3), 0.05, 1e-12);
  EXPECT_EQ(pieces.first->size() + pieces.second->size(), 22);
}

TEST(Cut, RibbonsAreCutAcross) {
  for (const int rows : {2, 3, 4}) {
    CordDef def;
    def.points = 13;
    def.rows = rows;
    def.length = 1.2;
    def.width = 0.3;
    def.stretch_stiffness = 2e3;
    def.bending_stiffness = 0.5;
    def.area_stiffness = 1.0;
    for (int j = 0; j < rows; ++j) def.pins.push_back(j);
    Cord cord(def);
    for (int k = 0; k < 30; ++k) cord.step(dt, gravity);
    const Sums before = sums_of(cord, gravity);
    CutPieces pieces = cut(cord, cut_at(cord, 0.52));
    const Sums after = sums_of(pieces, gravity);
    EXPECT_EQ(pieces.first->size(), 6 * rows);
    EXPECT_EQ(pieces.second->size(), 8 * rows);
    EXPECT_NEAR(after.mass, before.mass, 1e-14);
    EXPECT_LE(length(after.momentum - before.momentum), 1e-14);
    EXPECT_NEAR(after.energy, before.energy, 1e-12) << rows;
    for (int k = 0; k < 60; ++k) {
      EXPECT_EQ(pieces.first->step(dt, gravity).unconverged, 0);
      EXPECT_EQ(pieces.second->step(dt, gravity).unconverged, 0);
    }
    EXPECT_LE(sums_of(pieces, gravity).energy, before.energy + 1e-3);
  }
}

/// Theory: the tension of a hanging cord is largest at the pin, M·g of what hangs below the middle of the link.
TEST(BreakingForce, OfAUniformHangingCordIsExceededAtTheTopFirst) {
  CordDef def = hanging(21, 2.0);
  def.breaking_force = 2.5;
  Cord cord(def);
  for (int k = 0; k < 60; ++k) cord.step(dt, gravity);
  EXPECT_EQ(overloaded_link(cord), std::nullopt);
  for (int link = 0; link < 20; ++link) {
    EXPECT_NEAR(cord.tensions()[static_cast<std::size_t>(link)], 0.1 * 9.81 * (1.95 - 0.1 * link), 1e-6);
  }
  for (double load = 0.0; load < 0.2 && !overloaded_link(cord); load += 0.001) {
    cord.attach_mass(20, load);
    cord.step(dt, gravity);
  }
  EXPECT_EQ(overloaded_link(cord), 0);
  EXPECT_EQ(cut_through(cord, 0).column, 1) << "the break leaves a link at the pin";
}

TEST(BreakingForce, OfAWeakLinkIsExceededWhereItIs) {
  CordDef def = hanging(21, 2.0);
  Cord cord(def);
  for (int k = 0; k < 20; ++k) cord.step(dt, gravity);
  EXPECT_EQ(overloaded_link(cord), std::nullopt);
  cord.set_breaking_force(12, 0.7);
  cord.set_breaking_force(16, 0.2);
  EXPECT_EQ(cord.breaking_force(0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(overloaded_link(cord), 16) << "0.34 of 0.2 N is more than 0.74 of 0.7";
  const Cord::State state = cord.save();
  Cord other(def);
  other.restore(state);
  EXPECT_EQ(overloaded_link(other), 16);
  const CutPieces pieces = cut(cord, cut_through(cord, 16));
  EXPECT_EQ(pieces.first->breaking_force(12), 0.7);
  EXPECT_EQ(pieces.first->breaking_force(16), 0.2);
  EXPECT_EQ(overloaded_link(*pieces.second), std::nullopt);
}

TEST(BreakingForce, RefusesInvalidArguments) {
  CordDef def = hanging(3, 2.0);
  def.breaking_force = 0.0;
  EXPECT_EQ(refusal<DefinitionError>([&] { Cord cord(def); }),
            "breaking_force is 0; accepted is above 0, up to infinity");
  def.breaking_force = 5.0;
  Cord cord(def);
  EXPECT_EQ(refusal<DefinitionError>([&] { cord.set_breaking_force(2, 1.0); }), "link is 2; accepted is 0 to 1");
  EXPECT_EQ(refusal<DefinitionError>([&] { cord.set_breaking_force(0, -1.0); }),
            "breaking force is -1; accepted is 0 up to infinity");
}

}  // namespace
}  // namespace ribbon
