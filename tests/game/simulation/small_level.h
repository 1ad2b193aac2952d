#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "game/simulation/buttons.h"
#include "game/simulation/simulation.h"
#include "tests/engine/scene/scene_map.h"
#include "tests/game/simulation/press.h"

// Levels of a few objects, made in code. Lengths are in m. Objects with the id 0 get one from small_map.

namespace game {

using engine::MapObject;
using engine::MapShape;
using ribbon::Vec2;

/// A rope of 4 m with 41 points that hangs from `top`, pinned there unless told otherwise.
inline MapObject hanging_rope(int id, Vec2 top, bool pinned = true) {
  MapObject rope = engine::thing(id, "cord", MapShape::polyline, top);
  rope.points = {top, top - Vec2{0.0, 4.0}};
  rope.properties.insert("columns", std::int64_t{41});
  rope.properties.insert("mass", 2.0);
  rope.properties.insert("pin_first", pinned);
  rope.properties.insert("damping", 0.05);
  return rope;
}

inline MapObject line_of(int id, const std::string& kind, std::vector<Vec2> points) {
  MapObject object = engine::thing(id, kind, MapShape::polyline, points.front());
  object.points = std::move(points);
  return object;
}

inline MapObject box_of(int id, const std::string& kind, Vec2 center, Vec2 size) {
  return engine::thing(id, kind, MapShape::rectangle, center, size);
}

inline MapObject disc_of(int id, const std::string& kind, Vec2 center, double radius) {
  return engine::thing(id, kind, MapShape::ellipse, center, {2.0 * radius, 2.0 * radius});
}

inline MapObject point_of(int id, const std::string& kind, Vec2 at) {
  return engine::thing(id, kind, MapShape::point, at);
}

/// A ground between two corners.
inline MapObject ground(Vec2 low, Vec2 high) { return box_of(0, "ground", 0.5 * (low + high), high - low); }

/// A crate that stands on `foot`.
inline MapObject crate(Vec2 foot, Vec2 size, double mass) {
  MapObject load = box_of(0, "load", foot + Vec2{0.0, 0.5 * size.y}, size);
  load.properties.insert("mass", mass);
  return load;
}

/// The same object, at which lines can be thrown.
inline MapObject sticky(MapObject object) {
  object.properties.insert("sticky", true);
  return object;
}

/// Returns the map of a level of 40 by 20 m with a ground from x = 0 to 40 m up to y = `top`, a player whose feet are
/// at `feet`, a goal on the ground at x = 38, and these objects, whose ids are 0, or begin at 10.
inline engine::TiledMap small_map(std::vector<MapObject> objects, Vec2 feet = {3.0, 2.0}, double top = 2.0) {
  int next = 100;
  for (MapObject& object : objects) {
    if (object.id == 0) object.id = next++;
  }
  objects.push_back(point_of(1, "player", feet));
  objects.push_back(box_of(2, "goal", {38.0, top + 1.0}, {1.0, 2.0}));
  objects.push_back(box_of(3, "ground", {20.0, 0.5 * top}, {40.0, top}));
  engine::TiledMap map = engine::map_of(std::move(objects));
  map.properties = engine::Properties("test.tmj: map");
  map.size = {40.0, 20.0};
  return map;
}

inline std::string level_refusal(const engine::TiledMap& map) {
  return test_support::refusal<engine::MapError>([&] { level_of(map); });
}
inline std::string level_refusal(std::vector<MapObject> objects) {
  return level_refusal(small_map(std::move(objects)));
}

/// Returns the number of cords from an object of the map.
inline int pieces(const Simulation& simulation, int object) {
  int count = 0;
  for (const ribbon::box2d::CordId id : simulation.scene().coupling().cords())
    count += simulation.scene().cord_object(id) == object ? 1 : 0;
  return count;
}

/// Checks that a run goes back: from each of some ticks on, it has the same bits when it is repeated from a saved
/// state.
inline void expect_goes_back(const Level& level, int ticks, const std::vector<int>& buttons) {
  Simulation simulation(level);
  for (b2Body* body = simulation.scene().world().GetBodyList(); body != nullptr; body = body->GetNext())
    body->SetSleepingAllowed(false);
  const auto pressed = [&buttons](int tick) { return press(buttons[static_cast<std::size_t>(tick) % buttons.size()]); };
  SavedTick before;
  SavedTick saved;
  for (int k = 0; k < ticks; ++k) {
    if (k % 16 == 14) simulation.save(before);
    if (k % 16 == 15) simulation.save(saved);
    simulation.tick(pressed(k));
    if (k % 16 != 15 || k < 16) continue;
    std::vector<ribbon::box2d::StateHash> hashes{simulation.hash()};
    for (int ahead = 1; ahead < 8; ++ahead) {
      simulation.tick(pressed(k + ahead));
      hashes.push_back(simulation.hash());
    }
    ASSERT_TRUE(simulation.restore(saved, &before));
    for (int again = 0; again < 8; ++again) {
      simulation.tick(pressed(k + again));
      ASSERT_EQ(simulation.hash(), hashes[static_cast<std::size_t>(again)]) << "tick " << k + again;
    }
    k += 7;
  }
}

}  // namespace game
