#include "tests/study/level_file.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "engine/scene/tiled_edit.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/study/figures.h"
#include "tests/study/text.h"

namespace study {
namespace {

std::string kind_of(const nlohmann::ordered_json& object) {
  for (const char* key : {"class", "type"}) {
    if (object.contains(key) && object[key].is_string()) return object[key].get<std::string>();
  }
  return {};
}

engine::Properties::Value value_of(const nlohmann::ordered_json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  return value.get<std::string>();
}

}  // namespace

LevelFile::LevelFile(const std::string& path) : path_(path) {
  const game::Level level = game::load_level(path);  // throws with a message for an invalid file
  path_ = level.map.file;
  hash_ = level.map.content_hash;
  pixels_per_metre_ = level.map.pixels_per_metre;
  json_ = Json::parse(read_file(path_));
  for_each_object(json_, "wheel", [this](const Json& wheel) { reeved_.push_back(find(wheel, "cord")->get<int>()); });
}

game::Level LevelFile::level_of(const Json& json) const {
  return game::level_of(engine::parse_tiled_map(json.dump(), path_));
}

game::Level LevelFile::level_of(const Json& json, const Setting& setting) const {
  game::Level level = level_of(json);
  if (setting.solver == "direct" && !is_present(setting)) level.line_accuracy = accuracy_of(setting);
  return level;
}

bool LevelFile::has_cords() const {
  bool found = false;
  Json json = json_;
  for_each_cord(json, [&found](const Json&) { found = true; });
  return found;
}

std::string LevelFile::left_out_reason(const Setting& setting) const {
  if (is_box2d(setting) || (setting.solver == "direct" && mesh_of(setting) == Mesh{})) return {};
  Json json = json_;
  bool any = false;
  for_each_cord(json, [&](Json& cord) {
    Setting own = setting;
    own.points = 1.0;
    own.rows = 1;
    Json without = cord;
    if (setting.solver == "direct") apply_setting(without, own);
    apply_setting(cord, setting);
    any = any || cord != without;
  });
  if (!any) return "no cord of the map can have it";
  try {
    level_of(json);
  } catch (const engine::MapError& error) {
    return error.what();
  }
  return {};
}

template <typename Visit>
void LevelFile::for_each_object(Json& json, const std::string& kind, Visit&& visit) {
  if (!json.contains("layers")) return;
  for (Json& layer : json["layers"]) {
    for_each_object(layer, kind, visit);
    if (!layer.contains("objects")) continue;
    for (Json& object : layer["objects"]) {
      if (kind_of(object) == kind) visit(object);
    }
  }
}

const LevelFile::Json* LevelFile::find(const Json& cord, const std::string& name) {
  if (!cord.contains("properties")) return nullptr;
  for (const Json& property : cord["properties"]) {
    if (property["name"] == name) return &property["value"];
  }
  return nullptr;
}

/// Null removes the property.
void LevelFile::set(Json& cord, const std::string& name, const Json& value) {
  if (!cord.contains("properties")) cord["properties"] = Json::array();
  Json& properties = cord["properties"];
  for (std::size_t k = 0; k < properties.size(); ++k) {
    if (properties[k]["name"] != name) continue;
    if (value.is_null()) {
      properties.erase(k);
    } else {
      properties[k]["value"] = value;
    }
    return;
  }
  if (value.is_null()) return;
  const char* type = value.is_boolean() ? "bool" : value.is_string() ? "string" : "float";
  properties.push_back({{"name", name}, {"type", value.is_number_integer() ? "int" : type}, {"value", value}});
}

int LevelFile::rows_of(const Json& cord) {
  const Json* rows = find(cord, "rows");
  if (rows != nullptr) return rows->get<int>();
  return kind_of(cord) == "ribbon" ? 3 : 1;
}

void LevelFile::multiply_links(Json& cord, double times) {
  const Json* columns = find(cord, "columns");
  if (columns == nullptr) return;
  const int links = static_cast<int>(std::lround(times * (columns->get<int>() - 1)));
  set(cord, "columns", std::clamp(links, 1, 4999) + 1);
}

void LevelFile::apply_setting(Json& cord, const Setting& setting) const {
  if (setting.points != 1.0) multiply_links(cord, setting.points);
  if (is_present(setting) || is_box2d(setting))
    return;  // of chains the cords only give the geometry, and are not stepped
  const Json* solver = find(cord, "solver");
  const bool is_thesis = solver != nullptr && *solver == "thesis";
  const bool is_reeved = std::find(reeved_.begin(), reeved_.end(), cord["id"].get<int>()) != reeved_.end();
  if (setting.solver == "thesis") {
    if (is_reeved) return;
    if (!is_thesis) make_thesis(cord, setting);
    set(cord, "substeps", setting.substeps);
    return;
  }
  if (is_thesis) return;  // its material is not that of the direct solver
  if (setting.rows > 1 && !is_reeved) make_ribbon(cord, setting.rows);
  set(cord, "accuracy", nullptr);
  set(cord, "integrator", setting.integrator);
  set(cord, "substeps", setting.substeps);
  set(cord, "tolerance", setting.tolerance);
  set(cord, "max_iterations", setting.iterations > 0 ? Json(setting.iterations) : Json());
  if (setting.max_work > 0) set(cord, "max_work", setting.max_work);
}

double LevelFile::ribbon_stiffness() const {
  constexpr double loads = 5.0;  // weights; a swing loads with three, a catch with more
  constexpr double stretch = 1e-4;
  const game::Level own = level();
  const auto scene = own.make_scene();
  const double mass = mass_of(scene->world(), scene->coupling()) + own.player_mass;
  return loads * mass * static_cast<double>(scene->world().GetGravity().Length()) / stretch;
}

/// A ribbon with the rope's mass, bending stiffness and thickness: half the radius on both sides of its width.
void LevelFile::make_ribbon(Json& cord, int rows) const {
  if (rows_of(cord) > 1) {
    change_rows(cord, rows);
    return;
  }
  const Json* own_radius = find(cord, "radius");
  const double radius = own_radius == nullptr ? ribbon::CordDef{}.radius : own_radius->get<double>();
  set(cord, "rows", rows);
  if (radius > 0.0) {
    set(cord, "radius", 0.5 * radius);
    set(cord, "width", radius);
  }
  if (find(cord, "stretch_stiffness") == nullptr) set(cord, "stretch_stiffness", std::max(ribbon_stiffness(), 1.0));
  if (rows > 2 && find(cord, "bending_stiffness") == nullptr) set(cord, "bending_stiffness", 1e-6);  // required
  set(cord, "tension_only", nullptr);
}

/// Keeps the width, which by default follows from the rows.
void LevelFile::change_rows(Json& cord, int rows) const {
  if (rows_of(cord) == rows) return;
  const auto scene = level().make_scene();
  for (const ribbon::box2d::CordId c : scene->coupling().cords()) {
    if (scene->cord_object(c) != cord["id"].get<int>()) continue;
    set(cord, "width", scene->coupling().cord(c).direct().def().width);
  }
  set(cord, "rows", rows);
  if (rows > 2 && find(cord, "bending_stiffness") == nullptr) set(cord, "bending_stiffness", 1e-6);  // required
}

/// A cord of the thesis with the same mass and columns. Its springs are as stiff and its bars as damped as substeps of
/// 1/60 s allow. (The remaining error is then that of the sweeps of the spring correction.)
void LevelFile::make_thesis(Json& cord, const Setting& setting) {
  const int columns = find(cord, "columns")->get<int>();
  const int own_rows = rows_of(cord);
  const double mass = find(cord, "mass")->get<double>();
  for (const char* name : {"stretch_stiffness",
                           "bending_stiffness",
                           "poisson_ratio",
                           "damping",
                           "tension_only",
                           "radius",
                           "width",
                           "accuracy",
                           "integrator",
                           "tolerance",
                           "max_iterations",
                           "max_work",
                           "friction",
                           "restitution",
                           "self_contact",
                           "cord_contact",
                           "area_stiffness",
                           "allow_sleep",
                           "soft_contacts",
                           "gravity_scale",
                           "drag_across",
                           "drag_along",
                           "displaced_area",
                           "breaking_force",
                           "at_rest"}) {
    set(cord, name, nullptr);
  }
  const int thesis_rows = std::max(own_rows, 2);
  set(cord, "solver", "thesis");
  set(cord, "rows", thesis_rows);
  set(cord, "spring_stiffness", 1e12);
  set(cord, "bar_damping", mass / (columns * thesis_rows) * setting.substeps * 60.0);
}

game::Level LevelFile::level() const {
  game::Level level = level_of(json_);
  level.map.content_hash = hash_;  // identifies the level in recordings
  return level;
}

game::Level LevelFile::with(const CordSettings& settings) const {
  Json json = json_;
  for_each_cord(json, [&](Json& cord) { apply_setting(cord, setting_of(cord, settings)); });
  return level_of(json, settings.common);
}

const Setting& LevelFile::setting_of(const Json& cord, const CordSettings& settings) {
  const auto own = settings.own.find(cord["id"].get<int>());
  return own == settings.own.end() ? settings.common : own->second;
}

std::string LevelFile::name_of_object(int id) const {
  std::string name;
  Json json = json_;
  for_each_cord(json, [&](const Json& cord) {
    if (cord["id"].get<int>() == id) name = cord.value("name", "");
  });
  return name.empty() ? "cord " + std::to_string(id) : name;
}

LevelFile LevelFile::varied(unsigned seed) const {
  std::mt19937 random(seed);
  const auto between = [&random](double low, double high) {  // the same bits with every library, unlike std's
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  const auto factor = [&between](double most) { return std::exp(between(-std::log(most), std::log(most))); };
  LevelFile other = *this;
  for_each_object(other.json_, "player",
                  [&](Json& player) { set(player, "mass", level().player_mass * factor(Variation::factor)); });
  for_each_cord(other.json_, [&](Json& cord) {
    multiply_links(cord, factor(Variation::links));
    for (const char* name : {"mass", "drag", "damping", "bending_stiffness"}) {
      const double times = factor(Variation::factor);
      const Json* value = find(cord, name);
      if (value != nullptr) set(cord, name, value->get<double>() * times);
    }
    for (const char* axis : {"x", "y"}) {
      const double offset = between(-Variation::place, Variation::place);
      cord[axis] = cord[axis].get<double>() + offset * pixels_per_metre_;
    }
  });
  other.hash_ = ribbon::box2d::hash_bytes(other.json_.dump());
  other.level();  // throws if it cannot be built
  return other;
}

game::Level LevelFile::with_property(const std::string& name, const Json& value) const {
  Json json = json_;
  for_each_cord(json, [&](Json& cord) { set(cord, name, value); });
  return level_of(json);
}

std::optional<game::Level> LevelFile::switched_on(const std::string& name, const Json& value) const {
  Json json = json_;
  bool any = false;
  for_each_cord(json, [&](Json& cord) {
    const Json before = cord;
    set(cord, name, value);
    try {
      level_of(json);
      any = true;
    } catch (const engine::MapError&) {
      cord = before;
    }
  });
  if (!any) return {};
  return level_of(json);
}

bool LevelFile::declares(const std::string& property) const {
  bool found = false;
  Json json = json_;
  for_each_cord(json, [&](Json& cord) {
    const Json* value = find(cord, property);
    found = found || (value != nullptr && *value != false && *value != 0.0);
  });
  return found;
}

/// Returns the text with only the differences between two versions of a cord changed.
std::string LevelFile::with_changes(const std::string& text, const Json& before, const Json& after) {
  const int id = before["id"].get<int>();
  std::string changed = text;
  for (const Json& property : after.value("properties", Json::array())) {
    const auto name = property["name"].get<std::string>();
    const Json* old = find(before, name);
    if (old == nullptr || *old != property["value"]) {
      changed = engine::with_property(changed, id, name, value_of(property["value"]));
    }
  }
  for (const Json& property : before.value("properties", Json::array())) {
    const auto name = property["name"].get<std::string>();
    if (find(after, name) == nullptr) changed = engine::without_property(changed, id, name);
  }
  return changed;
}

void LevelFile::apply(const CordSettings& settings) const {
  if (!has_cords()) {
    throw std::runtime_error(path_ +
                             ": has no cord that the setting could be written to; accepted is a level with a "
                             "cord or ribbon. Thrown lines have theirs from LineTuning::accuracy");
  }
  std::string text = read_file(path_);
  Json json = json_;
  for_each_cord(json, [&](Json& cord) {
    const Json before = cord;
    apply_setting(cord, setting_of(cord, settings));
    text = with_changes(text, before, cord);
  });
  game::level_of(engine::parse_tiled_map(text, path_));  // throws if it cannot be built
  engine::replace_file(path_, text);
}

}  // namespace study
