// Blades cut the cords that meet their edges, and the player's knife cuts at the hand.

#include <gtest/gtest.h>

#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

using ribbon::box2d::CordId;

constexpr int rope = 10;

MapObject blade(std::vector<Vec2> edge) { return line_of(20, "blade", std::move(edge)); }

/// A level whose rope hangs from (10, 10) down to y = 6.
Level level_with(MapObject blade) { return level_of(small_map({hanging_rope(rope, {10.0, 10.0}), std::move(blade)})); }

TEST(Blade, CutsWhatCrossesItsEdgeThereOnce) {
  const Level level = level_with(blade({{9.5, 8.02}, {10.5, 8.02}}));
  Simulation simulation(level);
  EXPECT_EQ(pieces(simulation, rope), 1);
  run(simulation, 1);
  ASSERT_EQ(pieces(simulation, rope), 2);
  const auto ids = simulation.scene().coupling().cords();
  EXPECT_NEAR(simulation.scene().coupling().cord(ids[0]).positions().back().y, 8.0, 0.06);
  EXPECT_EQ(simulation.scene().coupling().cord(ids[0]).shape().columns, 21);
  run(simulation, 120);
  EXPECT_EQ(pieces(simulation, rope), 2) << "the piece that falls past the edge stays whole";
}

/// A rope without a pin falls along the edge, which it meets at each of its points.
TEST(Blade, DoesNotChopARopeThatSlidesAlongIt) {
  const Level level =
      level_of(small_map({hanging_rope(rope, {10.0, 10.0}, false), blade({{9.5, 8.02}, {10.5, 8.02}})}));
  Simulation simulation(level);
  run(simulation, 60);
  EXPECT_GE(pieces(simulation, rope), 2);
  EXPECT_LE(pieces(simulation, rope), 4);
}

TEST(Blade, LeavesACordBesideIt) {
  const Level level = level_with(blade({{9.0, 8.0}, {9.9, 8.0}}));
  Simulation simulation(level);
  run(simulation, 60);
  EXPECT_EQ(pieces(simulation, rope), 1);
}

TEST(Blade, ARectangleCutsAtItsSides) {
  MapObject box = box_of(20, "blade", {10.0, 8.0}, {1.0, 0.52});
  const Level level = level_with(box);
  Simulation simulation(level);
  run(simulation, 1);
  EXPECT_EQ(pieces(simulation, rope), 3) << "at its upper and its lower side";
  box.rotation = 1.5707963267948966;  // now it is 0.52 m wide and 1 m high
  const Level turned = level_with(box);
  Simulation other(turned);
  run(other, 1);
  const auto ids = other.scene().coupling().cords();
  EXPECT_EQ(other.scene().coupling().cord(ids[0]).shape().columns, 16);
}

/// The edge is upright and as thin as the rope: at no end of a tick do they cross.
TEST(Blade, CutsARopeThatSweepsPastItInATick) {
  const Level level = level_with(blade({{10.3, 7.8}, {10.3, 8.2}}));
  Simulation simulation(level);
  run(simulation, 2);
  ASSERT_EQ(pieces(simulation, rope), 1);
  ribbon::box2d::CordRef cord = simulation.scene().coupling().cord(0);
  for (int p = 0; p < 41; ++p) cord.direct().set_velocity(p, {25.0, 0.0});
  run(simulation, 3);
  EXPECT_EQ(pieces(simulation, rope), 2);
}

TEST(Blade, GoesWithTheBodyThatCarriesIt) {
  MapObject carrier = disc_of(30, "circle", {5.0, 8.0}, 0.3);
  carrier.properties.insert("body", std::string("kinematic"));
  carrier.properties.insert("velocity_x", 3.0);
  MapObject edge = blade({{5.0, 8.02}, {6.0, 8.02}});
  edge.properties.insert("body", std::int64_t{30});
  const Level level = level_of(small_map({hanging_rope(rope, {10.0, 10.0}), carrier, edge}));
  Simulation simulation(level);
  run(simulation, 60);
  EXPECT_EQ(pieces(simulation, rope), 1);
  EXPECT_NEAR(simulation.rules().blades().edge(0)[1].x, 9.0, 1e-4);
  run(simulation, 30);
  EXPECT_EQ(pieces(simulation, rope), 2);
  expect_goes_back(level, 120, {0});
}

TEST(Blade, ARopeIsWholeAgainAfterAFallAndARestart) {
  const Level level = level_with(blade({{9.5, 8.02}, {10.5, 8.02}}));
  for (const int button : {static_cast<int>(button_retry), static_cast<int>(button_restart)}) {
    Simulation simulation(level);
    run(simulation, 30);
    ASSERT_EQ(pieces(simulation, rope), 2);
    simulation.tick(press(button));
    EXPECT_EQ(pieces(simulation, rope), 2) << "whole, and cut again in the same tick";
    Simulation fresh(level);
    run(fresh, 1);
    const auto now = simulation.scene().coupling().cords();
    const auto then = fresh.scene().coupling().cords();
    ASSERT_EQ(now.size(), then.size());
    for (std::size_t k = 0; k < now.size(); ++k) {
      const auto a = simulation.scene().coupling().cord(now[k]).positions();
      const auto b = fresh.scene().coupling().cord(then[k]).positions();
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t p = 0; p < a.size(); ++p) EXPECT_EQ(a[p], b[p]);
    }
  }
}

TEST(Blade, IsRefusedWithTheObjectAndPropertyNamed) {
  EXPECT_NE(level_refusal({point_of(20, "blade", {5.0, 5.0})})
                .find("object 20: the shape of a blade is point; accepted is polyline, rectangle"),
            std::string::npos);
  MapObject edge = blade({{5.0, 5.0}, {6.0, 5.0}});
  edge.properties.insert("body", std::int64_t{77});
  EXPECT_NE(level_refusal({edge}).find("property \"body\" is 77, and there is no such object; accepted is the id of"),
            std::string::npos);
  MapObject of_goal = blade({{5.0, 5.0}, {6.0, 5.0}});
  of_goal.properties.insert("body", std::int64_t{2});
  EXPECT_NE(level_refusal({of_goal}).find("property \"body\" is 2, an object of class \"goal\""), std::string::npos);
}

/// A level with a knife, or without, whose player holds the rope at (6, 7).
struct Hanging {
  explicit Hanging(bool knife, std::vector<MapObject> others = {}) : level(made(knife, std::move(others))) {
    run(simulation, 20, button_grab);
  }
  static Level made(bool knife, std::vector<MapObject> others) {
    others.push_back(hanging_rope(rope, {6.0, 7.0}));
    engine::TiledMap map = small_map(std::move(others), {6.0, 3.0});
    map.properties.insert("knife", knife);
    return level_of(std::move(map));
  }
  ribbon::box2d::CordPoint held() const {
    return *simulation.scene().coupling().body(simulation.player().body()).held_place();
  }

  Level level;
  Simulation simulation{level};
};

TEST(Knife, CutsTheHeldCordBelowTheHand) {
  Hanging hanging(true);
  const double arc =
      hanging.simulation.scene().coupling().cord(hanging.held().cord).arc(hanging.held().point, hanging.held().along);
  run(hanging.simulation, 1, button_grab | button_cut);
  ASSERT_EQ(pieces(hanging.simulation, rope), 2);
  const ribbon::box2d::CordView cord = hanging.simulation.scene().coupling().cord(hanging.held().cord);
  EXPECT_EQ(cord.kind(0), ribbon::PointKind::constrained) << "it still hangs from the pin";
  const double end = cord.arc(cord.shape().columns - 1);
  EXPECT_GT(end, arc);
  EXPECT_LT(end, arc + 0.11) << "a link of 0.1 m at most is left below the hand";
  run(hanging.simulation, 30, button_grab | button_cut);
  EXPECT_EQ(pieces(hanging.simulation, rope), 2) << "a press cuts once";
}

TEST(Knife, CutsAnotherCordInReachFirst) {
  Hanging both(true, {hanging_rope(11, {6.7, 8.0})});
  const CordId held = both.held().cord;
  const int object = both.simulation.scene().cord_object(held);
  const int other = object == rope ? 11 : rope;
  run(both.simulation, 1, button_grab | button_cut);
  EXPECT_EQ(pieces(both.simulation, other), 2);
  EXPECT_EQ(pieces(both.simulation, object), 1);
  EXPECT_EQ(both.held().cord, held);
}

TEST(Knife, IsOnlyInLevelsWithTheProperty) {
  Hanging without(false);
  run(without.simulation, 2, button_grab | button_cut);
  EXPECT_EQ(pieces(without.simulation, rope), 1);
  engine::TiledMap map = small_map({});
  map.properties.insert("knife", 1.0);
  EXPECT_NE(level_refusal(map).find("property \"knife\" is 1, accepted is true or false"), std::string::npos);
}

TEST(Knife, DoesNotReachAcrossTheLevel) {
  engine::TiledMap map = small_map({hanging_rope(rope, {10.0, 7.0})});
  map.properties.insert("knife", true);
  const Level level = level_of(std::move(map));
  Simulation simulation(level);
  run(simulation, 2, button_cut);
  EXPECT_EQ(pieces(simulation, rope), 1);
}

TEST(Knife, ACutGoesBackAndIsGoneAfterAFall) {
  const Hanging hanging(true, {hanging_rope(11, {6.7, 8.0})});
  expect_goes_back(hanging.level, 160,
                   {button_grab, button_grab, button_grab | button_cut, button_grab | button_right});
  Simulation simulation(hanging.level);
  run(simulation, 20, button_grab);
  run(simulation, 1, button_grab | button_cut);
  EXPECT_EQ(pieces(simulation, rope) + pieces(simulation, 11), 3);
  run(simulation, 1, button_retry);
  EXPECT_EQ(pieces(simulation, rope) + pieces(simulation, 11), 2);
}

}  // namespace
}  // namespace game
