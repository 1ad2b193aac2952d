#include "tests/support/small_level.h"

namespace test_support {

using engine::MapObject;
using engine::MapShape;
using ribbon::Vec2;

MapObject object(const std::string& kind, MapShape shape, Vec2 position, Vec2 size,
                 const std::vector<Property>& properties) {
  MapObject made;
  made.kind = kind;
  made.shape = shape;
  made.position = position;
  made.size = size;
  for (const auto& [name, value] : properties) made.properties.insert(name, value);
  return made;
}

MapObject ground(Vec2 low, Vec2 high, const std::vector<Property>& properties) {
  return object("ground", MapShape::rectangle, 0.5 * (low + high), high - low, properties);
}

MapObject crate(Vec2 foot, Vec2 size, double mass, const std::vector<Property>& properties) {
  MapObject made = object("load", MapShape::rectangle, foot + Vec2{0.0, 0.5 * size.y}, size, properties);
  made.properties.insert("mass", mass);
  return made;
}

MapObject hook(Vec2 position) { return object("hook", MapShape::point, position); }

game::Level small_level(Vec2 feet, std::vector<MapObject> objects, const std::vector<Property>& properties) {
  engine::TiledMap map;
  map.file = "small.tmj";
  map.size = {40.0, 20.0};
  for (const auto& [name, value] : properties) map.properties.insert(name, value);
  map.objects = std::move(objects);
  map.objects.push_back(ground({0.0, 0.0}, {40.0, 1.0}));
  map.objects.push_back(object("player", MapShape::point, feet));
  map.objects.push_back(object("goal", MapShape::rectangle, {38.0, 2.0}, {1.0, 2.0}));
  for (std::size_t k = 0; k < map.objects.size(); ++k) map.objects[k].id = static_cast<int>(k) + 1;
  return game::level_of(std::move(map));
}

}  // namespace test_support
