#include "game/simulation/level.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <system_error>

#include "game/simulation/line.h"
#include "game/simulation/player.h"
#include "game/simulation/tether.h"
#include "ribbon/pulley.h"

namespace game {
namespace {

using engine::MapObject;

const std::vector<std::string> own_kinds = {"player", "player_2", "goal",   "checkpoint", "hook", "text",
                                            "blade",  "fire",     "spikes", "chaser",     "coin"};
const std::vector<std::string> own_properties = {"title", "hint",  "number",        "sandbox",
                                                 "lines", "gold",  "silver",        "bronze",
                                                 "knife", "place", "line_substeps", "line_tolerance"};
constexpr engine::NumberRange medal_seconds{0.1, 3600.0};
constexpr std::size_t max_text_bytes = 120;

void check_shape(const MapObject& object, engine::MapShape shape) {
  if (object.shape == shape) return;
  throw object.error("the shape of a " + object.kind + " is " + std::string(engine::shape_name(object.shape)) +
                     "; accepted is " + std::string(engine::shape_name(shape)));
}

/// Returns the only object of a class, or null if there is none.
const MapObject* find_only(const engine::TiledMap& map, const std::string& kind, engine::MapShape shape,
                           engine::Choices properties) {
  const MapObject* found = nullptr;
  for (const MapObject& object : map.objects) {
    if (object.kind != kind) continue;
    if (found != nullptr) throw object.error("is a second " + kind + "; accepted is one a level");
    check_shape(object, shape);
    found = &object;
  }
  if (found != nullptr) found->properties.check_known_properties(properties);
  return found;
}

const MapObject& only_object(const engine::TiledMap& map, const std::string& kind, engine::MapShape shape,
                             engine::Choices properties) {
  if (const MapObject* found = find_only(map, kind, shape, properties)) return *found;
  throw engine::MapError(map.file + ": no object of class " + kind + "; a level needs one");
}

std::string short_text(const engine::Properties& properties, const char* key) {
  std::string text = properties.text_or(key, "");
  if (text.size() <= max_text_bytes) return text;
  throw properties.error("property " + engine::in_quotes(key) + " has " + std::to_string(text.size()) +
                         " bytes; accepted are at most " + std::to_string(max_text_bytes));
}

Place read_place(const engine::Properties& properties) {
  const std::string name = properties.text_or("place", place_name(Place::hills), {"hills", "cave", "harbour", "storm"});
  return *std::find_if(places.begin(), places.end(), [&](Place place) { return place_name(place) == name; });
}

/// Returns none if the map leaves it to LineTuning.
std::optional<ribbon::Accuracy> read_line_accuracy(const engine::Properties& properties) {
  const ribbon::Accuracy usual = LineTuning{}.accuracy;
  ribbon::Accuracy accuracy = usual;
  accuracy.substeps = static_cast<int>(properties.integer_or("line_substeps", usual.substeps, {1, 256}));
  accuracy.tolerance = properties.number_or("line_tolerance", usual.tolerance, {1e-12, 1.0});
  return accuracy == usual ? std::nullopt : std::optional(accuracy);
}

void read_map_properties(Level& level) {
  const engine::Properties& p = level.map.properties;
  level.title = short_text(p, "title");
  if (level.title.empty()) level.title = level.name;
  level.hint = short_text(p, "hint");
  level.number = static_cast<int>(p.integer_or("number", 0, {0, 1000}));
  level.place = read_place(p);
  level.sandbox = p.boolean_or("sandbox", false);
  level.lines = static_cast<int>(p.integer_or("lines", 1, {1, Lines::most}));
  level.line_accuracy = read_line_accuracy(p);
  level.medals = {p.number_or("gold", 0.0, medal_seconds), p.number_or("silver", 0.0, medal_seconds),
                  p.number_or("bronze", 0.0, medal_seconds)};
  const Medals& m = level.medals;
  if (m.gold <= m.silver && m.silver <= m.bronze) return;
  throw level.map.properties.error("the medals are for " + engine::number_in_words(m.gold) + ", " +
                                   engine::number_in_words(m.silver) + " and " + engine::number_in_words(m.bronze) +
                                   " s; accepted are gold, silver and bronze in rising order, or none");
}

void read_markers(Level& level) {
  for (const MapObject& object : level.map.objects) {
    if (object.kind == "checkpoint") {
      check_shape(object, engine::MapShape::rectangle);
      object.properties.check_known_properties({});
      level.checkpoints.push_back({object.position, object.size});
    } else if (object.kind == "hook") {
      check_shape(object, engine::MapShape::point);
      object.properties.check_known_properties({});
      level.hooks.push_back(object.position);
    } else if (object.kind == "text") {
      check_shape(object, engine::MapShape::point);
      object.properties.check_known_properties({"text"});
      level.signs.push_back({object.position, short_text(object.properties, "text")});
    }
  }
}

/// Throws unless the cord that ties the players together is a rope of the direct solver from one to the other.
void check_tether(const Level& level, const MapObject& player_2, const engine::Scene& scene) {
  const ribbon::box2d::Coupling& coupling = scene.coupling();
  const auto cord = tether_of(level, scene);
  const std::string named = "property \"tether\" is " + std::to_string(level.second->tether);
  if (!cord || coupling.cord(*cord).solver() != ribbon::box2d::Solver::direct || coupling.cord(*cord).shape().rows != 1)
    throw player_2.error(named + "; accepted is the id of a cord of the direct solver with one row");
  const auto points = coupling.cord(*cord).positions();
  // What holds it would be lost where the cord is laid anew for players that were put elsewhere.
  bool is_free = pulleys_of(coupling.cord(*cord).direct()).empty();
  for (int p = 0; p < static_cast<int>(points.size()); ++p) {
    is_free = is_free && coupling.cord(*cord).kind(p) == ribbon::PointKind::free;
  }
  const bool meets_players = (coupling.cord(*cord).filter().maskBits & player_category) != 0;
  if (!is_free || meets_players)
    throw player_2.error(named + "; accepted is a cord without pins, anchors and wheels that is not solid");
  const ribbon::Vec2 waist{0.0, 0.5 * PlayerTuning{}.height};
  for (const double gap :
       {length(points.front() - level.player_start - waist), length(points.back() - level.second->start - waist)}) {
    if (gap <= Tether::max_gap) continue;
    throw player_2.error(named + ", a cord with an end " + engine::number_in_words(gap) +
                         " m from its player; accepted is one from the middle of player to that of player_2, within " +
                         engine::number_in_words(Tether::max_gap) + " m");
  }
}

/// Returns the accepted names for a message, or why there are none.
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
  return std::make_unique<engine::Scene>(map, own_kinds, all_but_players, own_properties);
}

std::optional<ribbon::box2d::CordId> tether_of(const Level& level, const engine::Scene& scene) {
  if (!level.second || level.second->tether == 0) return std::nullopt;
  for (const ribbon::box2d::CordId cord : scene.coupling().cords()) {
    if (scene.cord_object(cord) == level.second->tether) return cord;
  }
  return std::nullopt;
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
  const MapObject* second = find_only(level.map, "player_2", engine::MapShape::point, {"mass", "tether"});
  if (second != nullptr) {
    const engine::Properties& p = second->properties;
    level.second = SecondPlayer{second->position, p.number_or("mass", PlayerTuning{}.mass, {0.1, 1e4}),
                                static_cast<int>(p.integer_or("tether", 0, {0, std::numeric_limits<int>::max()}))};
  }
  read_map_properties(level);
  if (const MapObject* goal = level.sandbox ? find_only(level.map, "goal", engine::MapShape::rectangle, {})
                                            : &only_object(level.map, "goal", engine::MapShape::rectangle, {})) {
    level.goal = Area{goal->position, goal->size};
  }
  read_markers(level);
  level.rules = read_rules(level.map);
  const auto scene = level.make_scene();  // throws if the scene cannot be built
  if (level.second && level.second->tether != 0) check_tether(level, *second, *scene);
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
