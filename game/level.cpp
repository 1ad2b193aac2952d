#include "game/level.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "game/player.h"

namespace game {
namespace {

using engine::MapObject;

const std::vector<std::string> own_kinds = {"player", "goal"};

const MapObject& only_object(const engine::TiledMap& map, const std::string& kind, engine::MapShape shape,
                             engine::Choices properties) {
  const MapObject* found = nullptr;
  for (const MapObject& object : map.objects) {
    if (object.kind != kind) continue;
    if (found != nullptr) throw object.error("is a second " + kind + "; accepted is one a level");
    if (object.shape != shape) {
      throw object.error("the shape of a " + kind + " is " + std::string(engine::shape_name(object.shape)) +
                         "; accepted is " + std::string(engine::shape_name(shape)));
    }
    found = &object;
  }
  if (found == nullptr) throw engine::MapError(map.file + ": no object of class " + kind + "; a level needs one");
  found->properties.check_known_properties(properties);
  return *found;
}

/// The names that are accepted, or why there are none.
std::string known_levels() {
  std::string names;
  for (const std::string& known : level_names()) names += (names.empty() ? "" : ", ") + known;
  if (!names.empty()) return names;
  return "a name, but there are no levels in " + engine::in_quotes(assets_folder() + "/levels") +
         ": ROPESWING_ASSETS is to name the folder that holds them";
}

std::string path_of(const std::string& name) {
  if (name.ends_with(".tmj")) return name;
  return assets_folder() + "/levels/" + name + ".tmj";
}

}  // namespace

std::unique_ptr<engine::Scene> Level::make_scene() const {
  b2Filter all_but_players;
  all_but_players.maskBits = static_cast<std::uint16_t>(~player_category);
  return std::make_unique<engine::Scene>(map, own_kinds, all_but_players);
}

std::string assets_folder() {
  const char* chosen = std::getenv("ROPESWING_ASSETS");
  return chosen != nullptr ? chosen : GAME_SOURCE_ASSETS;
}

Level load_level(const std::string& name) {
  const std::string path = path_of(name);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw engine::MapError("no level " + engine::in_quotes(name) + " at " + engine::in_quotes(path) +
                           "; accepted is a .tmj file, or " + known_levels());
  }
  return level_of(engine::load_tiled_map(path));
}

Level level_of(engine::TiledMap map) {
  Level level;
  level.name = std::filesystem::path(map.file).stem().string();
  level.map = std::move(map);
  const MapObject& player = only_object(level.map, "player", engine::MapShape::point, {"mass"});
  level.player_start = player.position;
  level.player_mass = player.properties.number_or("mass", PlayerTuning{}.mass, {0.1, 1e4});
  const MapObject& goal = only_object(level.map, "goal", engine::MapShape::rectangle, {});
  level.goal_center = goal.position;
  level.goal_size = goal.size;
  level.make_scene();  // so that what cannot be built is refused here
  return level;
}

std::vector<std::string> level_names() {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(assets_folder() + "/levels", ignored)) {
    if (entry.path().extension() == ".tmj") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace game
