#include <gtest/gtest.h>

#include "tests/engine/coupling/grip_world.h"
#include "tests/support/allocations.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using ribbon::DefinitionError;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::CutEvent;
using test_support::refusal;
using test_support::says;

/// Returns the number of allocations of an action.
template <typename Do>
long allocations_of(Do&& action) {
  const test_support::AllocationCount count;
  action();
  return count.so_far();
}

/// Ropes that hang with loads at their ends and hands in their middles.
struct LoadedRopes : GripWorld {
  explicit LoadedRopes(int count, const CordDef& terms = {}) {
    for (int k = 0; k < count; ++k) {
      CordDef def = terms;
      def.pins = {0};
      def.positions = hanging(k).positions;
      const CordId rope = coupling.add(Cord(def));
      coupling.cord(rope).direct().set_load(7, {0.01, 0.0});
      coupling.hold(*add_body({1.0 * k, -5.0}, 0.5), {.cord = rope, .arc = 5.0});
      coupling.hold(*add_body({1.0 * k, -10.0}, 3.0), {.cord = rope, .arc = 10.0});
    }
    tick(20);
  }
};

TEST(ReservingCords, MakesCutsAndTheTicksAfterThemFreeOfAllocation) {
  CordDef elastic;
  elastic.stretch_stiffness = 1e5;
  elastic.damping = 0.01;
  for (const CordDef& terms : {CordDef{}, elastic}) {
    LoadedRopes scene(2, terms);
    scene.coupling.reserve(8, 51);
    std::optional<CutEvent> first;
    EXPECT_EQ(allocations_of([&] { first = scene.coupling.cord(0).cut(7.0); }), 0);
    EXPECT_EQ(allocations_of([&] { scene.tick(30); }), 0) << "the pieces move on";
    EXPECT_EQ(allocations_of([&] { scene.coupling.cut({-1.0, -2.0}, {2.0, -2.2}); }), 0) << "a blade";
    EXPECT_EQ(allocations_of([&] { scene.tick(30); }), 0);
    EXPECT_EQ(scene.coupling.size(), 5);
    EXPECT_EQ(allocations_of([&] { scene.coupling.cord(*first->second).cut(1.0); }), 0) << "a piece";
    EXPECT_EQ(allocations_of([&] { scene.tick(30); }), 0);
    EXPECT_GT(allocations_of([&] { scene.coupling.cord(scene.coupling.cords()[0]).cut(1.0); }), 0) << "all is used";
  }
}

TEST(ReservingCords, MakesBreaksFreeOfAllocation) {
  CordDef def;
  def.breaking_force = 45.0;
  LoadedRopes scene(2, def);
  scene.coupling.reserve(4, 51);
  scene.world.SetGravity({0.0F, -11.0F});
  EXPECT_EQ(allocations_of([&] { scene.tick(30); }), 0);
  EXPECT_EQ(scene.coupling.size(), 4) << "both broke";
}

/// Two ropes of an island are one island each after their tie has come undone.
TEST(ReservingCords, MakesBreaksOfTiesFreeOfAllocation) {
  LoadedRopes scene(2);
  const ribbon::box2d::TieId tie = scene.coupling.tie({0, 30, 1, 30, 1e3});
  scene.tick(60);
  scene.coupling.tie(tie).untie();
  const ribbon::box2d::TieId weak = scene.coupling.tie({0, 30, 1, 30, 1e-3});
  scene.coupling.reserve(0, 51);
  EXPECT_EQ(allocations_of([&] { scene.tick(30); }), 0);
  EXPECT_FALSE(scene.coupling.tie(weak).is_valid());
}

TEST(ReservingCords, ChangesNoBit) {
  const auto run = [](int reserved) {
    LoadedRopes scene(2);
    scene.coupling.cord(0).direct().reel(0, 50, 9.0, 1.0);
    scene.coupling.cord(0).direct().set_breaking_force(40, 100.0);
    scene.coupling.reserve(reserved, 51);
    scene.tick(3);
    scene.coupling.cut({-1.0, -2.0}, {2.0, -7.0});
    scene.tick(20);
    scene.coupling.cord(scene.coupling.cords().back()).cut(0.05);
    scene.tick(20);
    return scene.coupling.save(scene.world);
  };
  const Coupling::State without = run(0);
  EXPECT_EQ(run(8), without);
  EXPECT_EQ(run(2), without) << "also if some pieces get reserved memory and others do not";
}

TEST(ReservingCords, PiecesInReservedMemoryAreRestored) {
  LoadedRopes scene(1);
  scene.coupling.reserve(4, 51);
  const CutEvent cut = scene.coupling.cord(0).cut(3.0);
  scene.tick(5);
  const Coupling::State state = scene.coupling.save(scene.world);
  scene.coupling.cord(*cut.first).cut(1.0);
  scene.coupling.remove(*cut.second);
  scene.coupling.restore(state, scene.world);
  EXPECT_EQ(scene.coupling.save(scene.world), state);
}

TEST(ReservingCords, IsForRopesNotForRibbons) {
  GripWorld scene;
  CordDef strip;
  strip.points = 11;
  strip.rows = 2;
  strip.width = 0.1;
  strip.stretch_stiffness = 1e3;
  const CordId ribbon = scene.coupling.add(Cord(strip));
  const CordId rope = scene.coupling.add(Cord(hanging(20.0)));
  scene.tick(5);
  scene.coupling.reserve(3, 51);
  EXPECT_GT(allocations_of([&] { scene.coupling.cord(ribbon).cut(5.0); }), 0);
  EXPECT_EQ(allocations_of([&] { scene.coupling.cord(rope).cut(5.0); }), 0);
}

TEST(ReservingCords, RefusesWhatIsOutOfRange) {
  Coupling coupling;
  EXPECT_EQ(refusal<DefinitionError>([&] { coupling.reserve(-1, 50); }), "cords is -1; accepted is 0 to 1e+06");
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { coupling.reserve(1, 1); }), "points is 1; accepted is 2 to 1e+06"));
  EXPECT_EQ(coupling.size(), 0);
}

}  // namespace
}  // namespace engine
