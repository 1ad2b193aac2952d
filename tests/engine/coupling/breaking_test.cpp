#include <gtest/gtest.h>

#include "ribbon/cord_forces.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/loaded_rope.h"
#include "tests/engine/coupling/same_motion.h"
#include "tests/support/dice.h"
#include "tests/support/refusal.h"

// Links that break under their tension.

namespace engine {
namespace {

using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::CutEvent;
using ribbon::box2d::GripId;

TEST(ABreakingCord, BreaksWhereItIsLoadedMostOneLinkATick) {
  CordDef def = hanging();
  def.breaking_force = 36.0;  // 3.5 kg and half of the cord's 1 kg weigh 39 N, and 3 kg alone 29
  LoadedRope scene(def);
  int ticks = 0;
  while (scene.coupling.last_step().cut_events().empty() && ++ticks < 100) scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  const CutEvent event = scene.coupling.last_step().cut_events()[0];
  EXPECT_TRUE(event.broke);
  EXPECT_GT(event.tension, 36.0);
  EXPECT_NEAR(event.arc, 0.1, 1e-12) << "the middle of the first link";
  EXPECT_EQ(scene.coupling.size(), 2);
}

TEST(ABreakingCord, HoldsALoadBelowItsBreakingForce) {
  CordDef def = hanging();
  def.breaking_force = 46.0;  // it hangs with 44.1 N at the top
  LoadedRope scene(def);
  scene.tick(300);
  EXPECT_EQ(scene.coupling.size(), 1);
}

/// Over a fixed peg the tension rises by e^(μθ) to the heavier side: the cord breaks there.
TEST(ABreakingCord, OverAPegBreaksOnTheSideOfTheGreaterTension) {
  GripWorld scene;
  b2Body* peg = scene.add_body({0.0, 0.0}, 0.0, b2_staticBody);
  b2Filter all;
  peg->GetFixtureList()->SetFilterData(all);
  peg->GetFixtureList()->SetFriction(0.5F);
  CordDef def;
  def.points = 61;
  def.radius = 0.02;
  def.friction = 0.5;
  def.mass_per_length = 0.05;
  def.positions.clear();
  const double reach = 0.2 + def.radius;
  for (int i = 0; i < def.points; ++i) {
    const double s = 0.05 * (i - 30);
    const double quarter = 0.5 * std::numbers::pi * reach;
    if (s < -quarter) {
      def.positions.push_back({-reach, s + quarter});
    } else if (s > quarter) {
      def.positions.push_back({reach, quarter - s});
    } else {
      def.positions.push_back({reach * std::sin(s / reach), reach * std::cos(s / reach)});
    }
  }
  def.length = 3.0;
  const CordId rope = scene.coupling.add(Cord(def));
  const auto x = scene.coupling.cord(rope).positions();
  b2Body* light = scene.add_body(x[0], 1.0);
  b2Body* heavy = scene.add_body(x[60], 3.0);  // e^(0.5·π) is 4.8: it does not slip
  scene.coupling.hold(rope, 0, *light, {0.0F, 0.0F});
  scene.coupling.hold(rope, 60, *heavy, {0.0F, 0.0F});
  scene.tick(120);
  ASSERT_EQ(scene.coupling.size(), 1);
  Cord& cord = scene.coupling.cord(rope).direct();
  EXPECT_NEAR(cord.tensions()[5], g, 0.05 * g);
  EXPECT_NEAR(cord.tensions()[55], 3.0 * g, 0.05 * 3.0 * g);
  for (int link = 0; link < 60; ++link) cord.set_breaking_force(link, 2.0 * g);
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_GT(scene.coupling.last_step().cut_events()[0].arc, 1.7) << "beyond the peg, on the heavy side";
}

TEST(ABreakingCord, IsWokenWhenItIsWeakened) {
  LoadedRope scene(LoadedRope::sleepy());
  scene.fall_asleep();
  scene.coupling.cord(scene.rope).direct().set_breaking_force(30, 10.0);
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_NEAR(scene.coupling.last_step().cut_events()[0].arc, 6.1, 1e-9);
  scene.tick(30);
  EXPECT_LE(scene.load->GetPosition().y, -11.0);
}

/// Cords that touch each other and break, with several workers and with error estimates: the same motion.
TEST(ABreakingCord, HasTheSameBitsWithWorkersAndWithEstimates) {
  const Coupling::State end = expect_same_motion<GripWorld>([](GripWorld& scene) {
    for (int k = 0; k < 6; ++k) {
      CordDef def = hanging(0.03 * k);
      def.radius = 0.02;
      def.cord_contact = def.self_contact = true;
      def.breaking_force = 25.0 + k;
      const CordId rope = scene.coupling.add(Cord(def));
      scene.coupling.hold(*scene.add_body({0.03 * k, -10.0}, 1.0), {.cord = rope, .arc = 10.0});
    }
    for (int k = 0; k < 40; ++k) {
      if (k == 10) scene.coupling.cut({-1.0, -3.0}, {1.0, -3.2});
      if (k == 20) scene.world.SetGravity({0.0F, -90.0F});
      scene.tick();
    }
  });
  EXPECT_GT(end.next_cord, 6 + 12) << "all were cut, and some broke";
}

TEST(ABreakingCord, OfOneLinkIsDust) {
  GripWorld scene;
  CordDef def;
  def.points = 2;
  def.length = 1.0;
  def.positions = {{0.0, 0.0}, {0.0, -1.0}};
  def.pins = {0};
  def.breaking_force = 20.0;
  const CordId rope = scene.coupling.add(Cord(def));
  b2Body* load = scene.add_body({0.0, -1.0}, 3.0);
  const GripId grip = scene.coupling.hold(*load, {.cord = rope, .arc = 1.0});
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_FALSE(scene.coupling.last_step().cut_events()[0].first || scene.coupling.last_step().cut_events()[0].second);
  EXPECT_EQ(scene.coupling.size(), 0);
  EXPECT_FALSE(scene.coupling.grip(grip).is_valid());
  EXPECT_EQ(scene.coupling.add(Cord(def)), 1);
  scene.tick(2);
  EXPECT_EQ(scene.coupling.size(), 1) << "without a load it holds";
}

/// A hanging rope pulls at its pin with its weight and that of the loads.
TEST(ABreakingCord, TellsTheReactionOfItsPin) {
  LoadedRope scene;
  scene.tick(300);
  const Vec2 reaction = ribbon::reaction(scene.coupling.cord(scene.rope).direct(), 0, {0.0, -g});
  EXPECT_NEAR(reaction.y, (3.0 + 0.5 + 1.0) * g, 1e-3 * 4.5 * g);
}

}  // namespace
}  // namespace engine
