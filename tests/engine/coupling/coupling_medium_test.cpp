#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "engine/replay/solver_step.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/box2d/step_watcher.h"
#include "ribbon/direct_solver.h"
#include "ribbon/weather.h"
#include "tests/engine/coupling/blown_world.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/same_motion.h"
#include "tests/support/allocations.h"
#include "tests/support/dice.h"

// Coupling::set_medium.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Weather;
using ribbon::WeatherDef;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using test_support::Dice;

std::uint64_t hash_of(const Coupling::State& state) {
  ribbon::box2d::Hasher hasher;
  add_to(hasher, state);
  return hasher.value();
}

TEST(CouplingMedium, BlowsOnCordsThatFeelIt) {
  Blown scene;
  const CordId rope = scene.coupling.add(Cord(feeling(hanging())));
  const CordId numb = scene.coupling.add(Cord(hanging(50.0)));
  scene.tick(120);
  EXPECT_GT(scene.coupling.cord(rope).positions()[20].x, 0.2);
  for (const Vec2 x : scene.coupling.cord(numb).positions()) EXPECT_NEAR(x.x, 50.0, 1e-9);
}

TEST(CouplingMedium, CountsItsTimeOnlyWhileThereIsOne) {
  GripWorld scene;
  scene.coupling.add(Cord(feeling(hanging())));
  scene.tick(10);
  EXPECT_EQ(scene.coupling.last_step().medium_time(), 0.0);
  const Weather still{WeatherDef{}};
  scene.coupling.set_medium(&still);
  scene.tick(60);
  EXPECT_NEAR(scene.coupling.last_step().medium_time(), 1.0, 1e-12);
  scene.coupling.set_medium(nullptr);
  scene.tick(10);
  EXPECT_NEAR(scene.coupling.last_step().medium_time(), 1.0, 1e-12);
  EXPECT_TRUE(scene.coupling.cord(0).direct().save().medium_forces.empty());
}

/// Without a cord that feels it, nothing but the time differs.
TEST(CouplingMedium, ChangesNoBitOfWhatDoesNotFeelIt) {
  const auto run = [](bool blown) {
    GripWorld scene;
    const Weather weather(gusts_over_water());
    if (blown) scene.coupling.set_medium(&weather);
    const CordId rope = scene.coupling.add(Cord(hanging()));
    scene.coupling.hold(*scene.add_body({0.0, -10.0}, 5.0), {.cord = rope, .arc = 10.0});
    scene.coupling.cord(rope).direct().set_velocity(20, {3.0, 0.0});
    scene.tick(60);
    Coupling::State state = scene.coupling.save(scene.world);
    state.medium_time = 0.0;
    return state;
  };
  EXPECT_EQ(run(true), run(false));
}

TEST(CouplingMedium, ItsTimeIsSavedRestoredAndHashed) {
  Blown scene;
  scene.coupling.add(Cord(feeling(hanging())));
  scene.tick(50);
  const Coupling::State saved = scene.coupling.save(scene.world);
  EXPECT_EQ(saved.medium_time, scene.coupling.last_step().medium_time());
  scene.tick(70);
  const Coupling::State first = scene.coupling.save(scene.world);
  scene.coupling.restore(saved, scene.world);
  EXPECT_EQ(scene.coupling.last_step().medium_time(), saved.medium_time);
  scene.tick(70);
  EXPECT_EQ(scene.coupling.save(scene.world), first);
  Coupling::State other = first;
  other.medium_time += 1e-9;
  EXPECT_NE(hash_of(other), hash_of(first));
  EXPECT_NE(other, first);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN(), 1e13}) {
    other.medium_time = bad;
    EXPECT_THROW(scene.coupling.restore(other, scene.world), ribbon::DefinitionError);
    EXPECT_EQ(scene.coupling.save(scene.world), first);
  }
}

/// Returns the momentum of a cord and a body along x, and the impulse of the medium on the cord, N·s.
struct Balance {
  double momentum = 0.0;
  double impulse = 0.0;
};
Balance balance_of(Blown& scene, CordId rope, const b2Body& body, double mass, int ticks) {
  const CordDef def = scene.coupling.cord(rope).direct().def();
  const double speed = scene.weather.def().wind.x;
  double before = 1.2 * def.drag_across * def.radius * def.length * speed * speed;  // N, of the cord at rest
  Balance balance;
  for (int k = 0; k < ticks; ++k) {
    scene.tick();
    double now = 0.0;
    for (const Vec2 force : scene.coupling.cord(rope).direct().save().medium_forces) now += force.x;
    balance.impulse += 0.5 * dt * (before + now);
    before = now;
  }
  balance.momentum = mass * scene.coupling.body(body).velocity().x;
  const Cord& cord = scene.coupling.cord(rope).direct();
  for (int p = 0; p < cord.size(); ++p) {
    balance.momentum += cord.mass(p) * cord.velocities()[static_cast<std::size_t>(p)].x;
  }
  return balance;
}

/// A free cord in a flow, across it.
CordDef adrift() {
  CordDef def = feeling(hanging());
  def.pins.clear();
  return def;
}

/// A body on a rope in a flow: the drag on the rope moves it, and momentum is exchanged with the medium only.
TEST(CouplingMedium, PullsABodyByItsCord) {
  WeatherDef def;
  def.wind = {20.0, 0.0};
  Blown scene(def);
  scene.world.SetGravity({0.0F, 0.0F});
  const CordId rope = scene.coupling.add(Cord(adrift()));
  b2Body* const load = scene.add_body({0.0, -10.0}, 0.5);
  scene.coupling.hold(*load, {.cord = rope, .arc = 10.0});
  const Balance balance = balance_of(scene, rope, *load, 0.5, 60);
  EXPECT_GT(balance.momentum, 1.0);
  EXPECT_NEAR(balance.momentum, balance.impulse, 0.005 * balance.momentum);
}

/// The same where the cord hits a body: an impact keeps the momentum but not that of the wind.
TEST(CouplingMedium, BlowsACordAgainstABody) {
  WeatherDef def;
  def.wind = {20.0, 0.0};
  Blown scene(def);
  scene.world.SetGravity({0.0F, 0.0F});
  const CordId rope = scene.coupling.add(Cord(adrift()));
  b2Body* const ball = scene.add_body({1.0, -5.0}, 0.5);
  const b2Filter meets_all;
  ball->GetFixtureList()->SetFilterData(meets_all);
  const Balance balance = balance_of(scene, rope, *ball, 0.5, 60);
  EXPECT_GT(ball->GetLinearVelocity().x, 1.0F);
  EXPECT_NEAR(balance.momentum, balance.impulse, 0.01 * balance.momentum);
}

/// Cords in wind that are tied, cut, held and lie on the ground, with several workers and with error estimates: the
/// same motion.
TEST(CouplingMedium, HasTheSameBitsWithWorkersAndWithEstimates) {
  expect_same_motion<Blown>([](Blown& scene) {
    for (int k = 0; k < 8; ++k) {
      CordDef def = feeling(hanging(3.0 * k));
      const CordId rope = scene.coupling.add(Cord(def));
      if (k % 2 == 0) scene.coupling.hold(*scene.add_body({3.0 * k, -10.0}, 1.0), {.cord = rope, .arc = 10.0});
      if (k == 3) scene.coupling.tie({2, 25, rope, 25});
    }
    for (int k = 0; k < 60; ++k) {
      if (k == 20) scene.coupling.cut({-1.0, -3.0}, {30.0, -3.2});
      scene.tick();
    }
  });
}

TEST(CouplingMedium, AllocatesNothingInASteadyTick) {
  Blown scene;
  const CordId rope = scene.coupling.add(Cord(feeling(hanging())));
  scene.coupling.hold(*scene.add_body({0.0, -10.0}, 5.0), {.cord = rope, .arc = 10.0});
  scene.coupling.add(Cord(feeling(hanging(20.0))));
  scene.tick(5);
  const test_support::AllocationCount allocations;
  scene.tick(60);
  EXPECT_EQ(allocations.so_far(), 0);
}

/// A sleeping cord is asked for in each tick, so that a wind that begins wakes it.
TEST(CouplingMedium, WakesASleepingCord) {
  WeatherDef def;
  GripWorld scene;
  const Weather still(def);
  def.wind = {5.0, 0.0};
  const Weather blow(def);
  scene.coupling.set_medium(&still);
  CordDef rope = feeling(hanging());
  rope.drag = 2.0;
  rope.allow_sleep = true;
  scene.coupling.add(Cord(rope));
  scene.tick(120);
  ASSERT_TRUE(scene.coupling.cord(0).direct().is_asleep());
  scene.coupling.set_medium(&blow);
  scene.tick(30);
  EXPECT_FALSE(scene.coupling.cord(0).direct().is_asleep());
  EXPECT_GT(scene.coupling.cord(0).positions()[50].x, 0.05);
}

/// A cord that wind drives finds what it is driven against.
TEST(CouplingMedium, BlowsACordAgainstAWall) {
  WeatherDef def;
  def.wind = {60.0, 0.0};
  Blown scene(def);
  scene.world.SetGravity({0.0F, 0.0F});
  b2BodyDef wall;
  b2EdgeShape edge;
  edge.SetTwoSided({2.0F, -20.0F}, {2.0F, 20.0F});
  scene.world.CreateBody(&wall)->CreateFixture(&edge, 0.0F);
  for (const double mass : {0.1, 1e-3}) {
    CordDef rope = feeling(hanging());
    rope.mass_per_length = mass;
    rope.pins.clear();
    scene.coupling.add(Cord(rope));
  }
  bool touched = false;
  for (int k = 0; k < 240; ++k) {
    scene.tick();
    for (const CordId cord : scene.coupling.cords()) {
      for (const Vec2 x : scene.coupling.cord(cord).positions()) ASSERT_LT(x.x, 2.0);
      touched = touched || !scene.coupling.cord(cord).direct().touches().empty();
    }
    ASSERT_EQ(scene.coupling.last_step().report().unconverged, 0) << k;
  }
  EXPECT_TRUE(touched);
}

/// Random cords in random weather, with grips, ties, cuts, contacts and sleep: all ticks are bounded and finite, and
/// going back repeats them.
struct Mess : GripWorld {
  explicit Mess(unsigned seed) : dice(seed), weather(random_weather()) {
    coupling.set_medium(&weather);
    b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-30.0F, -4.0F}, {30.0F, -4.5F});
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = 0.5F;
    world.CreateBody(&ground)->CreateFixture(&fixture);
    for (int k = 0; k < 4; ++k) add_cord(k);
    if (dice.coin()) coupling.tie({0, 5, 1, 5});
  }
  WeatherDef random_weather() {
    WeatherDef def;
    def.wind = {dice(-30.0, 30.0), dice(-5.0, 5.0)};
    def.gusts = dice();
    if (dice.coin()) def.water_level = dice(-5.0, 2.0);
    def.current = {dice(-2.0, 2.0), 0.0};
    return def;
  }
  void add_cord(int k) {
    CordDef def;
    def.points = 11;
    def.length = 2.0;
    def.radius = 0.02;
    def.mass_per_length = std::pow(10.0, dice(-1.5, 0.0));
    def.friction = 0.5;
    def.cord_contact = dice.coin();
    def.allow_sleep = dice.coin();
    def.drag = dice.coin() ? 1.0 : 0.0;
    if (dice.coin()) def.accuracy = Accuracy::fast();
    if (k == 3) {
      def.rows = 3;
      def.width = 0.3;
      def.stretch_stiffness = 1e4;
      def.bending_stiffness = 1.0;
    } else if (dice.coin()) {
      def.bending_stiffness = 0.1;
    }
    def = feeling(def);
    def.positions.clear();
    const Vec2 start{dice(-2.0, 2.0), dice(-1.0, 1.0)};
    for (int i = 0; i < def.points; ++i)
      for (int j = 0; j < def.rows; ++j) def.positions.push_back(start + Vec2{0.2 * i, 0.15 * j});
    if (dice.coin()) def.pins = {0};
    const CordId cord = coupling.add(Cord(def));
    if (dice.coin()) coupling.hold(*add_body(def.positions.back(), dice(0.1, 2.0)), {.cord = cord, .arc = 2.0});
  }
  void step() {
    if (dice() < 0.03) {
      const double x = dice(-3.0, 3.0);
      coupling.cut({x, -4.0}, {x + 0.3, 4.0});
    }
    tick();
  }
  Dice dice;
  Weather weather;
};

TEST(CouplingMedium, AnySceneIsSolvedAndCanGoBack) {
  int unconverged = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Mess mess(seed);
    for (int k = 0; k < 150; ++k) {
      mess.step();
      unconverged += mess.coupling.last_step().report().unconverged;
      for (const CordId cord : mess.coupling.cords()) {
        for (const Vec2 x : mess.coupling.cord(cord).positions()) {
          ASSERT_TRUE(is_finite(x)) << seed << ' ' << k;
          ASSERT_LT(length(x), 1e3) << seed << ' ' << k;
        }
        for (const Vec2 v : mess.coupling.cord(cord).direct().velocities())
          ASSERT_LT(length(v), 500.0) << seed << ' ' << k;
      }
    }
    const Coupling::State state = mess.coupling.save(mess.world);
    Mess same(seed);
    for (int k = 0; k < 150; ++k) same.step();
    ASSERT_EQ(same.coupling.save(same.world), state) << seed;
  }
  EXPECT_LE(unconverged, 60) << "of 6000 ticks; in calm air it is 50, in the same three scenes";
}

}  // namespace
}  // namespace engine
