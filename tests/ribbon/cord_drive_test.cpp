#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>

#include "ribbon/cord.h"

namespace ribbon {
namespace {

constexpr Vec2 gravity{0.0, -9.81};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

CordDef hanging(int points, double length) {
  CordDef def;
  def.points = points;
  def.length = length;
  def.pins = {0};
  for (int p = 0; p < points; ++p) def.positions.push_back({0.0, -length * p / (points - 1)});
  return def;
}

double rest_length(const Cord& cord) {
  double sum = 0.0;
  for (int i = 0; i + 1 < cord.def().points; ++i) sum += cord.rest_length(i);
  return sum;
}

// --- reeling ---------------------------------------------------------------------------------------------------------

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
    // An inextensible one moves its load as fast as the winch; an elastic one bobs.
    EXPECT_LT(fastest, stiffness == infinity ? 1.2 : 2.1);
  }
}

/// The winch's work is its pull times what it takes in: Σ λ·(−dl) over the links.
TEST(CordReel, AddsTheWorkOfTheWinchAndNoMore) {
  CordDef def = hanging(21, 4.0);
  def.accuracy = Accuracy::accurate();
  Cord cord(def);
  cord.attach_mass(20, 20.0);
  for (int p = 0; p <= 20; ++p) cord.set_velocity(p, {0.15 * p, 0.0});  // swinging
  cord.step(1.0 / 240.0, gravity);
  cord.reel(0, 20, 2.0, 0.5);
  double work = 0.0;
  double before = cord.energy(gravity).total();
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
  const double gained = cord.energy(gravity).total() - start;
  EXPECT_GT(gained, 20.0 * 9.81 * 1.0);
  EXPECT_NEAR(gained / work, 1.0, 0.02);
}

/// Start, turn and stop of a fast winch under a thousandfold load: what moves is never faster than the winch, and once
/// it stands the energy only falls.
TEST(CordReel, NoBurstWhenItStartsTurnsAndStops) {
  CordDef def = hanging(31, 3.0);
  Cord cord(def);
  cord.attach_mass(30, 300.0);
  double fastest = 0.0;
  CordReport report;
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
  // Falls at most as long as the winch lets it: 3 m/s up, and 3 m/s and g/3 s down.
  EXPECT_LT(fastest, 3.0 + 9.81 / 3.0 + 0.5);
  EXPECT_EQ(report.unconverged, 0);
  double last = cord.energy(gravity).total();
  for (int k = 0; k < 300; ++k) {
    cord.step(1.0 / 60.0, gravity);
    const double now = cord.energy(gravity).total();
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

TEST(CordReel, OfARopeThatBendsAndOfARibbon) {
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
    CordReport report;
    for (int k = 0; k < 600; ++k) report += cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(report.unconverged, 0);
    EXPECT_NEAR(cord.positions().back().y, -0.6, 5e-3) << def.rows;
  }
}

/// Reeling a part again and again leaves no link without length.
TEST(CordReel, NoLinkIsEverWithoutLength) {
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
  for (const Vec2 p : cord.positions()) EXPECT_TRUE(is_finite(p));
}

TEST(CordReel, RefusesWhatItCannotDo) {
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

// --- loads and driven points -----------------------------------------------------------------------------------------

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

TEST(CordOperated, FollowsTheHandAndKeepsItsVelocityWhenLetGo) {
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

/// A hand that pulls an inextensible cord further than it is long: nothing is infinite, and it says so by its length.
TEST(CordOperated, PulledTooFarItStaysFinite) {
  Cord cord(hanging(11, 1.0));
  for (int k = 1; k <= 60; ++k) {
    cord.operate(10, {0.1 * k, -1.0});
    cord.step(1.0 / 60.0, gravity);
    for (const Vec2 p : cord.positions()) ASSERT_TRUE(is_finite(p));
  }
  cord.release(10);
  for (int k = 0; k < 120; ++k) cord.step(1.0 / 60.0, gravity);
  double sum = 0.0;
  for (std::size_t p = 1; p < 11; ++p) sum += length(cord.positions()[p] - cord.positions()[p - 1]);
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

/// A pin that arrives and stands still by itself: the step after begins anew, as if it had been told.
TEST(CordOperated, APinThatStopsByItselfStopsTheCordSmoothly) {
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

TEST(CordLoad, ItsPotentialIsTheWorkItHasDone) {
  Cord cord(hanging(3, 1.0));
  const double before = cord.energy({}).potential;
  cord.set_load(2, {3.0, -4.0});
  EXPECT_EQ(before, 0.0);
  EXPECT_NEAR(cord.energy({}).potential, -(-4.0 * -1.0), 1e-12);
}

/// Velocities that are set jump, and with them the damping tensions: the elastic energy does not.
TEST(CordDamping, ElasticEnergyIsThatOfThePositionsWhateverVelocityIsSet) {
  CordDef ribbon;
  ribbon.points = 21;
  ribbon.rows = 3;
  ribbon.length = 2.0;
  ribbon.width = 0.1;
  solid(1e6, 0.2, 0.01, 0.1).apply_to(ribbon);
  ribbon.bending_stiffness *= 0.5;  // so that it has a spine
  ribbon.pins = {0, 1, 2};
  CordDef rope = hanging(21, 2.0);
  rope.stretch_stiffness = 1e5;
  CordDef bending = rope;
  bending.bending_stiffness = 1e-3;
  for (CordDef def : {ribbon, rope, bending}) {
    def.damping = 0.01;
    Cord cord(def);
    for (int k = 0; k < 30; ++k) cord.step(1.0 / 60.0, gravity);
    const double before = cord.energy(gravity).elastic;
    const Cord::State state = cord.save();
    cord.set_velocity(cord.size() - 1, {50.0, 30.0});
    EXPECT_NEAR(cord.energy(gravity).elastic, before, 1e-9 * (1.0 + before)) << def.rows;
    cord.set_velocity(cord.size() - 1, state.velocities.back());
    Cord other(def);
    other.restore(state);
    cord.step(1.0 / 60.0, gravity);
    other.step(1.0 / 60.0, gravity);
    EXPECT_NEAR(length(cord.positions().back() - other.positions().back()), 0.0, 5e-4) << def.rows;
  }
}

/// Implicit Euler goes along chords. If what a bar of a spinning rope gains by them were damped, it would be held back
/// and shorter from step to step, where what spins is longer: by μω²L²/12/EA, 0.8 % at the start.
TEST(CordDamping, ImplicitEulerDoesNotShortenWhatTurns) {
  for (const double bending : {0.0, 1e-3}) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.mass_per_length = 1.0;
    def.stretch_stiffness = 1e3;
    def.bending_stiffness = bending;
    def.damping = 0.05;
    def.accuracy = Accuracy::fast();
    Cord cord(def);
    for (int i = 0; i < 11; ++i) cord.set_velocity(i, {0.0, i - 5.0});
    for (int k = 0; k < 60; ++k) {
      cord.step(1.0 / 60.0, {});
      double elastic = 0.0;
      for (std::size_t i = 0; i < 10; ++i) {
        const double stretch = length(cord.positions()[i + 1] - cord.positions()[i]) - 0.1;
        elastic += 0.5 * 1e4 * stretch * stretch;
        ASSERT_GT(stretch, 0.0) << "link " << i << ", tick " << k;
      }
      ASSERT_NEAR(cord.energy({}).elastic, elastic, 0.01 * elastic) << "tick " << k;
    }
    EXPECT_NEAR(length(cord.positions()[10] - cord.positions()[0]), 1.002, 1e-3);
  }
}

/// The same of the cells of a ribbon, whose bars are the sums of their edges.
TEST(CordDamping, ImplicitEulerDoesNotShortenARibbonThatTurns) {
  for (const int rows : {2, 3}) {
    CordDef def;
    def.points = 11;
    def.rows = rows;
    def.length = 1.0;
    def.width = 0.1;
    def.mass_per_length = 1.0;
    def.stretch_stiffness = 1e3;
    def.bending_stiffness = 1e-2;
    def.damping = 0.05;
    def.accuracy = Accuracy::fast();
    Cord cord(def);
    const Vec2 middle = 0.5 * (cord.positions().front() + cord.positions().back());
    for (int p = 0; p < 11 * rows; ++p) {
      cord.set_velocity(p, 10.0 * perp(cord.positions()[static_cast<std::size_t>(p)] - middle));
    }
    double before = cord.energy({}).total();
    for (int k = 0; k < 60; ++k) {
      cord.step(1.0 / 60.0, {});
      const double now = cord.energy({}).total();
      ASSERT_LE(now, (1.0 + 1e-9) * before) << rows << " rows, tick " << k;
      before = now;
    }
    // It is longer by what its spin pulls at it, and turns still.
    const double length_now = length(cord.positions().back() - cord.positions()[static_cast<std::size_t>(rows - 1)]);
    EXPECT_GT(length_now, 1.0) << rows << " rows";
    EXPECT_LT(length_now, 1.01) << rows << " rows";
  }
}

/// A short circle of steps that gained energy: strong damping, and a motion that turns links by half a radian a step.
TEST(CordDamping, ALivelyRopeConverges) {
  CordDef def;
  def.points = 13;
  def.length = 0.6;
  def.mass_per_length = 0.5;
  def.stretch_stiffness = 1e3;
  def.damping = 0.05;
  CordReport report;
  for (unsigned seed = 0; seed < 5; ++seed) {
    std::mt19937 random(seed);
    const auto dice = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    def.positions.clear();
    for (int i = 0; i < 13; ++i) {
      const double x = 0.6 * dice();
      def.positions.push_back({x, 0.6 * dice()});
    }
    Cord cord(def);
    for (int k = 0; k < 60; ++k) report += cord.step(1.0 / 60.0, {});
  }
  EXPECT_EQ(report.unconverged, 0);
}

// --- tension only ----------------------------------------------------------------------------------------------------

TEST(CordTensionOnly, NeverPushes) {
  for (const double stiffness : {infinity, 1e5}) {
    for (const double bending : {0.0, 1e-4}) {
      CordDef def = hanging(21, 2.0);
      def.stretch_stiffness = stiffness;
      def.bending_stiffness = bending;
      def.tension_only = true;
      def.accuracy.tolerance = 1e-9;  // what a link may push is that much times its points' inertia
      Cord cord(def);
      for (int p = 1; p <= 20; ++p) cord.set_velocity(p, {0.3, 6.0});  // thrown upwards, past the pin
      CordReport report;
      double shortest = 2.0;
      for (int k = 0; k < 180; ++k) {
        report += cord.step(1.0 / 60.0, gravity);
        double sum = 0.0;
        for (std::size_t p = 1; p <= 20; ++p) sum += length(cord.positions()[p] - cord.positions()[p - 1]);
        shortest = std::min(shortest, sum);
        EXPECT_LE(sum, 2.0 * (1.0 + 2e-3));
        for (const double tension : cord.tensions()) EXPECT_GE(tension, -1e-6);
      }
      EXPECT_EQ(report.unconverged, 0);
      EXPECT_LT(shortest, 1.95) << "its links give way to a push";
    }
  }
}

TEST(CordTensionOnly, HangsAsAnyOther) {
  CordDef def = hanging(21, 2.0);
  def.tension_only = true;
  def.pins = {0, 20};
  for (int p = 0; p <= 20; ++p)
    def.positions[static_cast<std::size_t>(p)] = {1.5 * p / 20.0, -0.6 * (1.0 - std::abs(p / 10.0 - 1.0))};
  CordDef both = def;
  both.tension_only = false;
  Cord pulling(def);
  Cord bars(both);
  for (int k = 0; k < 3000; ++k) {
    pulling.step(1.0, gravity);
    bars.step(1.0, gravity);
  }
  for (std::size_t p = 0; p <= 20; ++p) EXPECT_NEAR(length(pulling.positions()[p] - bars.positions()[p]), 0.0, 1e-6);
}

/// In short steps a Newton step that takes all links for slack moves them by less than any tolerance: it must not be
/// the last for that.
TEST(CordTensionOnly, HangsStillInShortSteps) {
  for (const double stiffness : {infinity, 1e9}) {
    for (const double bending : {0.0, 0.5}) {
      for (const int substeps : {1, 64, 256, 1024}) {
        CordDef def = hanging(41, 8.0);
        def.stretch_stiffness = stiffness;
        def.bending_stiffness = bending;
        def.tension_only = true;
        def.accuracy = {Integrator::tr_bdf2, substeps, 8, 1e-7};
        Cord cord(def);
        const std::vector<Vec2> start(cord.positions().begin(), cord.positions().end());
        CordReport report;
        for (int k = 0; k < 20; ++k) report += cord.step(1.0 / 60.0, gravity);
        for (std::size_t p = 0; p < start.size(); ++p) {
          EXPECT_LE(length(cord.positions()[p] - start[p]), stiffness < infinity ? 1e-6 : 1e-10) << substeps;
        }
        for (const double tension : cord.tensions()) EXPECT_GT(tension, 0.0);
        EXPECT_EQ(report.searches + report.unconverged, 0);
        EXPECT_LE(report.iterations, 1.2 * report.stages);
      }
    }
  }
}

/// Who catches a rope on the way up goes on up, however short the steps; links that push would stop him.
TEST(CordTensionOnly, DoesNotStopWhoCatchesItRising) {
  for (const int substeps : {1, 8, 64}) {
    CordDef def = hanging(41, 8.0);
    def.tension_only = true;
    def.accuracy.substeps = substeps;
    Cord cord(def);
    std::vector<RigidBody> bodies(1);
    bodies[0].position = cord.positions()[30];
    bodies[0].velocity = {6.0, 2.2};
    bodies[0].inverse_mass = 1.0 / 60.0;
    bodies[0].acceleration = gravity;
    std::vector<Grip> grips(1);
    grips[0].point = 30;
    EXPECT_EQ(cord.step(1.0 / 60.0, gravity, {bodies, {}, grips}).unconverged, 0);
    EXPECT_NEAR(bodies[0].velocity.y + bodies[0].impulse.y / 60.0, 2.2, 0.05) << substeps;  // its owner adds gravity
    EXPECT_NEAR(bodies[0].velocity.x + bodies[0].impulse.x / 60.0, 6.0, 0.1) << substeps;
  }
}

// --- accuracy that changes on the way
// ---------------------------------------------------------------------------------

TEST(CordAccuracy, ChangedBetweenStepsItHoldsFromTheNextOn) {
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
    const CordReport report = changed.step(1.0 / 60.0, gravity);
    EXPECT_EQ(report.stages, 32);
    EXPECT_TRUE(report == other.step(1.0 / 60.0, gravity));
  }
  EXPECT_TRUE(changed.save() == other.save());
  changed.set_accuracy(Accuracy::fast());
  EXPECT_EQ(changed.step(1.0 / 60.0, gravity).stages, 1);
  EXPECT_THROW(changed.set_accuracy({Integrator::tr_bdf2, 0, 8, 1e-7}), DefinitionError);
  EXPECT_TRUE(changed.def().accuracy == Accuracy::fast());
}

// --- what is not declared is not there -------------------------------------------------------------------------------

TEST(CordSameBits, AFullyLoadedStateComesBackWithEverything) {
  CordDef def;
  def.points = 12;
  def.rows = 3;
  def.length = 1.1;
  def.width = 0.2;
  solid(1e5, 0.1, 0.1, 0.2).apply_to(def);
  def.area_stiffness = 1.0;
  def.damping = 0.01;
  def.drag = 0.1;
  def.pins = {0, 1};
  for (int p = 0; p < 36; ++p) def.positions.push_back({0.3 * std::sin(5.0 * p), 0.3 * std::cos(7.0 * p)});
  Cord cord(def);
  cord.attach_mass(34, 2.0);
  cord.set_load(20, {0.0, 1.0});
  cord.reel(2, 9, 0.4, 0.3);
  for (int k = 0; k < 60; ++k) {
    const Cord::State state = cord.save();
    cord.step(1.0 / 60.0, gravity);
    Cord other(def);
    other.restore(state);
    EXPECT_EQ(other.save(), state);
    other.step(1.0 / 60.0, gravity);
    ASSERT_EQ(other.save(), cord.save()) << "tick " << k;
  }
  Cord::State bad = cord.save();
  bad.unlocked.pop_back();
  EXPECT_THROW(cord.restore(bad), DefinitionError);
  const auto refused = [&](const auto& spoil) {
    Cord::State spoilt = cord.save();
    spoil(spoilt);
    EXPECT_THROW(cord.restore(spoilt), DefinitionError);
  };
  refused([](Cord::State& s) { s.rest_speeds.clear(); });
  refused([](Cord::State& s) { s.positions[3].x = nan; });
  refused([](Cord::State& s) { s.velocities[3].y = infinity; });
  refused([](Cord::State& s) { s.masses[0] = -1.0; });
  refused([](Cord::State& s) { s.rest[2] = 0.0; });
  refused([](Cord::State& s) { s.rest_targets[2] = -1.0; });
  refused([](Cord::State& s) { s.kinds[1] = static_cast<PointKind>(77); });
  refused([](Cord::State& s) { s.tensions[0] = nan; });
  refused([](Cord::State& s) { s.regainable_energy = nan; });
  refused([](Cord::State& s) { s.energy_drift = nan; });
  refused([](Cord::State& s) { s.holders.push_back({99, {}, 0.0, {}, 0.0, 0, {}, 0.0}); });
  refused([](Cord::State& s) { s.holders.push_back({0, {}, nan, {}, 0.0, 0, {}, 0.0}); });
  refused([](Cord::State& s) { s.holders.push_back({0, {}, 0.0, {}, 0.0, 0, {nan, 0.0}, 0.0}); });
  refused([](Cord::State& s) {
    s.touches.emplace_back();
    s.touches.back().stuck = infinity;
  });
}

#if defined(__SSE2__)
/// Numbers below 1e-308 are slow to compute with. A disturbance that dies away along 5,000 links must not become one;
/// the processor's own flag tells whether any was met.
TEST(CordDust, ADisturbanceThatDiesAwayLeavesNoSubnormalNumbers) {
  constexpr unsigned met_subnormal = 0x12;  // as an operand, as a result
  Cord cord(hanging(5001, 1000.0));
  cord.attach_mass(5000, 100.0);
  cord.set_velocity(5000, {5.0, 0.0});
  for (int k = 0; k < 20; ++k) {
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() & ~met_subnormal);
    cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(__builtin_ia32_stmxcsr() & met_subnormal, 0U) << "tick " << k;
  }
}
#endif

/// FNV-1a over the bits of all positions and velocities.
std::uint64_t bits_of(const Cord& cord) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const auto points : {cord.positions(), cord.velocities()}) {
    for (const Vec2 p : points) {
      for (const double value : {p.x, p.y}) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ULL;
      }
    }
  }
  return hash;
}

/// On any compiler at any optimisation. A change of the method changes these: take over what the test prints.
TEST(CordSameBits, OnEveryCompiler) {
  CordDef rope = hanging(31, 3.0);
  rope.damping = 0.001;
  rope.stretch_stiffness = 1e6;
  CordDef bending = hanging(31, 3.0);
  bending.bending_stiffness = 0.01;
  bending.tension_only = true;
  CordDef ribbon;
  ribbon.points = 12;
  ribbon.rows = 3;
  ribbon.length = 1.1;
  ribbon.width = 0.2;
  solid(1e5, 0.1, 0.1, 0.2).apply_to(ribbon);
  ribbon.bending_stiffness *= 0.5;
  ribbon.area_stiffness = 1.0;
  ribbon.pins = {0};
  for (int p = 0; p < 36; ++p) ribbon.positions.push_back({0.05 * ((7 * p) % 11), 0.05 * ((5 * p) % 13)});
  struct Golden {
    CordDef def;
    std::uint64_t bits;
  };
  for (const auto& [def, bits] : {Golden{rope, 1797113379212260073U}, Golden{bending, 3579113854357751420U},
                                  Golden{ribbon, 12193571052792361413U}}) {
    Cord cord(def);
    cord.attach_mass(cord.size() - 1, 5.0);
    for (int p = 1; p < cord.size(); ++p) cord.set_velocity(p, {0.1 * p, 0.3});
    cord.reel(2, 9, 0.9 * def.length * 7 / (def.points - 1), 0.3);
    for (int k = 0; k < 300; ++k) cord.step(1.0 / 60.0, gravity);
    EXPECT_EQ(bits_of(cord), bits);
  }
}

}  // namespace
}  // namespace ribbon
