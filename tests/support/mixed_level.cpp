#include "tests/support/mixed_level.h"

#include <fstream>
#include <nlohmann/json.hpp>

namespace test_support {
namespace {

using nlohmann::json;

constexpr double player_mass = 5.0;  // kg, which cords of the thesis's method carry with little stretch

/// A cord of the thesis's method with all properties of this one that both solvers have.
json of_the_thesis(const json& properties) {
  json changed = json::array();
  for (const json& property : properties) {
    const std::string name = property["name"];
    if (name == "columns" || name == "mass" || name.starts_with("pin_")) changed.push_back(property);
  }
  changed.push_back({{"name", "solver"}, {"type", "string"}, {"value", "thesis"}});
  changed.push_back({{"name", "spring_stiffness"}, {"type", "float"}, {"value", 30000.0}});
  changed.push_back({{"name", "bar_damping"}, {"type", "float"}, {"value", 60.0}});
  changed.push_back({{"name", "drag"}, {"type", "float"}, {"value", 0.02}});
  changed.push_back({{"name", "substeps"}, {"type", "int"}, {"value", 16}});
  return changed;
}

}  // namespace

std::string mixed_swing_map() {
  json map = json::parse(std::ifstream(game::assets_folder() + "/levels/first_swing.tmj"));
  for (json& layer : map["layers"]) {
    for (json& object : layer["objects"]) {
      if (object["type"] == "player") {
        object["properties"] = json::array({{{"name", "mass"}, {"type", "float"}, {"value", player_mass}}});
      } else if (object["type"] == "cord" && object["name"] != "hammock") {
        object["properties"] = of_the_thesis(object["properties"]);
      }
    }
  }
  return map.dump();
}

game::Level mixed_swing() {
  game::Level level = game::load_level("first_swing");
  level.name = "mixed_swing";
  level.map = engine::parse_tiled_map(mixed_swing_map(), "mixed_swing.tmj");
  level.player_mass = player_mass;
  return level;
}

}  // namespace test_support
