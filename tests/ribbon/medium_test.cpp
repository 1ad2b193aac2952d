#include "ribbon/medium.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "ribbon/cord.h"
#include "ribbon/cut.h"
#include "ribbon/direct_solver.h"
#include "ribbon/error_probe.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/weather.h"
#include "tests/ribbon/in_medium.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/dice.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"
#include "tests/support/towed_line.h"

// Cords in a medium: CordDef::drag_across, drag_along and displaced_area.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;

TEST(CordInMedium, DriftsWithTheCurrent) {
  CordDef def = rope_with_drag();
  def.displaced_area = round_area(def);
  def.mass_per_length = 500.0 * def.displaced_area;
  const Weather river(water({0.7, 0.0}));
  InMedium floating{Cord(def), river};
  floating.step(3600);
  EXPECT_NEAR(floating.momentum().x, 0.7 * def.mass_per_length * def.length, 0.03 * def.mass_per_length * def.length);
}

/// What declares no coefficient keeps its bits, and so does what is where nothing is.
TEST(CordInMedium, NothingActsOnWhatDeclaresNothing) {
  const Weather storm(wind({30.0, 5.0}));
  WeatherDef nothing;
  nothing.air_density = 0.0;
  nothing.wind = {30.0, 5.0};
  const Weather vacuum(nothing);
  for (const bool declares : {false, true}) {
    CordDef def = rope_with_drag();
    def.pins = {0};
    if (!declares) def.drag_across = def.drag_along = 0.0;
    Cord alone(def);
    InMedium blown{Cord(def), declares ? vacuum : storm};
    for (int k = 0; k < 120; ++k) {
      alone.step(dt, gravity);
      blown.step();
    }
    EXPECT_EQ(alone.save(), blown.cord.save());
  }
}

/// Wind sets a free cord in motion, at last as fast as itself, and never faster.
TEST(CordInMedium, GivesAFreeCordItsVelocity) {
  CordDef def = rope_with_drag();
  def.gravity_scale = 0.0;
  def.bending_stiffness = 10.0;
  const Weather blow(wind({0.0, 8.0}));
  InMedium blown{Cord(def), blow};
  for (int k = 0; k < 600; ++k) {
    blown.step();
    ASSERT_LT(blown.top_speed(), 8.0 + 1e-9);
  }
  const double rate = drag_across_of(def, air) / def.mass_per_length;   // 1/m
  const double expected = 8.0 - 8.0 / (1.0 + 8.0 * rate * blown.time);  // of dv/dt = rate·(8 − v)²
  EXPECT_NEAR(blown.cord.velocities()[20].y, expected, 1e-3);
}

/// A medium of the user's own: a function of place and time.
class Whirl : public Medium {
 public:
  MediumSample at(Vec2 place, double /*half_height*/, double time) const override {
    MediumSample sample;
    sample.velocity = (time < 1.0 ? 2.0 : 0.0) * perp(place);
    sample.density = air;
    return sample;
  }
};

TEST(CordInMedium, FollowsAFunctionOfPlaceAndTime) {
  CordDef def = rope_with_drag(1e-3);
  def.gravity_scale = 0.0;
  def.bending_stiffness = 10.0;
  def.positions = test_support::equally_spaced(def.points, {-2.0, 0.0}, {0.1, 0.0});
  const Whirl whirl;
  InMedium turning{Cord(def), whirl};
  turning.step(50);
  const Vec2 end = turning.cord.velocities()[40];
  EXPECT_NEAR(length(end), 4.0, 0.15) << "2 rad/s at 2 m";
  EXPECT_NEAR(dot(end, turning.cord.positions()[40]), 0.0, 0.1);
  turning.step(120);
  EXPECT_LT(turning.top_speed(), 1.0) << "still since t = 1 s";
}

/// What is out of range counts as empty space.
class Broken : public Medium {
 public:
  explicit Broken(const MediumSample& sample) : sample_(sample) {}
  MediumSample at(Vec2 /*place*/, double /*half_height*/, double /*time*/) const override { return sample_; }

 private:
  MediumSample sample_;
};

TEST(CordInMedium, ABadSampleIsEmptySpace) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const MediumSample& sample :
       {MediumSample{{nan, 0.0}, air}, MediumSample{{0.0, 1e7}, air}, MediumSample{{5.0, 0.0}, -1.0},
        MediumSample{{5.0, 0.0}, nan}, MediumSample{{5.0, 0.0}, 1e7}, MediumSample{{5.0, 0.0}, air, {0.0, nan}}}) {
    const Broken medium(sample);
    InMedium blown{Cord(rope_with_drag()), medium};
    Cord alone(rope_with_drag());
    blown.step(20);
    for (int k = 0; k < 20; ++k) alone.step(dt, gravity);
    EXPECT_EQ(blown.cord.save(), alone.save());
  }
}

TEST(CordInMedium, ContinuesFromASavedStateWithTheSameBits) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  WeatherDef gusty = wind({6.0, 0.0});
  gusty.gusts = 0.8;
  gusty.water_level = -2.0;
  def.displaced_area = round_area(def);
  const Weather medium(gusty);
  InMedium first{Cord(def), medium};
  first.step(37);
  InMedium second{Cord(def), medium};
  second.cord.restore(first.cord.save());
  second.time = first.time;
  first.step(50);
  second.step(50);
  EXPECT_EQ(first.cord.save(), second.cord.save());
  Cord::State bad = first.cord.save();
  bad.medium_forces.pop_back();
  EXPECT_THROW(second.cord.restore(bad), DefinitionError);
  bad = first.cord.save();
  bad.medium_forces[3].x = std::numeric_limits<double>::infinity();
  EXPECT_THROW(second.cord.restore(bad), DefinitionError);
}

TEST(CordInMedium, AllocatesNothingInASteadyStep) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  const Weather blow(wind({6.0, 1.0}));
  InMedium blown{Cord(def), blow};
  blown.step(3);
  const test_support::AllocationCount allocations;
  blown.step(60);
  EXPECT_EQ(allocations.so_far(), 0);
}

/// It sleeps in a steady wind, and wakes when that changes at its place.
TEST(CordInMedium, SleepsUntilTheWindChanges) {
  CordDef def = rope_with_drag(0.5);
  def.points = 11;
  def.length = 1.0;
  def.pins = {0};
  def.drag = 4.0;
  def.allow_sleep = true;
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  const Weather steady(wind({3.0, 0.0}));
  const Weather stronger(wind({3.1, 0.0}));
  InMedium blown{Cord(def), steady};
  blown.step(1200);
  ASSERT_TRUE(blown.cord.is_asleep());
  const Cord::State asleep = blown.cord.save();
  blown.step(60);
  EXPECT_EQ(blown.cord.save(), asleep);
  InMedium changed{Cord(def), stronger};
  changed.cord.restore(asleep);
  changed.step();
  EXPECT_FALSE(changed.cord.is_asleep());

  WeatherDef gusty = wind({3.0, 0.0});
  gusty.gusts = 0.5;
  const Weather gusts(gusty);
  InMedium waving{Cord(def), gusts};
  waving.step(1800);
  EXPECT_FALSE(waving.cord.is_asleep());
}

/// The pieces of a cord go on with the forces that they had.
TEST(CordInMedium, APieceKeepsItsForces) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  const Weather blow(wind({6.0, 0.0}));
  InMedium blown{Cord(def), blow};
  blown.step(30);
  const Cord::State whole = blown.cord.save();
  const CutPieces pieces = cut(blown.cord, cut_at(blown.cord, 2.0));
  ASSERT_TRUE(pieces.first && pieces.second);
  EXPECT_EQ(pieces.first->save().medium_forces[3], whole.medium_forces[3]);
  EXPECT_EQ(pieces.second->save().medium_forces[3], whole.medium_forces[23]);
  EXPECT_EQ(pieces.second->def().drag_across, across);
}

TEST(CordInMedium, ItsErrorIsEstimated) {
  CordDef def = rope_with_drag();
  def.pins = {0};
  def.positions = test_support::equally_spaced(def.points, {0.0, 0.0}, {0.0, -0.1});
  const Weather blow(wind({3.0, 0.0}));
  Cord cord(def);
  std::array reports{CordReport{}};
  DirectSolver solver;
  ErrorProbe probe;
  double largest = 0.0;
  for (int k = 0; k < 60; ++k) {
    IslandCord member{&cord, {}, 1};
    member.surroundings.medium = &blow;
    member.surroundings.time = k * dt;
    probe.foresee({&member, 1}, {}, dt, gravity);
    solver.step({&member, 1}, {}, dt, gravity, reports);
    largest = std::max(largest, probe.error(0, cord));
  }
  EXPECT_LT(largest, 1e-3);
  EXPECT_GT(largest, 0.0);
}

TEST(CordInMedium, ChangesTheVelocityByNoMoreThanItSays) {
  test_support::Dice dice(7);
  for (int k = 0; k < 200; ++k) {
    CordDef def = rope_with_drag(std::pow(10.0, dice(-4.0, 0.0)));
    def.points = 3;
    def.length = 0.3;
    def.gravity_scale = 0.0;
    WeatherDef sea = water({dice(-3.0, 3.0), dice(-3.0, 3.0)});
    sea.wind = {dice(-100.0, 100.0), dice(-100.0, 100.0)};
    sea.air_density = air;
    sea.water_level = dice.coin() ? -100.0 : 100.0;
    if (dice.coin()) def.displaced_area = round_area(def);
    const Weather medium(sea);
    InMedium blown{Cord(def), medium};
    const double bound = medium_delta_v(blown.cord, medium, 0.0, dt, gravity);
    blown.step();
    EXPECT_LT(blown.top_speed(), 1.5 * bound + 1e-9) << k;
  }
  const Weather still{WeatherDef{}};
  EXPECT_EQ(medium_delta_v(Cord(CordDef{}), still, 0.0, dt, gravity), 0.0);
}

TEST(CordInMedium, RefusesWhatIsOutOfRange) {
  Cord cord(rope_with_drag());
  const Cord::State before = cord.save();
  Surroundings surroundings;
  surroundings.time = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(test_support::starts_with(
      test_support::refusal<DefinitionError>([&] { cord.step(dt, gravity, surroundings); }), "time is "));
  EXPECT_EQ(cord.save(), before);
}

TEST(CordInMedium, TheThesisSolverRefusesIt) {
  ThesisCord cord{ThesisDef{}};
  const Weather still{WeatherDef{}};
  Surroundings surroundings;
  surroundings.medium = &still;
  const ThesisCord::State before = cord.save();
  EXPECT_TRUE(test_support::says(test_support::refusal<DefinitionError>([&] { cord.step(dt, gravity, surroundings); }),
                                 "medium"));
  EXPECT_EQ(cord.save(), before);
}

}  // namespace
}  // namespace ribbon
