// A level whose ropes break under the player.

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "game/simulation/buttons.h"
#include "game/simulation/level.h"
#include "game/simulation/meter.h"
#include "game/simulation/simulation.h"
#include "tests/support/autopilot.h"

namespace game {
namespace {

/// first_swing with ropes that hold less than the player weighs.
Level level_of_weak_ropes() {
  nlohmann::json map = nlohmann::json::parse(std::ifstream(assets_folder() + "/levels/first_swing.tmj"));
  for (nlohmann::json& layer : map["layers"]) {
    for (nlohmann::json& object : layer["objects"]) {
      if (object["type"] != "cord") continue;
      object["properties"].push_back({{"name", "breaking_force"}, {"type", "float"}, {"value", 400.0}});
    }
  }
  Level level = load_level("first_swing");
  level.map = engine::parse_tiled_map(map.dump(), "weak.tmj");
  return level;
}

TEST(BreakingRope, BreaksUnderThePlayerWhichKeepsItsPiece) {
  const Level level = level_of_weak_ropes();
  Simulation simulation(level);
  Meter meter;
  test_support::Autopilot autopilot;
  const ribbon::box2d::Coupling& coupling = simulation.scene().coupling();
  const int cords = coupling.size();
  const auto held = [&] { return coupling.body(simulation.player().body()).held_place(); };
  const auto tick = [&](std::uint16_t buttons) {
    simulation.tick({buttons, {}});
    meter.add(simulation, 1000);
  };
  while (!held() && simulation.ticks() < 300) tick(autopilot.buttons(simulation));
  ASSERT_TRUE(held());
  const ribbon::box2d::CordId whole = held()->cord;
  const int object = simulation.scene().cord_object(whole);
  for (int k = 0; k < 120 && coupling.cord(whole).is_valid(); ++k) tick(button_grab);
  ASSERT_FALSE(coupling.cord(whole).is_valid());
  ASSERT_TRUE(held()) << "the hand is still on the rope, which falls";
  EXPECT_EQ(simulation.scene().cord_object(held()->cord), object);
  const Snapshot between = interpolate(simulation.previous(), simulation.current(), 0.5);
  for (const ribbon::box2d::CordId id : coupling.cords()) {
    EXPECT_EQ(between.cords[static_cast<std::size_t>(id)].size(), coupling.cord(id).positions().size());
  }
  for (int p = 0; p < static_cast<int>(coupling.cord(held()->cord).positions().size()); ++p) {
    EXPECT_EQ(coupling.cord(held()->cord).kind(p), ribbon::PointKind::free) << "nothing carries it";
  }
  for (int k = 0; k < 30; ++k) tick(button_grab);
  tick(button_restart);
  EXPECT_EQ(simulation.scene().coupling().size(), cords) << "whole again";
}

}  // namespace
}  // namespace game
