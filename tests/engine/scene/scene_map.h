#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "tests/support/refusal.h"

namespace engine {

/// Returns an object of a map without properties; its messages begin with "test.tmj: object ID".
inline MapObject thing(int id, const std::string& kind, MapShape shape, ribbon::Vec2 position, ribbon::Vec2 size = {}) {
  MapObject object;
  object.id = id;
  object.kind = kind;
  object.shape = shape;
  object.position = position;
  object.size = size;
  object.properties = Properties("test.tmj: object " + std::to_string(id));
  return object;
}

/// Returns a map of 10 by 10 m.
inline TiledMap map_of(std::vector<MapObject> objects) {
  TiledMap map;
  map.file = "test.tmj";
  map.size = {10.0, 10.0};
  map.objects = std::move(objects);
  return map;
}

/// Returns the message with which a map is refused.
inline std::string refusal(const TiledMap& map) {
  return test_support::refusal<MapError>([&] { const Scene scene(map); });
}

}  // namespace engine
