#include "tests/support/mixed_level.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace test_support {
namespace {

using nlohmann::json;

/// Keeps the properties that both solvers have.
json of_either_solver(const json& properties) {
  json kept = json::array();
  for (const json& property : properties) {
    const std::string name = property["name"];
    if (name == "columns" || name == "mass" || name == "drag" || name.starts_with("pin_")) kept.push_back(property);
  }
  return kept;
}

}  // namespace

std::string mixed_swing_map() {
  json map = json::parse(std::ifstream(game::assets_folder() + "/levels/first_swing.tmj"));
  for (json& layer : map["layers"]) {
    for (json& object : layer["objects"]) {
      if (object["type"] != "cord" || object["name"] == "hammock") continue;
      json& properties = object["properties"];
      properties = of_either_solver(properties);
      properties.push_back({{"name", "solver"}, {"type", "string"}, {"value", "direct"}});
    }
  }
  return map.dump();
}

game::Level mixed_swing() {
  game::Level level = game::load_level("first_swing");
  level.name = "mixed_swing";
  level.map = engine::parse_tiled_map(mixed_swing_map(), "mixed_swing.tmj");
  return level;
}

}  // namespace test_support
