#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "engine/scene/tiled_map.h"
#include "tests/support/refusal.h"

namespace engine {

using nlohmann::json;
using test_support::refusal;

inline const std::string file = "levels/swing.tmj";

/// Returns a JSON array. (Braces around one element would make the element itself.)
template <class... Items>
json list(const Items&... items) {
  return json::array({json(items)...});
}

inline json at(double x, double y) { return {{"x", x}, {"y", y}}; }

/// A map of 10 × 5 tiles of 32 px: 320 × 160 px, 5 × 2.5 m at 64 px a metre.
inline json map_of(const json& objects) {
  const json layer = {{"type", "objectgroup"}, {"name", "things"}, {"objects", objects}};
  return {{"type", "map"},     {"version", "1.10"}, {"orientation", "orthogonal"},
          {"infinite", false}, {"width", 10},       {"height", 5},
          {"tilewidth", 32},   {"tileheight", 32},  {"layers", list(layer)}};
}

inline json object_at(double x, double y) { return {{"id", 12}, {"name", "rope"}, {"x", x}, {"y", y}}; }

inline json rectangle(double x, double y, double width, double height, double rotation = 0.0) {
  json object = object_at(x, y);
  object.update({{"width", width}, {"height", height}, {"rotation", rotation}});
  return object;
}

inline json polyline(double x, double y, const json& points, double rotation = 0.0) {
  json object = object_at(x, y);
  object.update({{"polyline", points}, {"rotation", rotation}});
  return object;
}

inline json property(const char* name, const char* type, const json& value) {
  return {{"name", name}, {"type", type}, {"value", value}};
}

inline json point(const json& properties = json::array()) {
  json object = object_at(32, 32);
  object.update({{"point", true}, {"properties", properties}});
  return object;
}

inline TiledMap load(const json& map) { return parse_tiled_map(map.dump(), file); }
inline MapObject load_object(const json& object) { return load(map_of(list(object))).objects.at(0); }

template <typename Call>
std::string error_of(const Call& call) {
  return refusal<MapError>(call);
}

inline std::string error_of(const json& map) {
  return error_of([&] { load(map); });
}
inline std::string object_error(const json& object) { return error_of(map_of(list(object))); }

}  // namespace engine
