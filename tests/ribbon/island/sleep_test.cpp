#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/cord_forces.h"
#include "ribbon/direct_solver.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"

// CordDef::allow_sleep: what falls asleep, what that changes, and what wakes it.

namespace ribbon {
namespace {

using constants::dt;
using constants::gravity;
constexpr int drowsy = 34;  // steps after which a cord at rest sleeps

CordDef rope_def(bool allow_sleep = true) {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.radius = 0.02;
  def.drag = 2.0;
  def.bending_stiffness = 0.05;
  def.damping = 0.05;
  def.stretch_stiffness = 1000.0;
  def.friction = 0.5;
  def.pins = {0};
  def.allow_sleep = allow_sleep;
  return def;
}

/// A cord that is released from a slope.
Cord sloping_rope(bool allow_sleep = true) {
  CordDef def = rope_def(allow_sleep);
  for (int p = 0; p < def.points; ++p) def.positions.push_back({0.03 * p, -std::sqrt(0.01 - 0.0009) * p});
  return Cord(def);
}

/// The surroundings of a cord: one circle of a body, a segment of it, and its grip, as far as requested.
struct Near {
  RigidBody body;
  std::array<RigidCircle, 1> circle{{{0, {}, 0.1, 0.5, 0.0, 1}}};
  std::array<RigidSegment, 1> segment{{{0, {-1.0, 0.0}, {1.0, 0.0}, 0.0, 0.5, 0.0, 2}}};
  std::array<Grip, 1> grip{{{20, 0, {}}}};
  bool has_circle = false;
  bool has_segment = false;
  bool has_grip = false;

  IslandReport step(Cord& cord, Vec2 g = gravity) {
    Surroundings surroundings;
    surroundings.bodies = {&body, 1};
    if (has_circle) surroundings.circles = circle;
    if (has_segment) surroundings.segments = segment;
    if (has_grip) surroundings.grips = grip;
    return cord.step(dt, g, surroundings);
  }
  bool sleeps_in(Cord& cord, int most) {
    for (int k = 0; k < most && !cord.is_asleep(); ++k) step(cord);
    return cord.is_asleep() && step(cord).stages == 0;
  }
};

std::vector<Vec2> points_of(const Cord& cord) { return {cord.positions().begin(), cord.positions().end()}; }

TEST(CordSleep, StartsAfterHalfASecondOfRestAndCostsNothing) {
  Cord cord = sloping_rope();
  Near nothing;
  double slow = 0.0;
  while (!cord.is_asleep()) {
    const IslandReport report = nothing.step(cord);
    ASSERT_EQ(report.stages == 0, slow >= Cord::time_to_sleep);
    ASSERT_EQ(report.stages == 0, cord.is_asleep());
    const bool is_slow =
        std::all_of(cord.velocities().begin(), cord.velocities().end(), [](Vec2 v) { return length(v) < 0.01; });
    slow = is_slow ? slow + dt : 0.0;
  }
  const std::vector<Vec2> before = points_of(cord);
  const double elastic = energy_of(cord, {}).elastic;
  const test_support::AllocationCount allocations;
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(nothing.step(cord), IslandReport{});
  EXPECT_EQ(allocations.so_far(), 0);
  EXPECT_EQ(points_of(cord), before);
  EXPECT_NEAR(energy_of(cord, {}).elastic, elastic, 1e-12 * elastic);
  for (const Vec2 v : cord.velocities()) EXPECT_EQ(v, Vec2{});
}

TEST(CordSleep, HappensOnlyIfDeclared) {
  Cord cord = sloping_rope(false);
  Near nothing;
  for (int k = 0; k < 3000; ++k) ASSERT_GT(nothing.step(cord).stages, 0);
  EXPECT_FALSE(cord.is_asleep());
  EXPECT_EQ(cord.save().rest_time, 0.0);
}

/// Sleep cancels the remaining motion, at most the amplitude of a swing of 1 cm/s in the slowest mode of a hanging
/// chain: ω = 2.4048/2·√(g/L), with the first zero of J₀.
TEST(CordSleep, StopsTheCordNearItsEquilibrium) {
  Cord sleeping = sloping_rope();
  Cord waking = sloping_rope(false);
  Near nothing;
  ASSERT_TRUE(nothing.sleeps_in(sleeping, 6000));
  for (int k = 0; k < 6000; ++k) nothing.step(waking);
  double furthest = 0.0;
  for (std::size_t p = 0; p < 21; ++p) {
    furthest = std::max(furthest, length(sleeping.positions()[p] - waking.positions()[p]));
  }
  EXPECT_LT(furthest, 0.01 / (0.5 * 2.4048 * std::sqrt(9.81 / 2.0)));
  RecordProperty("furthest_mm", std::to_string(1e3 * furthest));
}

TEST(CordSleep, EndsWithAnyChangeOfTheCord) {
  const std::vector<std::pair<const char*, std::function<void(Cord&)>>> changes = {
      {"attach_mass", [](Cord& cord) { cord.attach_mass(20, 1.0); }},
      {"set_load",
       [](Cord& cord) {
         cord.set_load(20, {1.0, 0.0});
       }},
      {"constrain",
       [](Cord& cord) {
         cord.constrain(20, {0.1, -1.9});
       }},
      {"operate",
       [](Cord& cord) {
         cord.operate(20, {0.1, -1.9});
       }},
      {"release", [](Cord& cord) { cord.release(0); }},
      {"set_velocity",
       [](Cord& cord) {
         cord.set_velocity(20, {1.0, 0.0});
       }},
      {"reel", [](Cord& cord) { cord.reel(0, 20, 1.5, 0.001); }},
      {"wake", [](Cord& cord) { cord.wake(); }},
  };
  for (const auto& [name, change] : changes) {
    SCOPED_TRACE(name);
    Cord cord = sloping_rope();
    Near nothing;
    ASSERT_TRUE(nothing.sleeps_in(cord, 6000));
    change(cord);
    EXPECT_FALSE(cord.is_asleep());
    EXPECT_GT(nothing.step(cord).stages, 0);
  }
}

TEST(CordSleep, DoesNotStartDuringSlowReeling) {
  Cord cord = sloping_rope();
  Near nothing;
  ASSERT_TRUE(nothing.sleeps_in(cord, 6000));
  cord.reel(0, 20, 1.99, 0.005);  // slower than the sleep threshold, for two seconds
  for (int k = 0; k < 119; ++k) ASSERT_GT(nothing.step(cord).stages, 0);
  EXPECT_TRUE(nothing.sleeps_in(cord, 2 * drowsy + 5));
}

TEST(CordSleep, EndsWithAChangeOfTheSurroundings) {
  const auto still = [](Near& near) {
    near.body.position = {0.5, -1.0};
    near.has_circle = near.has_segment = true;
  };
  const std::vector<std::pair<const char*, std::function<void(Near&)>>> changes = {
      {"somewhere else", [](Near& near) { near.body.position.x += 1e-9; }},
      {"another circle", [](Near& near) { near.circle[0].radius *= 2.0; }},
      {"turned", [](Near& near) { near.segment[0].b.y = 0.1; }},
      {"gone", [](Near& near) { near.has_circle = false; }},
      {"smooth", [](Near& near) { near.circle[0].friction = 0.0; }},
      {"moves",
       [](Near& near) {
         near.body.velocity = {1e-9, 0.0};
       }},
      {"turns", [](Near& near) { near.body.angular_velocity = 1e-9; }},
      {"can be pushed", [](Near& near) { near.body.inverse_mass = 1.0; }},
      {"holds it", [](Near& near) { near.has_grip = true; }},
  };
  for (const auto& [name, change] : changes) {
    SCOPED_TRACE(name);
    Cord cord = sloping_rope();
    Near near;
    still(near);
    ASSERT_TRUE(near.sleeps_in(cord, 6000));
    change(near);
    EXPECT_GT(near.step(cord).stages, 0);
    EXPECT_FALSE(cord.is_asleep());
  }
  Cord cord = sloping_rope();
  Near near;
  ASSERT_TRUE(near.sleeps_in(cord, 6000));
  EXPECT_GT(near.step(cord, {0.0, -9.8}).stages, 0) << "gravity";
}

/// A dynamic body at rest sleeps with the cord if its owner allows it; the result reports that.
TEST(CordSleep, IncludesADynamicBodyOnlyIfItMaySleep) {
  for (const bool holds : {true, false}) {
    for (const bool may_sleep : {true, false}) {
      Cord cord(rope_def());
      for (int k = 0; k < 3000; ++k) cord.step(dt, gravity);
      cord.wake();
      Near near;
      near.body.inverse_mass = 1e-9;
      near.body.may_sleep = may_sleep;
      near.has_grip = holds;
      near.has_circle = !holds;
      for (int k = 0; k < drowsy && !near.body.rests; ++k) {
        near.body.position = holds ? cord.positions()[20] : Vec2{0.5, -1.0};
        near.body.impulse = {};
        near.body.angular_impulse = 0.0;
        near.step(cord);
      }
      EXPECT_EQ(cord.is_asleep(), may_sleep);
      EXPECT_EQ(near.body.rests, may_sleep);
      if (!may_sleep) continue;
      near.body.awake = false;
      EXPECT_EQ(near.step(cord).stages, 0);
      near.body.awake = true;
      EXPECT_GT(near.step(cord).stages, 0) << "the other cord has woken it";
    }
  }
}

/// A body that another dynamic one supports sleeps with it and not before.
TEST(CordSleep, IncludesWhatSupportsItsBody) {
  Cord cord(rope_def());
  for (int k = 0; k < 3000; ++k) cord.step(dt, gravity);
  cord.wake();
  std::array<RigidBody, 2> bodies;
  for (RigidBody& body : bodies) {
    body.inverse_mass = 1e-9;
    body.may_sleep = true;
  }
  const std::array circles{RigidCircle{0, {}, 0.1, 0.5, 0.0, 1}};
  const std::array supports{Support{0, {0.0, -0.1}, {0.0, 1.0}, 0.0, 0.0, 1, {0.0, 0.1}}};
  Surroundings surroundings{bodies, circles};
  surroundings.supports = supports;
  const auto sleeps = [&](double speed) {
    for (int k = 0; k < 2 * drowsy && !bodies[0].rests; ++k) {
      bodies[0].position = {0.5, -1.0};
      bodies[1].position = {0.5, -1.2};
      for (RigidBody& body : bodies) body.impulse = {};
      bodies[1].velocity = {speed, 0.0};
      cord.step(dt, gravity, surroundings);
    }
    return cord.is_asleep();
  };
  EXPECT_FALSE(sleeps(0.5));
  EXPECT_TRUE(sleeps(0.0));
  EXPECT_TRUE(bodies[1].rests);
  for (RigidBody& body : bodies) body.awake = false;
  EXPECT_EQ(cord.step(dt, gravity, surroundings).stages, 0);
  bodies[1].awake = true;
  EXPECT_GT(cord.step(dt, gravity, surroundings).stages, 0);
}

TEST(CordSleep, HappensOnAStationaryHolder) {
  Cord cord(rope_def());
  Near near;
  near.body.position = cord.positions()[20];
  near.has_grip = true;
  EXPECT_TRUE(near.sleeps_in(cord, 6000));
  near.grip[0].travel = {1e-3, 0.0};
  EXPECT_GT(near.step(cord).stages, 0);
}

/// An island sleeps as a whole or not at all.
TEST(CordSleep, CordsThatAreNearEachOtherSleepAndWakeTogether) {
  CordDef def = rope_def();
  def.cord_contact = true;
  std::vector<Cord> cords;
  for (const double x : {0.0, 0.05, 50.0}) {
    def.positions.clear();
    def.positions = test_support::equally_spaced(def.points, {x, 0.0}, {0.0, -0.1});
    cords.emplace_back(def);
  }
  DirectSolver solver;
  std::vector<IslandCord> all;
  for (std::size_t k = 0; k < cords.size(); ++k) all.push_back({&cords[k], {}, 10 + k});
  std::vector<CordReport> reports(3);
  const auto step = [&] { solver.step(all, {}, dt, gravity, reports); };
  const auto stages = [&](std::size_t cord) {
    return solver.island_reports()[static_cast<std::size_t>(reports[cord].island)].stages;
  };
  for (int k = 0; k < 6000 && !(cords[0].is_asleep() && cords[2].is_asleep()); ++k) step();
  for (const Cord& cord : cords) ASSERT_TRUE(cord.is_asleep());
  cords[0].wake();
  step();
  EXPECT_GT(stages(0), 0);
  EXPECT_GT(stages(1), 0);
  EXPECT_EQ(stages(2), 0) << "far away";
}

TEST(CordSleep, IsSavedAndRestoredToTheSameBits) {
  Cord cord = sloping_rope();
  Near nothing;
  ASSERT_TRUE(nothing.sleeps_in(cord, 6000));
  const Cord::State asleep = cord.save();
  Cord twin = sloping_rope();
  twin.restore(asleep);
  EXPECT_TRUE(twin.is_asleep());
  EXPECT_EQ(nothing.step(twin).stages, 0);
  for (Cord* one : {&cord, &twin}) {
    one->set_velocity(20, {0.3, 0.0});
    for (int k = 0; k < 100; ++k) nothing.step(*one);
  }
  EXPECT_TRUE(cord.save() == twin.save());

  Cord::State spoilt = asleep;
  for (const double rested : {0.51, 0.49, -0.1, std::numeric_limits<double>::quiet_NaN()}) {
    spoilt.rest_time = rested;
    EXPECT_THROW(twin.restore(spoilt), DefinitionError) << rested;
  }
  Cord sleepless = sloping_rope(false);
  EXPECT_THROW(sleepless.restore(asleep), DefinitionError) << "one that does not declare it";
}

/// The time until sleep does not depend on the step size.
TEST(CordSleep, TakesTheSameTimeInShortSteps) {
  Cord cord(rope_def());
  for (int k = 0; k < 6000 && !cord.is_asleep(); ++k) cord.step(dt, gravity);
  ASSERT_TRUE(cord.is_asleep());
  cord.wake();
  int steps = 0;
  for (; !cord.is_asleep(); ++steps) cord.step(dt / 4.0, gravity);
  EXPECT_NEAR(steps * dt / 4.0, Cord::time_to_sleep, dt);
}

}  // namespace
}  // namespace ribbon
