#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/same_motion.h"
#include "tests/support/allocations.h"
#include "tests/support/net.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::CallError;
using ribbon::DefinitionError;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::CutEvent;
using ribbon::box2d::TieId;
using ribbon::box2d::TieState;
using test_support::refusal;
using test_support::says;

/// Two ropes of 10 m that hang side by side, 1 m apart, and a rope of 1 m tied between them at a depth of 4 m.
struct Rung : GripWorld {
  Rung() {
    left = coupling.add(Cord(hanging(0.0)));
    right = coupling.add(Cord(hanging(1.0)));
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.positions = test_support::equally_spaced(11, {0.0, -4.0}, {0.1, 0.0});
    rung = coupling.add(Cord(def));
    first = coupling.tie({left, 20, rung, 0});
    second = coupling.tie({.cord = rung, .point = 10, .other_cord = right, .other_point = 20});
  }
  /// Returns what a run of some ticks ends with.
  Coupling::State run(int ticks) {
    tick(ticks);
    return coupling.save(world);
  }

  CordId left, right, rung;
  TieId first, second;
};

TEST(TyingCords, GivesIdsAndHandles) {
  Rung scene;
  EXPECT_EQ(scene.first, 1);
  EXPECT_EQ(scene.second, 2);
  EXPECT_TRUE(scene.coupling.tie(scene.first).is_valid());
  EXPECT_FALSE(scene.coupling.tie(TieId{3}).is_valid());
  const TieState state = scene.coupling.tie(scene.second).state();
  EXPECT_EQ(state.cord, scene.rung);
  EXPECT_EQ(state.point, 10);
  EXPECT_EQ(state.other_cord, scene.right);
  EXPECT_EQ(state.other_point, 20);
  EXPECT_EQ(state.gap, 0.0);
  EXPECT_LT(length(state.place - Vec2{1.0, -4.0}), 1e-12);
}

TEST(TyingCords, CarriesABodyOnWhatIsTied) {
  Rung scene;
  b2Body* load = scene.add_body({0.5, -4.0}, 70.0);
  load->SetLinearDamping(3.0F);
  scene.coupling.hold(*load, {.cord = scene.rung, .arc = 0.5});
  scene.tick(600);
  const TieState state = scene.coupling.tie(scene.first).state();
  EXPECT_EQ(state.gap, 0.0);
  EXPECT_NEAR(state.pull.y, -0.5 * 70.0 * g, 0.01 * 70.0 * g) << "half of the load and of the rung";
  EXPECT_EQ(scene.coupling.last_step().report().unconverged, 0);
  EXPECT_EQ(scene.coupling.last_step().islands(), 1);
  for (const CordId cord : scene.coupling.cords()) {
    const Cord& direct = scene.coupling.cord(cord).direct();
    for (int i = 0; i + 1 < direct.size(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      EXPECT_NEAR(length(direct.positions()[k + 1] - direct.positions()[k]), direct.rest_length(i),
                  1e-4 * direct.rest_length(i));
    }
  }
}

TEST(TyingCords, EndsWhenItIsUntied) {
  Rung scene;
  scene.tick(30);
  EXPECT_TRUE(scene.coupling.tie(scene.first).untie());
  EXPECT_FALSE(scene.coupling.tie(scene.first).untie());
  EXPECT_FALSE(scene.coupling.tie(scene.first).is_valid());
  EXPECT_TRUE(says(refusal<CallError>([&] { (void)scene.coupling.tie(scene.first).state(); }), "tie is 1"));
  scene.tick(60);
  EXPECT_LT(scene.coupling.cord(scene.rung).positions()[0].y, -4.5) << "its first end falls";
  EXPECT_TRUE(scene.coupling.tie(scene.second).is_valid());
  EXPECT_EQ(scene.coupling.tie({scene.left, 20, scene.rung, 0}), 3) << "an id is not used again";
}

TEST(TyingCords, EndsWithTheCord) {
  for (const int how : {0, 1, 2}) {
    Rung scene;
    scene.tick(5);
    if (how == 0) scene.coupling.remove(scene.left);
    if (how == 1) scene.coupling.cord(scene.left).set_enabled(false);
    if (how == 2) scene.coupling.cord(scene.left).replace(Cord(hanging(0.0)));
    EXPECT_FALSE(scene.coupling.tie(scene.first).is_valid());
    EXPECT_TRUE(scene.coupling.tie(scene.second).is_valid());
    scene.tick(5);
  }
}

TEST(TyingCords, GoesToThePieceOfACutCord) {
  Rung scene;
  scene.tick(5);
  const CutEvent above = scene.coupling.cord(scene.left).cut(3.0);
  EXPECT_EQ(scene.coupling.tie(scene.first).state().cord, *above.second);
  EXPECT_EQ(scene.coupling.tie(scene.first).state().point, 5);
  EXPECT_EQ(scene.coupling.tie(scene.first).state().gap, 0.0);
  const CutEvent below = scene.coupling.cord(scene.right).cut(6.0);
  EXPECT_EQ(scene.coupling.tie(scene.second).state().other_cord, *below.first);
  EXPECT_EQ(scene.coupling.tie(scene.second).state().other_point, 20);
  scene.tick(30);
  EXPECT_EQ(scene.coupling.tie(scene.second).state().gap, 0.0);
  scene.coupling.cord(scene.rung).cut(0.02);
  EXPECT_FALSE(scene.coupling.tie(scene.first).is_valid()) << "the end is dust";
}

/// The upper tie carries two loads, the lower one a single load.
TEST(TyingCords, BreaksWhereTheOverloadIsLargest) {
  GripWorld scene;
  std::vector<TieId> ties;
  for (int k = 0; k < 3; ++k) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.positions = test_support::equally_spaced(11, {0.0, -1.0 * k}, {0.0, -0.1});
    if (k == 0) def.pins = {0};
    const CordId cord = scene.coupling.add(Cord(def));
    if (k == 0) continue;
    ties.push_back(scene.coupling.tie({cord - 1, 10, cord, 0, 150.0}));
    scene.coupling.hold(*scene.add_body({0.0, -1.0 - k}, 10.0), {.cord = cord, .arc = 1.0});
  }
  scene.tick();
  EXPECT_FALSE(scene.coupling.tie(ties[0]).is_valid()) << "under 196 N";
  EXPECT_TRUE(scene.coupling.tie(ties[1]).is_valid()) << "under 98 N";
  scene.tick(60);
  EXPECT_TRUE(scene.coupling.tie(ties[1]).is_valid());
  EXPECT_LT(scene.coupling.cord(2).positions()[10].y, -5.0) << "all fell";
}

TEST(TyingCords, WakesThemAndUntyingDoes) {
  GripWorld scene;
  CordDef def = hanging(0.0);
  def.allow_sleep = true;
  def.drag = 1.0;
  const CordId left = scene.coupling.add(Cord(def));
  def.positions = test_support::equally_spaced(def.points, {0.4, 0.0}, {0.0, -0.2});
  const CordId right = scene.coupling.add(Cord(def));
  scene.tick(200);
  ASSERT_TRUE(scene.coupling.cord(left).direct().is_asleep());
  const TieId tie = scene.coupling.tie({left, 50, right, 50});
  scene.tick();
  EXPECT_FALSE(scene.coupling.cord(left).direct().is_asleep());
  scene.tick(60);
  EXPECT_EQ(scene.coupling.tie(tie).state().gap, 0.0) << "they were drawn together";
  scene.tick(1200);
  ASSERT_TRUE(scene.coupling.cord(left).direct().is_asleep());
  ASSERT_TRUE(scene.coupling.cord(right).direct().is_asleep());
  scene.coupling.tie(tie).untie();
  scene.tick();
  EXPECT_FALSE(scene.coupling.cord(left).direct().is_asleep());
  scene.tick(30);
  EXPECT_GT(scene.coupling.cord(right).positions()[50].x - scene.coupling.cord(left).positions()[50].x, 0.05);
}

TEST(TyingCords, RefusesWhatCannotBeTied) {
  Rung scene;
  const auto refused = [&](const ribbon::box2d::TieDef& def) {
    return refusal<CallError>([&] { scene.coupling.tie(def); });
  };
  EXPECT_EQ(refused({scene.left, 0, scene.left, 9}), "tie is of cord 0 to itself; accepted is a tie of two cords");
  EXPECT_EQ(refused({scene.rung, 0, scene.left, 20}),
            "point 0 of cord 2 is tied to point 20 of cord 0 already; accepted are points that no ties connect");
  EXPECT_EQ(
      refused({scene.rung, 0, scene.left, 21}),
      "tie connects two points of cord 0 through other cords; accepted is one that does not tie a cord to itself");
  EXPECT_EQ(refused({scene.left, 0, 9, 0}), "cord is 9; accepted is the id of a cord that was added and not removed");
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { scene.coupling.tie({0, 51, 1, 0}); }), "point is 51"));
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { scene.coupling.tie({0, 1, 1, -1}); }), "other_point is -1"));
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { scene.coupling.tie({0, 1, 1, 1, 0.0}); }), "breaking_force is 0"));
  const CordId thesis = scene.coupling.add(ribbon::ThesisCord({}));
  EXPECT_TRUE(says(refused({scene.left, 0, thesis, 0}), "is of the thesis solver"));
  scene.coupling.gather(scene.world, dt);
  EXPECT_TRUE(says(refused({scene.left, 0, scene.right, 0}), "between gather and apply"));
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.tie(scene.first).untie(); }), "between gather and apply"));
  scene.coupling.step();
  scene.coupling.apply();
  scene.coupling.cord(scene.right).set_enabled(false);
  EXPECT_EQ(refused({scene.left, 0, scene.right, 0}), "cord 1 is disabled; accepted is one that is enabled");
  EXPECT_EQ(scene.coupling.tie({scene.left, 0, scene.rung, 10}), 3) << "nothing was changed";
}

TEST(TyingCords, AStateRestoresTheTies) {
  Rung scene;
  scene.tick(10);
  const Coupling::State before = scene.coupling.save(scene.world);
  const auto go_on = [&] {
    scene.coupling.tie(scene.first).untie();
    scene.coupling.tie({scene.left, 30, scene.rung, 5, 1e3});
    scene.coupling.cord(scene.right).cut(3.0);
    scene.tick(20);
    return scene.coupling.save(scene.world);
  };
  const Coupling::State once = go_on();
  scene.coupling.restore(before, scene.world);
  EXPECT_EQ(scene.coupling.save(scene.world), before);
  EXPECT_TRUE(scene.coupling.tie(scene.first).is_valid());
  EXPECT_EQ(go_on(), once) << "the same ids and the same bits";

  Rung twin;
  twin.coupling.restore(once, twin.world);
  EXPECT_EQ(twin.coupling.save(twin.world), once);
}

TEST(TyingCords, AStateWithWrongTiesIsRefused) {
  Rung scene;
  const CordId thesis = scene.coupling.add(ribbon::ThesisCord({}));
  const Coupling::State good = scene.coupling.save(scene.world);
  const auto refused = [&](auto change) {
    Coupling::State state = good;
    change(state);
    std::string message = refusal<DefinitionError>([&] { scene.coupling.restore(state, scene.world); });
    EXPECT_EQ(scene.coupling.save(scene.world), good);
    return message;
  };
  EXPECT_TRUE(says(refused([](auto& state) { state.ties[0].place.cord = 7; }), "state.ties.cord is 7"));
  EXPECT_TRUE(says(refused([=](auto& state) { state.ties[0].place.cord = thesis; }), "of the thesis solver"));
  EXPECT_TRUE(says(refused([](auto& state) { state.ties[0].other.point = 11; }), "state.ties.point is 11"));
  EXPECT_TRUE(says(refused([](auto& state) { state.ties[1].id = 1; }), "state.ties.id"));
  EXPECT_TRUE(says(refused([](auto& state) { state.next_tie = 2; }), "state.ties.id"));
  EXPECT_TRUE(says(refused([](auto& state) { state.ties[0].breaking_force = -1.0; }), "state.ties.breaking_force"));
  EXPECT_TRUE(says(refused([](auto& state) { state.ties[0].other = state.ties[0].place; }), "to itself"));
  EXPECT_TRUE(says(refused([](auto& state) { state.cords[0].enabled = false; }), "accepted is the id of an enabled"));
}

/// A rung between two ropes, and two ropes that are tied to each other.
struct RungAndPair : Rung {
  RungAndPair() {
    for (int k = 0; k < 3; ++k) coupling.add(Cord(hanging(10.0 + k)));
    coupling.tie({3, 50, 4, 50});
  }
};

TEST(TyingCords, HasTheSameBitsWithWorkersAndWithEstimates) {
  expect_same_motion<RungAndPair>([](RungAndPair& scene) { scene.tick(40); });
}

TEST(TyingCords, AllocatesNothingInASteadyTick) {
  RungAndPair scene;
  scene.tick(20);
  const test_support::AllocationCount allocations;
  scene.tick(20);
  EXPECT_EQ(allocations.so_far(), 0);
}

TEST(TyingCords, MakesANetThatHangsAndCatchesABall) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced()}) {
    test_support::Net net(accuracy);
    double hanging_strain = 0.0;
    for (int k = 0; k < 120; ++k) {
      net.tick();
      hanging_strain = std::max(hanging_strain, net.strain());
    }
    EXPECT_LE(hanging_strain, 1e-3);
    net.drop_ball(100.0);
    int unconverged = 0;
    for (int k = 0; k < 120; ++k) {
      net.tick();
      unconverged += net.coupling.last_step().report().unconverged;
      ASSERT_LE(net.strain(), 1e-2) << "tick " << k;
    }
    // fast() truncates solves of many cords
    if (accuracy == Accuracy::balanced()) {
      EXPECT_EQ(unconverged, 0);
    }
    EXPECT_GT(net.ball->GetPosition().y, -2.5) << "it lies in the net";
  }
}

}  // namespace
}  // namespace engine
