#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/same_motion.h"
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
using ribbon::box2d::TieId;
using test_support::refusal;
using test_support::says;

constexpr int columns = 21;

/// A ribbon of 2 m and 0.4 m that hangs from its first column, with its first row at x.
CordDef hanging_ribbon(double x, int rows) {
  CordDef def;
  def.points = columns;
  def.rows = rows;
  def.length = 2.0;
  def.mass_per_length = 0.5;
  def.width = 0.4;
  ribbon::solid(1e5, 0.0, 1.0, def.width).apply_to(def);
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) def.positions.push_back({x + def.width * j / (rows - 1), -0.1 * i});
  }
  for (int j = 0; j < rows; ++j) def.pins.push_back(j);
  return def;
}

/// A hanging ribbon of five rows with a body at each lower corner and one in the middle of its cut row, and a rope that
/// is tied to its last row.
struct LoadedRibbon : GripWorld {
  LoadedRibbon() {
    strip = coupling.add(Cord(hanging_ribbon(0.0, 5)));
    rope = coupling.add(Cord(hanging(0.4)));
    left = add_body({0.0, -2.0}, 2.0);
    right = add_body({0.4, -2.0}, 1.0);
    middle = add_body({0.2, -1.0}, 0.5);
    left_grip = coupling.hold(*left, {.cord = strip, .arc = 2.0, .row = 0});
    right_grip = coupling.hold(*right, {.cord = strip, .arc = 2.0, .row = 4});
    middle_grip = coupling.hold(*middle, {.cord = strip, .arc = 1.03, .row = 2});
    tie = coupling.tie({strip, 10 * 5 + 4, rope, 5});
  }

  CordId strip, rope;
  b2Body* left;
  b2Body* right;
  b2Body* middle;
  GripId left_grip, right_grip, middle_grip;
  TieId tie;
};

TEST(CuttingARibbonAlong, MovesWhatItHoldsToItsSide) {
  LoadedRibbon scene;
  scene.coupling.cord(scene.strip).set_user_data(77);
  scene.tick(10);
  const Vec2 before = scene.coupling.grip(scene.right_grip).state().place;
  const CutEvent cut = scene.coupling.cord(scene.strip).cut_along(2);
  EXPECT_EQ(cut, (CutEvent{scene.strip, 0.0, 2, 3, false, 0.0, 2}));
  EXPECT_FALSE(scene.coupling.cord(scene.strip).is_valid());
  EXPECT_EQ(scene.coupling.cord(2).shape().rows, 3);
  EXPECT_EQ(scene.coupling.cord(3).shape().rows, 3);
  EXPECT_EQ(scene.coupling.cord(3).user_data(), 77U);
  EXPECT_EQ(scene.coupling.grip(scene.left_grip).state().cord, 2);
  EXPECT_EQ(scene.coupling.grip(scene.middle_grip).state().cord, 2) << "what holds the cut row";
  EXPECT_EQ(scene.coupling.grip(scene.middle_grip).state().point, 10 * 3 + 2);
  EXPECT_NEAR(scene.coupling.grip(scene.middle_grip).state().arc, 1.03, 1e-12);
  EXPECT_EQ(scene.coupling.grip(scene.right_grip).state().cord, 3);
  EXPECT_EQ(scene.coupling.grip(scene.right_grip).state().point, 20 * 3 + 2);
  EXPECT_EQ(scene.coupling.grip(scene.right_grip).state().place, before);
  EXPECT_EQ(scene.coupling.tie(scene.tie).state().cord, 3);
  EXPECT_EQ(scene.coupling.tie(scene.tie).state().point, 10 * 3 + 2);
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_EQ(scene.coupling.last_step().cut_events()[0], cut);
}

TEST(CuttingARibbonAlong, LeavesBothSidesHanging) {
  LoadedRibbon scene;
  scene.tick(120);
  const b2Vec2 left = scene.left->GetPosition();
  const CutEvent cut = scene.coupling.cord(scene.strip).cut_along(2);
  for (int k = 0; k < 180; ++k) {
    scene.tick();
    EXPECT_EQ(scene.coupling.cord(*cut.first).island_report().unconverged, 0);
  }
  EXPECT_NEAR(scene.left->GetPosition().y, left.y, 0.05);
  EXPECT_NEAR(scene.right->GetPosition().y, left.y, 0.05);
  EXPECT_EQ(scene.coupling.size(), 3);
}

/// Their edges lie in each other: the pieces do not push each other apart, nor do pieces of theirs.
TEST(CuttingARibbonAlong, PiecesNeverTouchEachOther) {
  for (const bool self_contact : {false, true}) {
    GripWorld scene;
    b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-50.0F, 0.0F}, {50.0F, 0.0F});
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = 0.5F;
    scene.world.CreateBody(&ground)->CreateFixture(&fixture);
    CordDef def = hanging_ribbon(0.0, 5);
    def.pins.clear();
    def.positions.clear();
    for (int i = 0; i < columns; ++i) {
      for (int j = 0; j < 5; ++j) def.positions.push_back({0.1 * i, 0.03 + 0.1 * j});
    }
    def.radius = 0.02;
    def.friction = 0.5;
    def.self_contact = self_contact;
    def.cord_contact = true;
    const CordId strip = scene.coupling.add(Cord(def));
    scene.tick(120);
    const auto rest = scene.coupling.cord(strip).positions();
    const std::vector<Vec2> before(rest.begin(), rest.end());
    const CutEvent along = scene.coupling.cord(strip).cut_along(2);
    const CutEvent across = scene.coupling.cord(*along.second).cut(1.0);
    for (int k = 0; k < 60; ++k) {
      scene.tick();
      for (const CordId id : scene.coupling.cords()) {
        for (const ribbon::Touch& touch : scene.coupling.cord(id).direct().touches()) {
          const bool is_other_piece = touch.other >> 63U != 0 && static_cast<CordId>(touch.other & 0xffU) != id;
          EXPECT_FALSE(is_other_piece) << self_contact;
        }
      }
    }
    const auto low = scene.coupling.cord(*along.first).positions();
    const auto high = scene.coupling.cord(*across.first).positions();
    for (std::size_t i = 0; i < 21; ++i) EXPECT_LE(length(low[3 * i] - before[5 * i]), 2e-3) << self_contact;
    EXPECT_LE(high[0].y, before[2].y + 1e-3) << "they are not thrown apart";
  }
}

TEST(CuttingARibbonAlong, RefusesWhatCannotBeCut) {
  LoadedRibbon scene;
  const CordId narrow = scene.coupling.add(Cord(hanging_ribbon(5.0, 2)));
  const CordId thesis = scene.coupling.add(ribbon::ThesisCord({}));
  scene.tick();
  const auto refused = [&](CordId cord, int row) {
    return refusal<CallError>([&] { scene.coupling.cord(cord).cut_along(row); });
  };
  const Coupling::State before = scene.coupling.save(scene.world);
  for (const int row : {-1, 0, 4, 5}) {
    EXPECT_EQ(refusal<DefinitionError>([&] { scene.coupling.cord(scene.strip).cut_along(row); }),
              "row is " + std::to_string(row) + "; accepted is 1 to 3");
  }
  EXPECT_TRUE(says(refused(scene.rope, 1), "accepted is a ribbon of three or more rows"));
  EXPECT_TRUE(says(refused(narrow, 1), "accepted is a ribbon of three or more rows"));
  EXPECT_TRUE(says(refused(thesis, 1), "is of the thesis solver"));
  EXPECT_EQ(scene.coupling.save(scene.world), before);
  scene.coupling.gather(scene.world, dt);
  EXPECT_TRUE(says(refused(scene.strip, 2), "between gather and apply"));
  scene.coupling.step();
  scene.coupling.apply();
  scene.coupling.cord(scene.strip).set_enabled(false);
  EXPECT_TRUE(says(refused(scene.strip, 2), "is disabled"));
  scene.coupling.cord(scene.strip).set_enabled(true);
  scene.coupling.cord(scene.strip).cut_along(2);
  EXPECT_TRUE(says(refused(scene.strip, 2), "accepted is the id of a cord that was added and not removed"));
}

TEST(CuttingARibbonAlong, IsRefusedInsideTheStepOfTheWorld) {
  LoadedRibbon scene;
  const std::string refused = refusal_in_step<CallError>(scene, [&scene] { scene.coupling.cord(0).cut_along(2); });
  EXPECT_TRUE(says(refused, "world is locked"));
  EXPECT_EQ(scene.coupling.size(), 2);
}

TEST(CuttingARibbonAlong, WakesASleepingOne) {
  GripWorld scene;
  CordDef def = hanging_ribbon(0.0, 3);
  def.allow_sleep = true;
  def.drag = 3.0;
  def.damping = 0.01;
  const CordId strip = scene.coupling.add(Cord(def));
  scene.tick(600);
  ASSERT_TRUE(scene.coupling.cord(strip).direct().is_asleep());
  const CutEvent cut = scene.coupling.cord(strip).cut_along(1);
  for (const CordId piece : {*cut.first, *cut.second}) {
    EXPECT_FALSE(scene.coupling.cord(piece).direct().is_asleep());
  }
  scene.tick(10);
  EXPECT_EQ(scene.coupling.size(), 2);
}

TEST(CuttingARibbonAlong, AStateFromBeforeRestoresTheUncutRibbon) {
  GripWorld scene;
  const CordId strip = scene.coupling.add(Cord(hanging_ribbon(0.0, 5)));
  const CordId rope = scene.coupling.add(Cord(hanging(0.4)));
  scene.coupling.tie({strip, 10 * 5 + 4, rope, 5});
  scene.tick(10);
  const Coupling::State before = scene.coupling.save(scene.world);
  const auto go_on = [&] {
    const CutEvent cut = scene.coupling.cord(strip).cut_along(3);
    scene.coupling.cord(*cut.first).cut_along(1);
    scene.tick(20);
    return scene.coupling.save(scene.world);
  };
  const Coupling::State once = go_on();
  EXPECT_EQ(once.cords.size(), 4U);
  scene.coupling.restore(before, scene.world);
  EXPECT_EQ(scene.coupling.save(scene.world), before);
  EXPECT_TRUE(scene.coupling.cord(strip).is_valid());
  EXPECT_EQ(go_on(), once) << "the same ids and the same bits";
  GripWorld other;
  other.coupling.restore(once, other.world);
  EXPECT_EQ(other.coupling.save(other.world), once) << "the pieces are made again from their definitions";
  scene.tick(20);
  other.tick(20);
  EXPECT_EQ(other.coupling.save(other.world), scene.coupling.save(scene.world));
}

TEST(CuttingARibbonAlong, ByABladeThatGoesThroughAllItsColumns) {
  GripWorld scene;
  for (const double x : {0.0, 1.0}) scene.coupling.add(Cord(hanging_ribbon(x, 5)));
  scene.coupling.add(Cord(hanging_ribbon(2.0, 2)));
  // From above the first ribbon to below it, from between rows 0 and 1 to beyond row 2.
  const auto cuts = scene.coupling.cut({0.05, 0.5}, {0.25, -2.5});
  ASSERT_EQ(cuts.size(), 1U);
  EXPECT_EQ(cuts[0].row, 1);
  EXPECT_EQ(scene.coupling.cord(*cuts[0].first).shape().rows, 2);
  EXPECT_EQ(scene.coupling.cord(*cuts[0].second).shape().rows, 4);
  // Along the edge: at the inner row next to it.
  EXPECT_EQ(scene.coupling.cut({1.399, 0.5}, {1.399, -2.5})[0].row, 3);
  // A blade that ends inside crosses no middle line, and does not cut through.
  EXPECT_TRUE(scene.coupling.cut({0.25, 0.5}, {0.25, -1.5}).empty());
  // A ribbon of two rows is cut across only.
  const auto across = scene.coupling.cut({2.1, 0.5}, {2.3, -2.5});
  ASSERT_EQ(across.size(), 1U);
  EXPECT_EQ(across[0].row, 0);
  EXPECT_NEAR(across[0].arc, 1.0, 1e-9);
}

TEST(ABreakingRibbon, BreaksAcrossAtTheTop) {
  for (const int rows : {2, 3, 5}) {
    GripWorld scene;
    CordDef def = hanging_ribbon(0.0, rows);
    def.breaking_force = 45.0;  // it weighs 9.8 N
    def.damping = 0.02;
    const CordId strip = scene.coupling.add(Cord(def));
    scene.tick(200);
    ASSERT_EQ(scene.coupling.size(), 1) << "it bears its own weight";
    const b2Body* load = scene.add_body({0.2, -2.0}, 1.0);
    scene.coupling.hold(strip, 20 * rows + rows / 2, *scene.world.GetBodyList(), {0.0F, 0.0F});
    scene.tick(200);
    ASSERT_EQ(scene.coupling.size(), 1) << "and another kilogram";
    const_cast<b2Body*>(load)->GetFixtureList()->SetDensity(load->GetFixtureList()->GetDensity() * 5.0F);
    const_cast<b2Body*>(load)->ResetMassData();
    int ticks = 0;
    while (scene.coupling.last_step().cut_events().empty() && ++ticks < 100) scene.tick();
    ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U) << rows;
    const CutEvent event = scene.coupling.last_step().cut_events()[0];
    EXPECT_TRUE(event.broke);
    EXPECT_GT(event.tension, 45.0);
    EXPECT_LT(event.arc, 0.2);
    EXPECT_EQ(event.row, 0);
    EXPECT_EQ(scene.coupling.cord(*event.first).shape().rows, rows);
    scene.tick(30);
    EXPECT_LT(load->GetPosition().y, -2.5);
  }
}

TEST(ABreakingRibbon, BreaksWhereItIsWeak) {
  GripWorld scene;
  const CordId strip = scene.coupling.add(Cord(hanging_ribbon(0.0, 4)));
  scene.tick(60);
  scene.coupling.cord(strip).direct().set_breaking_force(14, 1.0);  // 2.7 N hang below it
  scene.tick();
  ASSERT_EQ(scene.coupling.last_step().cut_events().size(), 1U);
  EXPECT_NEAR(scene.coupling.last_step().cut_events()[0].arc, 1.45, 1e-9);
  EXPECT_NEAR(scene.coupling.last_step().cut_events()[0].tension, 0.5 * g * 0.55, 0.3);
}

/// Ribbons are cut in all ways and break at random, while bodies hold them and they lie on the ground.
TEST(CuttingRibbons, AtRandomKeepsMassAndIdsAndMixesUpNothing) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    test_support::Dice dice(seed);
    GripWorld scene;
    b2BodyDef ground;
    b2EdgeShape edge;
    edge.SetTwoSided({-50.0F, -3.0F}, {50.0F, -3.0F});
    scene.world.CreateBody(&ground)->CreateFixture(&edge, 0.0F);
    for (int k = 0; k < 2; ++k) {
      CordDef def = hanging_ribbon(1.5 * k, 5);
      def.radius = 0.01;
      def.friction = 0.5;
      def.area_stiffness = 1.0;
      def.damping = 0.005;
      if (k == 1) def.bending_stiffness *= 0.1;
      def.self_contact = k == 1;
      def.cord_contact = true;
      const CordId strip = scene.coupling.add(Cord(def));
      for (const int row : {0, 4}) {
        scene.coupling.hold(*scene.add_body({1.5 * k + 0.1 * row, -2.0}, 0.5), {.cord = strip, .arc = 2.0, .row = row});
      }
    }
    const auto mass = [&scene] {
      double sum = 0.0;
      for (const CordId id : scene.coupling.cords()) {
        const Cord& cord = scene.coupling.cord(id).direct();
        for (int p = 0; p < cord.size(); ++p) sum += cord.mass(p);
      }
      return sum;
    };
    const double whole = mass();
    int along = 0;
    for (int tick = 0; tick < 150; ++tick) {
      scene.tick();
      if (tick % 10 != 9) continue;
      const auto cords = scene.coupling.cords();
      const CordId id = cords[static_cast<std::size_t>(dice(0.0, 0.999) * static_cast<double>(cords.size()))];
      Cord& cord = scene.coupling.cord(id).direct();
      const int next = scene.coupling.size();
      if (cord.def().rows > 2 && dice.coin()) {
        const CutEvent cut =
            scene.coupling.cord(id).cut_along(1 + static_cast<int>(dice(0.0, 0.99) * (cord.def().rows - 2)));
        EXPECT_EQ(*cut.second, *cut.first + 1);
        EXPECT_EQ(scene.coupling.size(), next + 1);
        ++along;
      } else if (dice.coin()) {
        cord.set_breaking_force(static_cast<int>(dice(0.0, 0.99) * (cord.def().points - 1)), 0.0);
      } else {
        scene.coupling.cord(id).cut(dice(0.01, 0.99) * cord.def().length);
      }
      EXPECT_LE(mass(), whole * (1.0 + 1e-12));
      if (tick % 30 == 29) {
        const Coupling::State state = scene.coupling.save(scene.world);
        scene.coupling.restore(state, scene.world);
        ASSERT_EQ(scene.coupling.save(scene.world), state);
      }
    }
    EXPECT_GT(along, 0) << seed;
    for (const CordId id : scene.coupling.cords()) {
      for (const Vec2 x : scene.coupling.cord(id).positions()) {
        ASSERT_TRUE(std::isfinite(x.x) && std::isfinite(x.y));
        ASSERT_GT(x.y, -3.1) << "nothing falls through the ground; seed " << seed;
      }
    }
  }
}

/// With several workers and with error estimates: the same motion.
TEST(CuttingRibbons, HasTheSameBitsWithWorkersAndWithEstimates) {
  const Coupling::State end = expect_same_motion<GripWorld>([](GripWorld& scene) {
    for (int k = 0; k < 3; ++k) {
      CordDef def = hanging_ribbon(0.5 * k, 3 + k);
      def.cord_contact = def.self_contact = true;
      def.breaking_force = 60.0 + k;
      const CordId strip = scene.coupling.add(Cord(def));
      scene.coupling.hold(*scene.add_body({0.5 * k, -2.0}, 0.6), {.cord = strip, .arc = 2.0});
    }
    for (int k = 0; k < 30; ++k) {
      if (k == 5) scene.coupling.cord(0).cut_along(1);
      if (k == 8) scene.coupling.cut({0.7, 0.5}, {0.7, -2.5});
      if (k == 15) scene.world.SetGravity({0.0F, -40.0F});
      scene.tick();
    }
  });
  EXPECT_GT(end.next_cord, 3 + 4) << "two were cut, and some broke";
}

}  // namespace
}  // namespace engine
