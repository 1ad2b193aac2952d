#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

#include "ribbon/cord.h"
#include "tests/support/constants.h"
#include "tests/support/hanging.h"

// The bits of a cord's state: after save and restore, and with every compiler.

namespace ribbon {
namespace {

using constants::gravity;
using constants::infinity;
using constants::nan;
using test_support::hanging;

TEST(CordSameBits, AStateWithAllFieldsIsRestoredCompletely) {
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
  refused([](Cord::State& s) { s.accelerations.back().y = -infinity; });
  refused([](Cord::State& s) { s.masses[0] = -1.0; });
  refused([](Cord::State& s) { s.masses.back() = nan; });
  refused([](Cord::State& s) { s.rest[2] = 0.0; });
  refused([](Cord::State& s) { s.rest_targets[2] = -1.0; });
  refused([](Cord::State& s) { s.kinds[1] = static_cast<PointKind>(77); });
  refused([](Cord::State& s) { s.tensions[0] = nan; });
  for (const double share : {0.0, 1.5, nan}) refused([share](Cord::State& s) { s.depenetration_share = share; });
  for (const int pause : {-1, 17}) refused([pause](Cord::State& s) { s.newton_pause = pause; });
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
/// Arithmetic with numbers below 1e-308 is slow. A disturbance that decays along 5,000 links must not produce one. The
/// processor's flag reports whether one occurred.
TEST(CordSubnormals, ADecayingDisturbanceLeavesNone) {
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

/// The same bits with any compiler and optimisation. A change of the method changes them; then copy what the test
/// prints.
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
