#include "tests/support/level_for_two.h"

#include <nlohmann/json.hpp>
#include <string>

namespace test_support {
namespace {

using nlohmann::json;

constexpr double height = 14.0;  // m, of the map
constexpr double pixels = 64.0;  // per metre

json property(const char* name, const char* type, const json& value) {
  return {{"name", name}, {"type", type}, {"value", value}};
}

json point(int id, const char* kind, double x, double y) {
  return {{"id", id},      {"name", ""},     {"type", kind}, {"x", pixels * x}, {"y", pixels * (height - y)},
          {"point", true}, {"rotation", 0.0}};
}

/// `x`, `y`: its lower left corner, m.
json rectangle(int id, const char* kind, double x, double y, double wide, double high) {
  return {{"id", id},
          {"name", ""},
          {"type", kind},
          {"x", pixels * x},
          {"y", pixels * (height - y - high)},
          {"width", pixels * wide},
          {"height", pixels * high},
          {"rotation", 0.0}};
}

json rope_on_the_ground(int id) {
  json rope = point(id, "cord", 8.0, 4.75);
  rope.erase("point");
  rope["polyline"] = json::array();
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.0, -0.69}, {6.0, -0.69}, {6.0, 0.0}}) {
    rope["polyline"].push_back({{"x", pixels * x}, {"y", -pixels * y}});
  }
  rope["properties"] = {property("columns", "int", 38), property("mass", "float", 3.0),
                        property("friction", "float", 0.4), property("damping", "float", 0.02),
                        property("radius", "float", 0.06)};
  return rope;
}

}  // namespace

game::Level level_for_two(const LevelForTwo& options) {
  json post = rectangle(6, "circle", 20.75, 7.75, 0.5, 0.5);
  post["ellipse"] = true;
  json second = point(2, "player_2", 14.0, 4.0);
  // clang reads {x} as x, g++ as a list of it.
  second["properties"] = json::array({property("mass", "float", options.second_mass)});
  if (options.tied) second["properties"].push_back(property("tether", "object", 7));
  json objects = {point(1, "player", 8.0, 4.0),
                  second,
                  rectangle(3, "goal", 39.5, 4.0, 1.0, 2.0),
                  rectangle(4, "ground", 0.0, 0.0, 16.0, 4.0),
                  rectangle(5, "ground", 26.0, 0.0, 18.0, 4.0),
                  post,
                  rope_on_the_ground(7)};
  if (options.knows_checkpoint) objects.push_back(rectangle(8, "checkpoint", 11.5, 4.0, 1.0, 2.0));
  const json map = {{"type", "map"},
                    {"orientation", "orthogonal"},
                    {"width", 44},
                    {"height", static_cast<int>(height)},
                    {"tilewidth", 64},
                    {"tileheight", 64},
                    {"infinite", false},
                    {"tilesets", json::array()},
                    {"layers", {{{"type", "objectgroup"}, {"name", "level"}, {"objects", objects}}}}};
  return game::level_of(engine::parse_tiled_map(map.dump(), "two.tmj"));
}

}  // namespace test_support
