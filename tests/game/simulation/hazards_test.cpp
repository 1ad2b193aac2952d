// Fires, spikes, chasers and coins.

#include <gtest/gtest.h>

#include "tests/game/simulation/small_level.h"

namespace game {
namespace {

constexpr int rope_id = 10;

MapObject fire(Vec2 center, Vec2 size, double seconds) {
  MapObject object = box_of(20, "fire", center, size);
  object.properties.insert("seconds", seconds);
  return object;
}

TEST(Fire, BurnsACordThroughAfterItsSeconds) {
  const Level level = level_of(small_map({hanging_rope(rope_id, {10.0, 10.0}), fire({10.0, 8.0}, {0.5, 0.05}, 0.5)}));
  Simulation simulation(level);
  run(simulation, 15);
  EXPECT_NEAR(simulation.rules().burning().heat(0, 20), 0.5, 1e-9);
  EXPECT_EQ(simulation.rules().burning().heat(0, 10), 0.0);
  run(simulation, 14);
  EXPECT_EQ(pieces(simulation, rope_id), 1);
  run(simulation, 1);
  EXPECT_EQ(pieces(simulation, rope_id), 2) << "after 30 ticks";
  const auto ids = simulation.scene().coupling().cords();
  EXPECT_EQ(simulation.scene().coupling().cord(ids[0]).shape().columns, 21);
  run(simulation, 1);
  EXPECT_EQ(simulation.rules().burning().char_of(ids[0], 20), 1.0) << "its end stays black";
  EXPECT_EQ(simulation.rules().burning().char_of(ids[1], 0), 1.0);
}

TEST(Fire, DoesNotBurnWhatOnlyPassesAndItCools) {
  const Level level = level_of(small_map({hanging_rope(rope_id, {10.0, 10.0}), fire({10.0, 8.0}, {0.5, 0.05}, 1.0)}));
  Simulation simulation(level);
  run(simulation, 30);
  simulation.scene().coupling().cord(0).pin(0, {14.0, 10.0});
  run(simulation, 100);
  EXPECT_EQ(pieces(simulation, rope_id), 1);
  EXPECT_LT(simulation.rules().burning().heat(0, 20), 0.5);
  EXPECT_GE(simulation.rules().burning().char_of(0, 20), 0.5);
}

TEST(Fire, BurnsAgainAfterAFallAsFromTheStart) {
  const Level level = level_of(small_map({hanging_rope(rope_id, {10.0, 10.0}), fire({10.0, 8.0}, {0.5, 0.05}, 0.5)}));
  for (const int button : {static_cast<int>(button_retry), static_cast<int>(button_restart)}) {
    Simulation simulation(level);
    run(simulation, 20);
    run(simulation, 1, button);
    EXPECT_EQ(pieces(simulation, rope_id), 1);
    run(simulation, 28);
    EXPECT_EQ(pieces(simulation, rope_id), 1);
    run(simulation, 1);
    EXPECT_EQ(pieces(simulation, rope_id), 2);
  }
  expect_goes_back(level, 100, {0});
}

TEST(Fire, AndSpikesKillThePlayer) {
  for (const char* const kind : {"fire", "spikes"}) {
    const Level level = level_of(small_map({box_of(20, kind, {6.0, 2.5}, {1.0, 1.0})}));
    Simulation simulation(level);
    run(simulation, 10, button_right);
    EXPECT_EQ(simulation.falls(), 0);
    for (int k = 0; k < 60 && simulation.falls() == 0; ++k) {
      EXPECT_LT(simulation.player().position().x, 5.3);
      run(simulation, 1, button_right);
    }
    EXPECT_EQ(simulation.falls(), 1) << kind;
    EXPECT_NEAR(simulation.player().position().x, 3.0, 0.2);
  }
}

TEST(Fire, AndSpikesAreRefusedWithTheReason) {
  EXPECT_NE(level_refusal({disc_of(20, "fire", {5.0, 5.0}, 1.0)}).find("the shape of a fire is ellipse; accepted is"),
            std::string::npos);
  EXPECT_NE(level_refusal({fire({5.0, 5.0}, {1.0, 1.0}, 0.0)}).find("\"seconds\" is 0, accepted is a number from 0.05"),
            std::string::npos);
  MapObject turned = box_of(20, "spikes", {5.0, 5.0}, {1.0, 1.0});
  turned.rotation = 0.3;
  EXPECT_NE(level_refusal({turned}).find("is rotated; accepted is the rotation 0"), std::string::npos);
}

constexpr int way = 30;

MapObject chaser(double speed) {
  MapObject object = disc_of(20, "chaser", {2.0, 6.0}, 0.5);
  object.properties.insert("path", std::int64_t{way});
  object.properties.insert("speed", speed);
  return object;
}
MapObject high_way() { return line_of(way, "path", {{2.0, 6.0}, {12.0, 6.0}, {12.0, 10.0}}); }

TEST(Chaser, FollowsItsPathToItsEnd) {
  const Level level = level_of(small_map({chaser(5.0), high_way()}));
  Simulation simulation(level);
  run(simulation, 60);
  EXPECT_NEAR(simulation.rules().chase().position(0, 1.0).x, 7.0, 1e-9);
  EXPECT_NEAR(simulation.rules().chase().position(0, 0.0).x, 7.0 - 5.0 / 60.0, 1e-9);
  run(simulation, 240);
  EXPECT_EQ(simulation.rules().chase().position(0, 1.0), (Vec2{12.0, 10.0}));
}

TEST(Chaser, WaitsUntilThePlayerPasses) {
  MapObject object = chaser(5.0);
  object.properties.insert("from_x", 5.0);
  const Level level = level_of(small_map({object, high_way()}));
  Simulation simulation(level);
  run(simulation, 60);
  EXPECT_FALSE(simulation.rules().chase().is_running(0));
  while (simulation.player().position().x < 5.0) {
    ASSERT_LT(simulation.ticks(), 600);
    run(simulation, 1, button_right);
  }
  run(simulation, 13);
  EXPECT_NEAR(simulation.rules().chase().position(0, 1.0).x, 2.0 + 13.0 * 5.0 / 60.0, 1e-9);
  run(simulation, 1, button_retry);
  EXPECT_FALSE(simulation.rules().chase().is_running(0)) << "it is back, and waits again";
  EXPECT_EQ(simulation.rules().chase().position(0, 1.0), (Vec2{2.0, 6.0}));
}

TEST(Chaser, KillsWhatItTouchesAndIsBackAtItsStart) {
  MapObject object = chaser(8.0);
  object.position = {0.5, 2.8};
  const Level level = level_of(small_map({object, line_of(way, "path", {{0.5, 2.8}, {30.0, 2.8}})}));
  Simulation simulation(level);
  run(simulation, 12);
  EXPECT_EQ(simulation.falls(), 0);
  run(simulation, 1);  // 0.5 + 13 · 8 / 60 + 0.5 + 0.3 > 3
  EXPECT_EQ(simulation.falls(), 1);
  EXPECT_EQ(simulation.rules().chase().position(0, 1.0), (Vec2{0.5, 2.8}));
  MapObject square = box_of(20, "chaser", {0.5, 2.8}, {1.0, 1.0});
  square.properties.insert("path", std::int64_t{way});
  square.properties.insert("speed", 8.0);
  const Level other = level_of(small_map({square, line_of(way, "path", {{0.5, 2.8}, {30.0, 2.8}})}));
  Simulation boxed(other);
  run(boxed, 12);
  EXPECT_EQ(boxed.falls(), 0);
  run(boxed, 1);
  EXPECT_EQ(boxed.falls(), 1);
  expect_goes_back(other, 100, {0});
}

TEST(Chaser, WithoutFallsThePlayerGoesOnAndTheChaserIsBack) {
  MapObject object = chaser(8.0);
  object.position = {0.5, 2.8};
  Level level = level_of(small_map({object, line_of(way, "path", {{0.5, 2.8}, {30.0, 2.8}})}));
  level.assists.no_fall = true;
  Simulation simulation(level);
  run(simulation, 14);
  EXPECT_EQ(simulation.falls(), 0);
  EXPECT_LT(simulation.rules().chase().position(0, 1.0).x, 1.0);
}

/// A slack rope from (6, 6) to (10, 6), which the chaser needs.
TEST(Chaser, FallsWhereItsCordIsCut) {
  MapObject bridge = line_of(rope_id, "cord", {{6.0, 6.0}, {10.0, 6.0}});
  bridge.properties.insert("columns", std::int64_t{41});
  bridge.properties.insert("mass", 2.0);
  bridge.properties.insert("pin_first", true);
  bridge.properties.insert("pin_last", true);
  MapObject object = chaser(5.0);
  object.properties.insert("cord", std::int64_t{rope_id});
  const Level whole = level_of(small_map({bridge, object, high_way()}));
  Simulation passing(whole);
  run(passing, 100);
  EXPECT_NEAR(passing.rules().chase().position(0, 1.0).x, 2.0 + 500.0 / 60.0, 1e-9);
  EXPECT_FALSE(passing.rules().chase().has_fallen(0));
  const Level cut = level_of(small_map({bridge, object, high_way(), line_of(21, "blade", {{8.02, 5.0}, {8.02, 7.0}})}));
  Simulation falling(cut);
  run(falling, 100);
  EXPECT_TRUE(falling.rules().chase().has_fallen(0));
  EXPECT_LT(falling.rules().chase().position(0, 1.0).y, 3.0);
  EXPECT_NEAR(falling.rules().chase().position(0, 1.0).x, 6.0, 0.1);
  run(falling, 1, button_retry);
  EXPECT_FALSE(falling.rules().chase().has_fallen(0));
  expect_goes_back(cut, 100, {0});
}

TEST(Chaser, IsRefusedWithTheObjectAndPropertyNamed) {
  EXPECT_NE(level_refusal({chaser(3.0)}).find("property \"path\" is 30, and there is no such object; accepted is the"),
            std::string::npos);
  MapObject without = disc_of(20, "chaser", {2.0, 6.0}, 0.5);
  EXPECT_NE(level_refusal({without}).find("property \"path\" is missing"), std::string::npos);
  EXPECT_NE(level_refusal({chaser(0.0), high_way()}).find("\"speed\" is 0, accepted is a number from 0.01 to 100"),
            std::string::npos);
  MapObject far = chaser(1.0);
  far.position.y = 7.0;
  EXPECT_NE(level_refusal({far, high_way()}).find("its centre is 1 m from its path"), std::string::npos);
  MapObject flat = chaser(1.0);
  flat.size.y = 0.5;
  EXPECT_NE(level_refusal({flat, high_way()}).find("accepted is one as wide as high"), std::string::npos);
  MapObject no_cord = chaser(1.0);
  no_cord.properties.insert("cord", std::int64_t{way});
  EXPECT_NE(level_refusal({no_cord, high_way()}).find("\"cord\" is 30, an object of class \"path\""),
            std::string::npos);
}

TEST(Coin, IsCollectedByTouchAndKeptAfterAFall) {
  const Level level = level_of(small_map({point_of(20, "coin", {5.0, 2.5}), point_of(21, "coin", {8.0, 9.0}),
                                          box_of(22, "spikes", {7.0, 2.5}, {0.5, 1.0})}));
  Simulation simulation(level);
  EXPECT_EQ(simulation.coins(), 0);
  run(simulation, 40, button_right);
  EXPECT_EQ(simulation.coins(), 1);
  EXPECT_TRUE(simulation.rules().has_coin(0));
  while (simulation.falls() == 0) {
    ASSERT_LT(simulation.ticks(), 600);
    run(simulation, 1, button_right);
  }
  EXPECT_EQ(simulation.coins(), 1);
  run(simulation, 1, button_restart);
  EXPECT_EQ(simulation.coins(), 0);
  expect_goes_back(level, 100, {button_right});
}

TEST(Coin, IsPartOfTheHash) {
  const Level level = level_of(small_map({point_of(20, "coin", {3.0, 2.5})}));
  const Level without = level_of(small_map({point_of(20, "coin", {13.0, 2.5})}));
  Simulation one(level);
  Simulation other(without);
  EXPECT_EQ(one.hash(), other.hash());
  run(one, 1);
  run(other, 1);
  EXPECT_NE(one.hash(), other.hash());
}

TEST(Coin, IsAPoint) {
  EXPECT_NE(level_refusal({box_of(20, "coin", {5.0, 2.5}, {1.0, 1.0})}).find("the shape of a coin is rectangle"),
            std::string::npos);
}

/// Each property with values of each type: the level runs, or the message names object, property and what is accepted.
TEST(Hazards, HostilePropertiesAreAcceptedOrRefusedByName) {
  using Value = engine::Properties::Value;
  const std::vector<Value> hostile = {-1.0,
                                      0.0,
                                      1e-300,
                                      1e300,
                                      std::int64_t{-1},
                                      std::int64_t{0},
                                      std::int64_t{99},
                                      1e308,
                                      true,
                                      std::string("a"),
                                      std::int64_t{4294967326}};
  const std::vector<std::pair<MapObject, std::vector<const char*>>> objects = {
      {box_of(20, "blade", {5.0, 5.0}, {1.0, 1.0}), {"body", "unknown"}},
      {box_of(20, "fire", {5.0, 5.0}, {1.0, 1.0}), {"seconds"}},
      {box_of(20, "spikes", {5.0, 5.0}, {1.0, 1.0}), {"seconds"}},
      {disc_of(20, "chaser", {2.0, 6.0}, 0.5), {"path", "speed", "from_x", "cord"}},
      {point_of(20, "coin", {5.0, 5.0}), {"seconds"}}};
  for (const auto& [object, names] : objects) {
    for (const char* const name : names) {
      for (const Value& value : hostile) {
        MapObject changed = object;
        changed.properties.insert(name, value);
        if (object.kind == "chaser") changed.properties.insert("path", std::int64_t{way});
        try {
          const Level level = level_of(small_map({changed, high_way()}));
          Simulation simulation(level);
          run(simulation, 3, button_right);
        } catch (const engine::MapError& error) {
          const std::string message = error.what();
          EXPECT_NE(message.find("object 20"), std::string::npos) << message;
          EXPECT_NE(message.find(name), std::string::npos) << message;
          EXPECT_NE(message.find("accepted"), std::string::npos) << message;
        }
      }
    }
  }
}

}  // namespace
}  // namespace game
