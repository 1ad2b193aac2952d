#include "game/tuning/tuned_level.h"

#include <fstream>
#include <sstream>
#include <utility>

#include "engine/files/regular_file.h"
#include "engine/scene/scene_tuning.h"
#include "ribbon/box2d/state_hash.h"

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

/// Returns the cord of an object, or −1.
ribbon::box2d::CordId cord_of(const engine::Scene& scene, int object) {
  for (const ribbon::box2d::CordId cord : scene.coupling().cords()) {
    if (scene.cord_object(cord) == object) return cord;
  }
  return -1;
}

void set_gravity(b2World& world, const engine::Properties& properties) {
  const double gravity = properties.number_or("gravity_y", -9.81, {-1000.0, 1000.0});
  world.SetGravity({0.0F, static_cast<float>(gravity)});
}

}  // namespace

TunedLevel::TunedLevel(const Level& level) : file_text_(text_of(level.map.file)), text_(file_text_), level_(level) {
  if (ribbon::box2d::hash_bytes(file_text_) != level.map.content_hash) {
    throw engine::MapError(level.map.file +
                           ": the file has changed since the level was loaded; load it again to tune it");
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
  Level level = level_of(engine::parse_tiled_map(text, level_.map.file));
  level.assists = level_.assists;
  if (object == engine::map_itself) {
    set_gravity(scene.world(), level.map.properties);
  } else if (const ribbon::box2d::CordId cord = cord_of(scene, object); cord >= 0) {
    engine::retune(scene.coupling(), cord, *level.map.find(object));
  }
  text_ = std::move(text);
  level_ = std::move(level);
}

void TunedLevel::write() {
  const std::string& path = level_.map.file;
  if (text_of(path) != file_text_) {
    throw engine::MapError(path + ": the file has changed since it was read, and stays as it is");
  }
  engine::replace_file(path, text_);
  file_text_ = text_;
}

}  // namespace game
