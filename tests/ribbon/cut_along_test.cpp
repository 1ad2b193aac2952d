#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/cut.h"
#include "tests/support/constants.h"
#include "tests/support/cord_sums.h"
#include "tests/support/refusal.h"

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
using test_support::refusal;
using test_support::says;
using test_support::Sums;
using test_support::sums_of;
constexpr double width = 0.3;

/// A ribbon of 1.2 m and 13 columns whose EI is a part of that of a solid strip.
CordDef ribbon_of(int rows, double part) {
  CordDef def;
  def.points = 13;
  def.rows = rows;
  def.length = 1.2;
  def.width = width;
  def.stretch_stiffness = 2e3;
  def.bending_stiffness = part * def.stretch_stiffness * width * width / 12.0;
  return def;
}

/// It is held at its first column, has fallen for half a second and carries a mass and a load.
Cord swinging_ribbon(CordDef def) {
  for (int j = 0; j < def.rows; ++j) def.pins.push_back(j);
  Cord cord(def);
  cord.attach_mass(cord.index(7, 0), 0.05);
  cord.attach_mass(cord.index(9, def.rows - 1), 0.02);
  cord.set_load(cord.index(5, def.rows - 1), {0.3, 0.2});
  for (int k = 0; k < 30; ++k) cord.step(dt, gravity);
  return cord;
}

/// Expects that a cut conserves everything but the energy.
void expect_conserved(const Sums& before, const Sums& after) {
  EXPECT_NEAR(after.mass, before.mass, 1e-14);
  EXPECT_LE(length(after.momentum - before.momentum), 1e-14);
  EXPECT_NEAR(after.turning, before.turning, 1e-14);
}

TEST(CutAlong, KeepsTheEnergyOfASolidStrip) {
  for (const int rows : {3, 4, 5, 6}) {
    for (const double damping : {0.0, 0.003}) {
      CordDef def = ribbon_of(rows, 1.0);
      def.damping = damping;
      def.poisson_ratio = 0.2;
      def.area_stiffness = 1.0;
      const Cord cord = swinging_ribbon(def);
      const Sums before = sums_of(cord, gravity);
      EXPECT_GT(energy_of(cord, gravity).elastic, 1e-4);
      for (int row = 1; row + 1 < rows; ++row) {
        const CutPieces pieces = cut(cord, cut_along(cord, row));
        EXPECT_EQ(pieces.first->def().rows + pieces.second->def().rows, rows + 1);
        expect_conserved(before, sums_of(pieces, gravity));
        EXPECT_NEAR(sums_of(pieces, gravity).energy, before.energy, 1e-13) << rows << ' ' << row;
      }
    }
  }
}

/// EA is proportional to the width and EI to its cube: both pieces are strips of the same solid.
TEST(CutAlong, MakesStripsOfTheSameSolid) {
  const Cord cord{ribbon_of(6, 1.0)};
  const CutPieces pieces = cut(cord, cut_along(cord, 2));
  for (const auto& [piece, share] : {std::pair(&*pieces.first, 0.4), std::pair(&*pieces.second, 0.6)}) {
    const CordDef& def = piece->def();
    EXPECT_NEAR(def.width, share * width, 1e-15);
    EXPECT_NEAR(def.stretch_stiffness, share * 2e3, 1e-12);
    EXPECT_NEAR(def.bending_stiffness, def.stretch_stiffness * def.width * def.width / 12.0, 1e-13);
    EXPECT_NEAR(def.mass_per_length, share * cord.def().mass_per_length, 1e-16);
    EXPECT_EQ(def.length, cord.def().length);
    EXPECT_NO_THROW(check(def));
  }
}

/// Two halves of a solid cantilever of length L and width w bend four times as much as the whole, and shear as much.
/// Shear adds (2/3)·(w/L)²·6/5 to the bending of the whole.
TEST(CutAlong, HalvesBendAsTheirOwnWidthDoes) {
  CordDef def = ribbon_of(5, 1.0);
  for (int j = 0; j < 2 * def.rows; ++j) def.pins.push_back(j);
  def.stretch_stiffness *= 100.0;
  def.bending_stiffness *= 100.0;
  def.damping = 0.05;
  Cord cord(def);
  CutPieces pieces = cut(cord, cut_along(cord, 2));
  const auto sag = [](Cord& bent) {
    const double start = bent.positions()[static_cast<std::size_t>(bent.size() - 1)].y;
    for (int k = 0; k < 300; ++k) bent.step(dt, gravity);
    return start - bent.positions()[static_cast<std::size_t>(bent.size() - 1)].y;
  };
  const double whole = sag(cord);
  EXPECT_GT(whole, 1e-4);
  const double shear = 2.0 / 3.0 * 1.2 * (width / 1.1) * (width / 1.1);
  const double expected = (4.0 + shear) / (1.0 + shear) * whole;
  EXPECT_NEAR(sag(*pieces.first), expected, 0.01 * expected);
  EXPECT_NEAR(sag(*pieces.second), expected, 0.01 * expected);
}

/// With less EI than a solid strip has, a spine carries the rest of EA. It does not snap apart when it is bent.
TEST(CutAlong, OfABentRibbonWithASpineDoesNotGainEnergy) {
  for (const int rows : {3, 4, 5, 6, 7}) {
    for (const double part : {0.01, 0.1, 0.5}) {
      const Cord cord = swinging_ribbon(ribbon_of(rows, part));
      const Sums before = sums_of(cord, gravity);
      for (int row = 1; row + 1 < rows; ++row) {
        const CutPieces pieces = cut(cord, cut_along(cord, row));
        const Sums after = sums_of(pieces, gravity);
        expect_conserved(before, after);
        EXPECT_LE(after.energy, before.energy + 1e-12) << rows << ' ' << row << ' ' << part;
      }
    }
  }
}

/// Cells of two rows with a spine: EA is that of the definition, and the piece of a ribbon has the cells that it had.
TEST(CutAlong, APieceOfTwoRowsHasASpineToo) {
  CordDef def = ribbon_of(3, 0.05);
  const Cord cord(def);
  const CutPieces pieces = cut(cord, cut_along(cord, 1));
  const CordDef& half = pieces.second->def();
  EXPECT_NEAR(half.cell_stiffness, 0.05 * half.stretch_stiffness, 1e-12);
  CordDef stretched = half;
  stretched.pins.clear();
  stretched.positions.clear();
  Cord strip(stretched);
  for (int j = 0; j < 2; ++j) {
    strip.constrain(strip.index(0, j), strip.positions()[static_cast<std::size_t>(strip.index(0, j))]);
    strip.constrain(strip.index(12, j),
                    strip.positions()[static_cast<std::size_t>(strip.index(12, j))] + Vec2{0.012, 0});
  }
  for (int k = 0; k < 100; ++k) strip.step(dt, {});
  EXPECT_NEAR(tension_of(strip, 6), 0.01 * half.stretch_stiffness, 1e-3);
  EXPECT_TRUE(says(refusal<DefinitionError>([&] {
                     stretched.cell_stiffness = 2.0 * stretched.stretch_stiffness;
                     check(stretched);
                   }),
                   "cell_stiffness is 2000"));
  def.cell_stiffness = 1.0;
  EXPECT_EQ(refusal<DefinitionError>([&] { check(def); }),
            "cell_stiffness is 1; accepted is 0 unless two rows have cells");
}

TEST(CutAlong, OfBarsKeepsMassAndMomentum) {
  CordDef def = ribbon_of(4, 0.0);
  def.elements = Elements::bars;
  const Cord cord = swinging_ribbon(def);
  const Sums before = sums_of(cord, gravity);
  for (const int row : {1, 2}) {
    CutPieces pieces = cut(cord, cut_along(cord, row));
    const Sums after = sums_of(pieces, gravity);
    expect_conserved(before, after);
    EXPECT_LE(after.energy, before.energy + 1e-12);
    for (int k = 0; k < 60; ++k) {
      EXPECT_EQ(pieces.first->step(dt, gravity).unconverged, 0);
      EXPECT_EQ(pieces.second->step(dt, gravity).unconverged, 0);
    }
  }
}

/// Otherwise a piece could hang in the penetration that the cord had stopped removing, and fail at what has just
/// failed.
TEST(CutAlong, PiecesRememberWhatFailed) {
  Cord cord = swinging_ribbon(ribbon_of(4, 1.0));
  Cord::State state = cord.save();
  state.depenetration_share = 0.25;
  state.newton_pause = 2;
  cord.restore(state);
  const CutPieces pieces = cut(cord, cut_along(cord, 1));
  EXPECT_EQ(pieces.first->save().depenetration_share, 0.25);
  EXPECT_EQ(pieces.second->save().depenetration_share, 0.25);
  EXPECT_EQ(pieces.first->save().newton_pause, 2);
  EXPECT_EQ(pieces.second->save().newton_pause, 2);
}

TEST(CutAlong, GivesWhatIsAttachedToItsSide) {
  Cord cord = swinging_ribbon(ribbon_of(4, 1.0));
  cord.attach_mass(cord.index(6, 1), 0.5);
  cord.attach_mass(cord.index(6, 2), 0.25);
  cord.set_load(cord.index(8, 1), {1.0, 0.0});
  cord.operate(cord.index(12, 1), {1.0, -0.5});
  cord.set_breaking_force(3, 90.0);
  const CutPieces pieces = cut(cord, cut_along(cord, 1));
  const Cord& first = *pieces.first;
  const Cord& second = *pieces.second;
  EXPECT_NEAR(first.mass(first.index(6, 1)), 0.5 + 0.5 * (cord.mass(cord.index(6, 1)) - 0.5), 1e-15);
  EXPECT_NEAR(second.mass(second.index(6, 0)), 0.5 * (cord.mass(cord.index(6, 1)) - 0.5), 1e-15);
  EXPECT_NEAR(second.mass(second.index(6, 1)), cord.mass(cord.index(6, 2)), 1e-15);
  EXPECT_EQ(first.save().loads[static_cast<std::size_t>(first.index(8, 1))], (Vec2{1.0, 0.0}));
  EXPECT_EQ(second.save().loads[static_cast<std::size_t>(second.index(8, 0))], (Vec2{}));
  EXPECT_EQ(second.save().loads[static_cast<std::size_t>(second.index(5, 2))], (Vec2{0.3, 0.2}));
  EXPECT_EQ(first.kind(first.index(12, 1)), PointKind::operated);
  EXPECT_EQ(second.kind(second.index(12, 0)), PointKind::free);
  EXPECT_EQ(first.kind(first.index(0, 1)), PointKind::constrained);
  EXPECT_EQ(second.kind(second.index(0, 0)), PointKind::constrained) << "a pin in the row holds both";
  EXPECT_EQ(second.kind(second.index(0, 1)), PointKind::constrained);
  EXPECT_NEAR(first.breaking_force(3), 30.0, 1e-12);
  EXPECT_NEAR(second.breaking_force(3), 60.0, 1e-12);
}

TEST(CutAlong, PiecesAreCutAndReeledAndMoveOn) {
  Cord cord = swinging_ribbon(ribbon_of(5, 0.3));
  cord.reel(0, 12, 0.9, 0.5);
  for (int k = 0; k < 10; ++k) cord.step(dt, gravity);
  CutPieces halves = cut(cord, cut_along(cord, 2));
  CutPieces pieces = cut(*halves.first, cut_along(*halves.first, 1));
  CutPieces ends = cut(*halves.second, cut_at(*halves.second, 0.5));
  for (int k = 0; k < 120; ++k) {
    for (Cord* piece : {&*pieces.first, &*pieces.second, &*ends.first, &*ends.second}) {
      EXPECT_EQ(piece->step(dt, gravity).unconverged, 0);
    }
  }
  EXPECT_EQ(pieces.first->def().rows, 2);
  EXPECT_TRUE(ends.first->save().split) << "pieces of a piece touch no other one either";
  double reeled = 0.0;
  for (int i = 0; i < 12; ++i) reeled += pieces.first->rest_length(i);
  EXPECT_NEAR(reeled, 0.9, 0.05);
}

TEST(CutAlong, AnUnknownRowIsRefused) {
  const Cord cord{ribbon_of(4, 1.0)};
  for (const int row : {-1, 0, 3, 4}) {
    EXPECT_TRUE(says(refusal<DefinitionError>([&] { cut_along(cord, row); }), "accepted is 1 to 2")) << row;
  }
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { cut(cord, {0, 0.0, 3}); }), "row is 3"));
  const Cord strip{ribbon_of(2, 1.0)};
  EXPECT_EQ(refusal<CallError>([&] { cut_along(strip, 1); }),
            "cut along a row is of a cord with 2 rows; accepted is a ribbon of three or more rows");
  EXPECT_TRUE(says(refusal<CallError>([&] { cut_along(Cord(CordDef{}), 1); }), "1 row;"));
}

/// A ribbon of 2 m that hangs from its first column.
CordDef hanging_ribbon(int rows, Elements elements) {
  CordDef def;
  def.points = 21;
  def.rows = rows;
  def.length = 2.0;
  def.width = width;
  def.mass_per_length = 0.5;
  def.stretch_stiffness = 1e4;
  def.elements = elements;
  if (elements == Elements::cells) def.bending_stiffness = 0.2 * def.stretch_stiffness * width * width / 12.0;
  def.drag = 2.0;
  def.damping = 1e-3;
  for (int i = 0; i < def.points; ++i) {
    for (int j = 0; j < rows; ++j) def.positions.push_back({width * j / (rows - 1), -0.1 * i});
  }
  for (int j = 0; j < rows; ++j) def.pins.push_back(j);
  return def;
}

/// The tension across a column is the weight of what hangs below the middle of the link, for all elements.
TEST(BreakingForce, OfAHangingRibbonIsTheWeightBelow) {
  for (const int rows : {2, 3, 4}) {
    for (const Elements elements : {Elements::cells, Elements::bars}) {
      Cord cord(hanging_ribbon(rows, elements));
      for (int k = 0; k < 300; ++k) cord.step(dt, gravity);
      for (int link = 0; link < 20; ++link) {
        const double weight = 0.5 * 9.81 * (1.95 - 0.1 * link);
        EXPECT_NEAR(tension_of(cord, link), weight, 1e-3 * weight) << rows << ' ' << link;
      }
    }
  }
}

TEST(BreakingForce, OfAHangingRibbonIsExceededAtTheTopFirst) {
  for (const Elements elements : {Elements::cells, Elements::bars}) {
    CordDef def = hanging_ribbon(3, elements);
    def.breaking_force = 0.5 * 9.81 * 2.1;
    Cord cord(def);
    for (int k = 0; k < 200; ++k) cord.step(dt, gravity);
    EXPECT_EQ(overloaded_link(cord), std::nullopt);
    for (double load = 0.0; load < 0.2 && !overloaded_link(cord); load += 0.002) {
      for (int j = 0; j < 3; ++j) cord.attach_mass(cord.index(20, j), load / 3.0);
      for (int k = 0; k < 10; ++k) cord.step(dt, gravity);
    }
    EXPECT_EQ(overloaded_link(cord), 0);
    cord.set_breaking_force(11, 2.0);
    EXPECT_EQ(overloaded_link(cord), 11) << "where it is weak";
    const CutPieces pieces = cut(cord, cut_through(cord, 11));
    EXPECT_EQ(pieces.first->size(), 13 * 3);
    EXPECT_EQ(pieces.first->breaking_force(11), 2.0);
    EXPECT_EQ(pieces.second->breaking_force(0), def.breaking_force);
  }
}

TEST(BreakingForce, ALinkInShearOrUnderCompressionIsNotOverloaded) {
  CordDef def = hanging_ribbon(3, Elements::cells);
  for (Vec2& x : def.positions) x.y = 0.97 * x.y;
  def.breaking_force = 1e-3;
  const Cord cord(def);
  EXPECT_LT(tension_of(cord, 5), -1.0);
  EXPECT_EQ(overloaded_link(cord), std::nullopt);
  EXPECT_EQ(refusal<DefinitionError>([&] { (void)tension_of(cord, 20); }), "link is 20; accepted is 0 to 19");
}

}  // namespace
}  // namespace ribbon
