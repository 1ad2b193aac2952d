#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "engine/tick/workers.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/loaded_rope.h"
#include "tests/support/dice.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using ribbon::CallError;
using ribbon::DefinitionError;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::CutEvent;
using ribbon::box2d::GripId;
using test_support::refusal;
using test_support::says;

TEST(CuttingACord, MakesTwoCordsWithIdsOfTheirOwn) {
  LoadedRope scene;
  scene.coupling.cord(scene.rope).set_user_data(77);
  scene.tick(10);
  const CutEvent cut = scene.coupling.cord(scene.rope).cut(6.03);
  EXPECT_EQ(cut, (CutEvent{scene.rope, cut.arc, 1, 2}));
  EXPECT_NEAR(cut.arc, 6.03, 1e-12);
  EXPECT_FALSE(scene.coupling.cord(scene.rope).is_valid());
  ASSERT_EQ(scene.coupling.size(), 2);
  EXPECT_EQ(scene.coupling.cord(1).positions().size(), 31U);
  EXPECT_EQ(scene.coupling.cord(2).positions().size(), 21U);
  EXPECT_EQ(scene.coupling.cord(1).user_data(), 77U);
  EXPECT_EQ(scene.coupling.grip(scene.hand_grip).state().cord, 1);
  EXPECT_EQ(scene.coupling.grip(scene.load_grip).state().cord, 2);
  EXPECT_NEAR(scene.coupling.grip(scene.load_grip).state().arc, 4.0, 1e-12);
}

TEST(CuttingACord, IsToldInTheNextTick) {
  LoadedRope scene;
  scene.tick();
  EXPECT_TRUE(scene.coupling.last_step().cut_events().empty());
  const CutEvent cut = scene.coupling.cord(scene.rope).cut(6.0);
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_EQ(scene.coupling.last_step().cut_events()[0], cut);
  scene.tick();
  EXPECT_TRUE(scene.coupling.last_step().cut_events().empty());
}

TEST(CuttingACord, LetsTheLoadFallAndTheRestHang) {
  LoadedRope scene;
  scene.tick(60);
  scene.coupling.cord(scene.rope).cut(7.0);
  scene.tick(30);
  EXPECT_NEAR(scene.load->GetPosition().y, -10.0 - 0.5 * g * 0.25, 0.02 * g * 0.25);
  EXPECT_NEAR(scene.hand->GetPosition().y, -5.0, 1e-3);
}

/// Contacts with a rope that is cut go to its pieces: a rope that lies on it, held by friction, does not slide.
TEST(CuttingACord, KeepsTheContactsOfWhatLiesOnIt) {
  GripWorld scene;
  CordDef below;
  below.points = 21;
  below.length = 2.0;
  below.radius = 0.03;
  below.friction = 1.0;
  below.cord_contact = true;
  const Vec2 along{std::cos(0.3), std::sin(0.3)};
  below.positions = test_support::equally_spaced(below.points, {}, 0.1 * along);
  for (int p = 0; p < below.points; ++p) below.pins.push_back(p);
  CordDef above = below;
  above.pins.clear();
  above.points = 11;
  above.length = 1.0;
  above.bending_stiffness = 1.0;
  above.positions = test_support::equally_spaced(above.points, 0.5 * along + 0.06 * perp(along), 0.1 * along);
  const CordId held = scene.coupling.add(Cord(below));
  const CordId rope = scene.coupling.add(Cord(above));
  scene.tick(60);
  const auto touches = scene.coupling.cord(rope).direct().touches();
  ASSERT_FALSE(touches.empty());
  const Vec2 before = scene.coupling.cord(rope).positions()[5];
  const CutEvent cut = scene.coupling.cord(held).cut(0.97);
  for (const ribbon::Touch& touch : scene.coupling.cord(rope).direct().touches()) {
    const auto id = static_cast<CordId>(touch.other & ~(std::uint64_t{1} << 63U));
    EXPECT_TRUE(id == *cut.first || id == *cut.second);
  }
  scene.tick(60);
  EXPECT_LE(length(scene.coupling.cord(rope).positions()[5] - before), 1e-3);
}

TEST(CuttingACord, CloseToThePinFreesIt) {
  LoadedRope scene;
  scene.tick(10);
  const CutEvent cut = scene.coupling.cord(scene.rope).cut(0.05);
  EXPECT_FALSE(cut.first);
  ASSERT_TRUE(cut.second);
  scene.tick(30);
  EXPECT_NEAR(scene.hand->GetPosition().y, -5.0 - 0.5 * g * 0.25, 0.02 * g * 0.25);
}

TEST(CuttingACord, ReleasesWhatHoldsTheDust) {
  LoadedRope scene;
  scene.tick(10);
  const CutEvent cut = scene.coupling.cord(scene.rope).cut(9.95);
  EXPECT_FALSE(cut.second);
  EXPECT_FALSE(scene.coupling.grip(scene.load_grip).is_valid());
  EXPECT_TRUE(scene.coupling.grip(scene.hand_grip).is_valid());
}

TEST(CuttingACord, WakesASleepingOneAndItsLoad) {
  LoadedRope scene(LoadedRope::sleepy());
  scene.fall_asleep();
  ASSERT_FALSE(scene.load->IsAwake());
  scene.coupling.cord(scene.rope).cut(7.0);
  scene.tick(30);
  EXPECT_LE(scene.load->GetPosition().y, -11.0);
}

TEST(CuttingACord, RefusesWhatCannotBeCut) {
  LoadedRope scene;
  scene.tick();
  const auto refused = [&](double arc) {
    return refusal<CallError>([&] { scene.coupling.cord(scene.rope).cut(arc); });
  };
  EXPECT_TRUE(says(refusal<DefinitionError>([&] { scene.coupling.cord(scene.rope).cut(10.5); }), "inside the cord"));
  scene.coupling.gather(scene.world, dt);
  EXPECT_TRUE(says(refused(5.0), "between gather and apply"));
  EXPECT_TRUE(says(refusal<CallError>([&] {
                     scene.coupling.cut({-1.0, -5.0}, {1.0, -5.0});
                   }),
                   "between gather and apply"));
  scene.coupling.step();
  scene.coupling.apply();
  scene.coupling.cord(scene.rope).set_enabled(false);
  EXPECT_EQ(refused(5.0), "cord 0 is disabled; accepted is one that is enabled");
  scene.coupling.cord(scene.rope).set_enabled(true);
  scene.coupling.cord(scene.rope).cut(5.1);
  EXPECT_EQ(refused(5.1), "cord is 0; accepted is the id of a cord that was added and not removed");
  const CordId thesis = scene.coupling.add(ribbon::ThesisCord({}));
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.cord(thesis).cut(1.0); }), "is of the thesis solver"));
}

TEST(CuttingACord, IsRefusedInsideTheStepOfTheWorld) {
  LoadedRope scene;
  const std::string refused = refusal_in_step<CallError>(scene, [&scene] { scene.coupling.cord(0).cut(5.0); });
  EXPECT_TRUE(says(refused, "world is locked"));
  EXPECT_EQ(scene.coupling.size(), 1);
}

TEST(CuttingCords, AlongABladeCutsWhatItCrossesWhereItDoes) {
  GripWorld scene;
  for (const double x : {0.0, 1.0, 5.0}) scene.coupling.add(Cord(hanging(x)));
  scene.tick();
  const auto cuts = scene.coupling.cut({-1.0, -2.0}, {2.0, -5.0});
  ASSERT_EQ(cuts.size(), 2U);
  EXPECT_EQ(cuts[0].cord, 0);
  EXPECT_NEAR(cuts[0].arc, 3.0, 0.01);
  EXPECT_NEAR(cuts[1].arc, 4.0, 0.01);
  EXPECT_TRUE(scene.coupling.cord(2).is_valid());
  EXPECT_EQ(scene.coupling.size(), 5);
}

TEST(CuttingCords, AlongABladeCutsACordAtEachCrossing) {
  GripWorld scene;
  CordDef def;  // a zigzag of three strands of 2 m
  def.points = 31;
  def.length = 6.0;
  for (int i = 0; i <= 30; ++i) {
    const int strand = std::min(i / 10, 2);
    const int step = i - 10 * strand;
    def.positions.push_back({strand % 2 == 0 ? 0.2 * step : 2.0 - 0.2 * step, 0.01 * i});
  }
  def.length = 0.0;
  for (int i = 0; i < 30; ++i) {
    def.length += length(def.positions[static_cast<std::size_t>(i) + 1] - def.positions[static_cast<std::size_t>(i)]);
  }
  scene.coupling.add(Cord(def));
  const std::vector<CutEvent> cuts = [&] {
    const auto made = scene.coupling.cut({1.03, -1.0}, {1.03, 1.0});
    return std::vector<CutEvent>(made.begin(), made.end());
  }();
  ASSERT_EQ(cuts.size(), 3U);
  ASSERT_EQ(scene.coupling.size(), 4);
  std::size_t points = 0;
  for (const CordId cord : scene.coupling.cords()) points += scene.coupling.cord(cord).positions().size();
  EXPECT_EQ(points, 34U);
  for (const CordId cord : scene.coupling.cords()) {
    bool left = false;
    bool right = false;
    for (const Vec2 x : scene.coupling.cord(cord).positions()) {
      left = left || x.x < 0.93;
      right = right || x.x > 1.13;
    }
    EXPECT_NE(left, right) << "each piece is on one side of the blade";
  }
}

TEST(CuttingCords, AStateFromBeforeRestoresTheUncutCord) {
  LoadedRope scene;
  scene.tick(30);
  const b2Transform load = scene.load->GetTransform();
  const b2Transform hand = scene.hand->GetTransform();
  const b2Vec2 speeds[] = {scene.load->GetLinearVelocity(), scene.hand->GetLinearVelocity()};
  const Coupling::State before = scene.coupling.save(scene.world);
  const auto go_on = [&] {
    scene.coupling.cord(scene.rope).cut(7.0);
    scene.tick(20);
    return scene.coupling.save(scene.world);
  };
  const Coupling::State once = go_on();
  scene.coupling.restore(before, scene.world);
  EXPECT_EQ(scene.coupling.save(scene.world), before);
  ASSERT_TRUE(scene.coupling.cord(scene.rope).is_valid());
  EXPECT_EQ(scene.coupling.size(), 1);
  EXPECT_EQ(scene.coupling.grip(scene.load_grip).state().cord, scene.rope);
  scene.load->SetTransform(load.p, load.q.GetAngle());
  scene.hand->SetTransform(hand.p, hand.q.GetAngle());
  scene.load->SetLinearVelocity(speeds[0]);
  scene.hand->SetLinearVelocity(speeds[1]);
  EXPECT_EQ(go_on(), once) << "the same ids and the same bits";
}

TEST(CuttingCords, AStateFromAfterIsRestoredInAnotherCoupling) {
  LoadedRope scene;
  LoadedRope twin;
  scene.tick(10);
  scene.coupling.cord(scene.rope).cut(7.0);
  scene.tick();
  const Coupling::State after = scene.coupling.save(scene.world);
  twin.coupling.restore(after, twin.world);
  EXPECT_EQ(twin.coupling.save(twin.world), after);
  EXPECT_EQ(twin.coupling.size(), 2);
}

/// A piece that is made again from its definition is the same to the last bit, also for later cuts of it.
TEST(CuttingCords, APieceThatIsRestoredIsCutToTheSameBits) {
  CordDef def = hanging();
  def.mass_per_length = 0.1 / 3.0;
  def.drag = 0.3;
  GripWorld scene;
  GripWorld twin;
  CutEvent cut;
  for (GripWorld* each : {&scene, &twin}) {
    const CordId rope = each->coupling.add(Cord(def));
    each->tick(10);
    cut = each->coupling.cord(rope).cut(7.0);
  }
  const Coupling::State state = twin.coupling.save(twin.world);
  twin.coupling.remove(*cut.first);
  twin.coupling.remove(*cut.second);
  twin.coupling.restore(state, twin.world);
  for (GripWorld* each : {&scene, &twin}) {
    each->coupling.cord(*cut.first).cut(3.0);
    each->tick(5);
  }
  EXPECT_EQ(twin.coupling.save(twin.world), scene.coupling.save(scene.world));
}

/// The ends of the pieces lie in each other, and what lies on the ground stays there.
TEST(CuttingACord, ThatLiesOnTheGroundMovesNothing) {
  for (const bool self_contact : {false, true}) {
    GripWorld scene;
    b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-50.0F, 0.0F}, {50.0F, 0.0F});
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = 0.5F;
    scene.world.CreateBody(&ground)->CreateFixture(&fixture);
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    def.radius = 0.04;
    def.friction = 0.5;
    def.self_contact = self_contact;
    def.cord_contact = true;
    def.positions = test_support::equally_spaced(def.points, {0.0, 0.06}, {0.1, 0.0});
    const CordId rope = scene.coupling.add(Cord(def));
    scene.tick(120);
    const auto rest = scene.coupling.cord(rope).positions();
    const std::vector<Vec2> before(rest.begin(), rest.end());
    const CutEvent cut = scene.coupling.cord(rope).cut(0.97);
    scene.tick(60);
    for (const auto& [piece, shift] :
         {std::pair(*cut.first, std::size_t{0}), std::pair(*cut.second, std::size_t{10})}) {
      const auto x = scene.coupling.cord(piece).positions();
      for (std::size_t p = 0; p < x.size(); ++p) EXPECT_LE(length(x[p] - before[p + shift]), 1e-4) << self_contact;
    }
  }
}

/// Where a hand holds a cord, the cord lies in its body. A piece that it holds no more is not thrown out of it.
TEST(CuttingACord, BelowAHandLetsTheRestFallThroughItsBody) {
  GripWorld scene;
  CordDef def = hanging();
  def.radius = 0.02;
  const CordId rope = scene.coupling.add(Cord(def));
  b2Body* hand = scene.add_body({0.0, -5.0}, 30.0);
  hand->GetFixtureList()->SetFilterData({});
  const GripId grip = scene.coupling.hold(*hand, {.cord = rope, .arc = 5.0});
  scene.tick(30);
  const CutEvent cut = scene.coupling.cord(rope).cut(5.05);
  EXPECT_EQ(scene.coupling.grip(grip).state().cord, *cut.first);
  scene.tick(12);
  const auto x = scene.coupling.cord(*cut.second).positions();
  EXPECT_NEAR(x[0].y, -5.0 - 0.5 * g * 0.04, 0.05);
  EXPECT_NEAR(x[0].x, 0.0, 1e-6);
}

/// Ropes are cut at random while bodies hold them and they touch the ground, are saved and restored.
TEST(CuttingCords, AtRandomKeepsAllGripsOnTheirCords) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    test_support::Dice dice(seed);
    GripWorld scene;
    b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-50.0F, -12.0F}, {50.0F, -12.0F});
    scene.world.CreateBody(&ground)->CreateFixture(&edge, 0.0F);
    for (int k = 0; k < 3; ++k) {
      CordDef def = hanging(k);
      def.radius = 0.03;
      def.friction = 0.5;
      def.self_contact = k == 1;
      def.cord_contact = true;
      const CordId rope = scene.coupling.add(Cord(def));
      for (const double arc : {3.3, 10.0}) {
        scene.coupling.hold(*scene.add_body({static_cast<double>(k), -arc}, 1.0), {.cord = rope, .arc = arc});
      }
    }
    for (int tick = 0; tick < 200; ++tick) {
      scene.tick();
      if (tick % 10 != 9) continue;
      const auto cords = scene.coupling.cords();
      const auto pick = static_cast<std::size_t>(dice(0.01, 0.99) * static_cast<double>(cords.size()));
      const CordId id = cords[pick];
      const double length =
          scene.coupling.cord(id).arc(static_cast<int>(scene.coupling.cord(id).positions().size()) - 1);
      scene.coupling.cord(id).cut(dice(0.01, 0.99) * length);
      if (tick % 30 == 29) {
        const Coupling::State state = scene.coupling.save(scene.world);
        scene.coupling.restore(state, scene.world);
        ASSERT_EQ(scene.coupling.save(scene.world), state);
      }
    }
    for (const CordId id : scene.coupling.cords()) {
      for (const Vec2 x : scene.coupling.cord(id).positions()) {
        ASSERT_TRUE(std::isfinite(x.x) && std::isfinite(x.y));
        ASSERT_GT(x.y, -12.1) << "nothing falls through the ground; seed " << seed;
      }
      const auto& cord = scene.coupling.cord(id).direct();
      for (int i = 0; i + 1 < cord.size(); ++i) {
        const double stretch =
            length(cord.positions()[static_cast<std::size_t>(i) + 1] - cord.positions()[static_cast<std::size_t>(i)]) /
            cord.rest_length(i);
        ASSERT_NEAR(stretch, 1.0, 0.01) << "seed " << seed;
      }
    }
  }
}

}  // namespace
}  // namespace engine
