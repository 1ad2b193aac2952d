#include "game/view/particles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "game/simulation/buttons.h"
#include "game/view/effects.h"
#include "tests/game/simulation/press.h"
#include "tests/support/constants.h"
#include "tests/support/level_for_two.h"

namespace game {
namespace {

using constants::dt;
using ribbon::Vec2;
constexpr Vec2 breeze{1.3, 0.0};

TEST(Particles, AreNeverMoreThanTheCapacityAndDisappear) {
  Particles particles;
  for (int k = 0; k < 200; ++k) {
    add_sparkle(particles, {1.0, 2.0}, {});
    add_dust(particles, {1.0, 2.0}, 1.0, {});
    add_leaf(particles, {1.0, 2.0}, {});
    particles.tick(dt, breeze);
    ASSERT_LE(particles.all().size(), Particles::max_count);
  }
  EXPECT_GT(particles.all().size(), Particles::max_count / 2);
  for (int k = 0; k < 60 * 12; ++k) particles.tick(dt, breeze);
  EXPECT_TRUE(particles.all().empty());
}

TEST(Particles, EqualCallsGiveEqualParticles) {
  Particles a;
  Particles b;
  for (int k = 0; k < 100; ++k) {
    for (Particles* particles : {&a, &b}) {
      if (k % 10 == 0) add_dust(*particles, {0.0, 0.0}, 0.5, {});
      particles->tick(dt, breeze);
    }
  }
  ASSERT_EQ(a.all().size(), b.all().size());
  for (std::size_t k = 0; k < a.all().size(); ++k) EXPECT_EQ(a.all()[k].at, b.all()[k].at);
}

TEST(Particles, StayNearWhereTheyBegan) {
  Particles particles;
  add_sparkle(particles, {0.0, 0.0}, {});
  add_dust(particles, {0.0, 0.0}, 1.0, {});
  while (!particles.all().empty()) {
    for (const Particle& p : particles.all()) ASSERT_LT(length(p.at), 8.0);
    particles.tick(dt, breeze);
  }
}

TEST(Particles, AFullPoolReplacesTheOldest) {
  Particles particles;
  Particle old;
  old.life = 0.1;
  particles.add(old);
  Particle young;
  young.life = 5.0;
  for (std::size_t k = 0; k < Particles::max_count; ++k) particles.add(young);
  for (const Particle& p : particles.all()) EXPECT_EQ(p.life, 5.0);
}

TEST(Particles, RandomNumbersFillTheirRange) {
  Particles particles;
  double low = 1.0;
  double high = -1.0;
  double sum = 0.0;
  for (int k = 0; k < 10000; ++k) {
    const double x = particles.random();
    low = std::min(low, x);
    high = std::max(high, x);
    sum += x;
  }
  EXPECT_NEAR(low, -1.0, 0.01);
  EXPECT_NEAR(high, 1.0, 0.01);
  EXPECT_NEAR(sum / 10000.0, 0.0, 0.03);
}

/// Paper flies up, then flutters down more slowly than it would fall.
TEST(Particles, ConfettiFliesUpAndFluttersDown) {
  Particles particles;
  add_confetti(particles, {0.0, 0.0}, {});
  EXPECT_EQ(particles.all().size(), 72U);
  double highest = 0.0;
  while (!particles.all().empty()) {
    for (const Particle& p : particles.all()) {
      highest = std::max(highest, p.at.y);
      ASSERT_LT(length(p.at), 8.0);
      ASSERT_GT(p.velocity.y, -4.0);
    }
    particles.tick(dt, breeze);
  }
  EXPECT_GT(highest, 1.0);
}

TEST(Particles, EachOfTwoPlayersThatRunsRaisesDust) {
  const Level level = test_support::level_for_two({.tied = false});
  for (const int runner : {0, 1}) {
    Simulation simulation(level);
    Effects effects(simulation);
    run(simulation, 20);
    effects.follow(palette(false, level.place), false);
    int dust = 0;
    for (int k = 0; k < 40; ++k) {
      run(simulation, 1, runner == 0 ? button_left : 0, runner == 1 ? button_left : 0);
      effects.follow(palette(false, level.place), false);
      for (const Particle& p : effects.particles().all()) {
        if (p.kind != Particle::Kind::dust) continue;
        ++dust;
        EXPECT_LT(length(p.at - simulation.player(runner).position()), 3.0);
      }
    }
    EXPECT_GT(dust, 0) << runner;
  }
}

}  // namespace
}  // namespace game
