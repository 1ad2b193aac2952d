#include "game/tuning/tuned_level.h"

#include <fstream>
#include <sstream>
#include <utility>

#include "engine/regular_file.h"
#include "engine/scene_tuning.h"
#include "engine/state_hash.h"

namespace game {
namespace {

std::string text_of(const std::string& path) {
  try {
    std::ostringstream text;
    text << engine::open_regular_file(path).rdbuf();
    return text.str();
  } catch (const std::runtime_error& error) {
    throw engine::MapError(error.what());
  }
}

bool is_cord(const engine::MapObject& object) { return object.kind == "cord" || object.kind == "ribbon"; }

engine::CordIndex cord_of(const engine::TiledMap& map, int id) {
  engine::CordIndex cord = 0;
  for (const engine::MapObject& object : map.objects) {
    if (object.id == id) return cord;
    if (is_cord(object)) ++cord;
  }
  return -1;
}

}  // namespace

TunedLevel::TunedLevel(const Level& level) : file_text_(text_of(level.map.file)), text_(file_text_), map_(level.map) {
  if (engine::hash_bytes(file_text_) != level.map.content_hash) {
    throw engine::MapError(level.map.file + ": the file has changed since the level was loaded; load it anew to tune it");
  }
}

void TunedLevel::set(int object, std::string_view property, const engine::Properties::Value& value,
                     engine::Scene& scene) {
  take(engine::with_property(text_, object, property, value), object, scene);
}

void TunedLevel::remove(int object, std::string_view property, engine::Scene& scene) {
  take(engine::without_property(text_, object, property), object, scene);
}

void TunedLevel::take(std::string text, int object, engine::Scene& scene) {
  engine::TiledMap map = engine::parse_tiled_map(text, map_.file);
  if (object == engine::map_itself) {
    scene.set_gravity(map);
  } else {
    const engine::MapObject* changed = map.find(object);
    if (is_cord(*changed)) engine::retune(scene.coupling(), cord_of(map, object), *changed);
  }
  text_ = std::move(text);
  map_ = std::move(map);
}

const engine::MapObject* TunedLevel::object_of(engine::CordIndex cord) const {
  for (const engine::MapObject& object : map_.objects) {
    if (is_cord(object) && cord-- == 0) return &object;
  }
  return nullptr;
}

Level TunedLevel::level() const { return level_of(map_); }

void TunedLevel::write() {
  level();  // what cannot be loaded is not written
  if (text_of(map_.file) != file_text_) {
    throw engine::MapError(map_.file + ": the file has changed since the level was loaded; it stays as it is");
  }
  engine::replace_file(map_.file, text_);
  file_text_ = text_;
}

}  // namespace game
