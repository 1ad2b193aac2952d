// The level editor offers what the loader accepts, and a level that the editor saves loads unchanged.

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "game/simulation/level.h"
#include "game/simulation/simulation.h"
#include "tests/game/program.h"
#include "tests/support/files.h"
#include "tests/support/refusal.h"

namespace game {
namespace {

using nlohmann::json;
using test_support::bytes_of;
using test_support::scratch;

const json& object_types() {
  static const json types = json::parse(bytes_of(TEST_ASSETS "/levels/objecttypes.json"));
  return types;
}

json object(int id, const std::string& kind, double x, double y, double width = 0.0, double height = 0.0) {
  json made = {{"id", id},
               {"type", kind},
               {"name", ""},
               {"rotation", 0},
               {"x", 64.0 * x},
               {"y", 64.0 * y},
               {"width", 64.0 * width},
               {"height", 64.0 * height},
               {"visible", true},
               {"properties", json::array()}};
  if (width == 0.0) made["point"] = true;
  return made;
}

json line(int id, const std::string& kind, double x) {
  json made = object(id, kind, x, 2.0);
  made.erase("point");
  made["polyline"] = {{{"x", 0}, {"y", 0}}, {{"x", 0}, {"y", 256}}};
  return made;
}

json ellipse(int id, const std::string& kind, double x) {
  json made = object(id, kind, x, 3.0, 1.0, 1.0);
  made["ellipse"] = true;
  return made;
}

void set(json& object, const std::string& name, const std::string& type, const json& value) {
  for (json& property : object["properties"]) {
    if (property["name"] == name) return void(property["value"] = value);
  }
  object["properties"].push_back({{"name", name}, {"type", type}, {"value", value}});
}

/// Adds the required properties of a class.
void set_required(json& object) {
  const std::string kind = object["type"];
  if (kind == "cord" || kind == "ribbon") {
    set(object, "columns", "int", 9);
    set(object, "mass", "float", 2.0);
  }
  if (kind == "ribbon") {
    set(object, "stretch_stiffness", "float", 1e4);
    set(object, "bending_stiffness", "float", 1.0);
  }
  if (kind == "load") set(object, "mass", "float", 50.0);
  if (kind == "text") set(object, "text", "string", "words");
  if (kind == "wheel") set(object, "cord", "object", 5);
  if (kind == "chaser") set(object, "path", "object", 6);
}

/// A rope over the wheel of one_of.
json reeved_cord() {
  json made = line(5, "cord", 12.0);
  made["polyline"] = {{{"x", 0}, {"y", 192}}, {{"x", 32}, {"y", 64}}, {{"x", 64}, {"y", 192}}};
  set_required(made);
  set(made, "columns", "int", 31);
  return made;
}

/// A path through the middle of the chaser of one_of.
json path_of_chaser() {
  json made = line(6, "path", 12.5);
  made["polyline"] = {{{"x", 0}, {"y", 96}}, {{"x", 0}, {"y", 256}}};
  return made;
}

/// Returns a valid object of that class.
json one_of(const std::string& kind) {
  json made;
  if (kind == "cord" || kind == "ribbon") made = line(9, kind, 8.0);
  if (kind == "circle" || kind == "wheel" || kind == "chaser") made = ellipse(9, kind, 12.0);
  if (kind == "blade" || kind == "path") made = line(9, kind, 12.0);
  if (kind == "load" || kind == "ground" || kind == "checkpoint" || kind == "goal" || kind == "fire" ||
      kind == "spikes")
    made = object(9, kind, 12.0, 5.0, 1.0, 1.0);
  if (made.is_null()) made = object(9, kind, 5.0, 2.0);
  set_required(made);
  return made;
}

/// Returns a level with cords from (5, 2) and (5.1, 2) downwards, for a wheel its cord, for a chaser its path, and that
/// object, in place of a required one of the same class.
Level level_with(const json& added) {
  json objects = json::array();
  for (const json& own : {object(1, "player", 2.0, 9.0), object(2, "goal", 18.0, 8.0, 1.0, 1.0)}) {
    if (own["type"] != added["type"]) objects.push_back(own);
  }
  for (const auto& [id, x] : {std::pair{3, 5.0}, std::pair{4, 5.1}}) {
    json cord = line(id, "cord", x);
    set_required(cord);
    objects.push_back(cord);
  }
  if (added["type"] == "wheel") objects.push_back(reeved_cord());
  if (added["type"] == "chaser") objects.push_back(path_of_chaser());
  objects.push_back(added);
  const json map = {{"type", "map"},
                    {"orientation", "orthogonal"},
                    {"width", 20},
                    {"height", 10},
                    {"tilewidth", 64},
                    {"tileheight", 64},
                    {"infinite", false},
                    {"tilesets", json::array()},
                    {"layers", {{{"type", "objectgroup"}, {"name", "level"}, {"objects", objects}}}}};
  return level_of(engine::parse_tiled_map(map.dump(), "made.tmj"));
}

/// Returns the properties that the loader's message lists.
std::set<std::string> accepted_by(json object) {
  set(object, "no_such_property", "bool", true);
  const std::string sentence = test_support::refusal<engine::MapError>([&] { level_with(object); });
  const std::string before = "is unknown, accepted are: ";
  const std::size_t at = sentence.find(before);
  EXPECT_NE(at, std::string::npos) << sentence;
  if (at == std::string::npos) return {};
  std::istringstream names(sentence.substr(at + before.size()));
  std::set<std::string> accepted;
  for (std::string name; std::getline(names >> std::ws, name, ',');) {
    if (name != "none") accepted.insert(name);
  }
  return accepted;
}

std::string hash_of(const Level& level) {
  Simulation simulation(level);
  for (int k = 0; k < 30; ++k) simulation.tick({});
  return ribbon::box2d::to_hex(simulation.hash().combined());
}

TEST(ObjectTypes, HaveEveryClassThatTheLoaderAccepts) {
  const std::string sentence =
      test_support::refusal<engine::MapError>([] { level_with(object(9, "no_such_class", 1.0, 1.0)); });
  const std::size_t at = sentence.find("accepted is ");
  ASSERT_NE(at, std::string::npos) << sentence;
  std::istringstream names(sentence.substr(at + 12));
  std::set<std::string> accepted;
  for (std::string name; std::getline(names >> std::ws, name, ',');) accepted.insert(name);
  std::set<std::string> offered;
  for (const json& type : object_types()) offered.insert(type["name"]);
  EXPECT_EQ(offered, accepted);
}

TEST(ObjectTypes, HaveThePropertiesThatTheLoaderAccepts) {
  for (const json& type : object_types()) {
    const std::string kind = type["name"];
    std::set<std::string> accepted = accepted_by(one_of(kind));
    if (kind == "cord" || kind == "ribbon") {
      json thesis = line(9, kind, 8.0);
      set(thesis, "columns", "int", 9);
      set(thesis, "mass", "float", 2.0);
      set(thesis, "solver", "string", "thesis");
      accepted.merge(accepted_by(thesis));
    }
    std::set<std::string> offered;
    for (const json& property : type["properties"]) offered.insert(property["name"]);
    EXPECT_EQ(offered, accepted) << kind;
  }
}

/// Properties without a default, or with one that depends on others or on the solver.
bool has_no_default(const std::string& kind, const std::string& name) {
  static const std::set<std::string> of_cords = {"columns",           "mass",          "stretch_stiffness",
                                                 "bending_stiffness", "width",         "spring_stiffness",
                                                 "bar_damping",       "self_collision"};
  if (kind == "cord" || kind == "ribbon") return of_cords.contains(name);
  if (kind == "wheel" && name == "friction") return true;
  if (kind == "chaser" && (name == "from_x" || name == "path")) return true;
  return (kind == "load" && name == "mass") || kind == "text" || name == "cord" || name == "other_cord";
}

TEST(ObjectTypes, ShowTheDefaultsThatTheLoaderHas) {
  for (const json& type : object_types()) {
    const std::string kind = type["name"];
    const std::string plain = hash_of(level_with(one_of(kind)));
    for (const json& property : type["properties"]) {
      if (has_no_default(kind, property["name"])) continue;
      json object = one_of(kind);
      set(object, property["name"], property["type"], property["value"]);
      EXPECT_EQ(hash_of(level_with(object)), plain) << kind << " " << property["name"];
    }
  }
}

void save_by_tiled(const std::string& from, const std::string& to) {
  const std::string command = "QT_QPA_PLATFORM=offscreen XDG_CONFIG_HOME=" + scratch("") +
                              " tiled --export-map json '" + from + "' '" + to + "' 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << from;
}

/// The numbers differ at most in the last of 15 digits.
void expect_same(const engine::TiledMap& a, const engine::TiledMap& b) {
  ASSERT_EQ(a.objects.size(), b.objects.size()) << a.file;
  for (std::size_t k = 0; k < a.objects.size(); ++k) {
    const engine::MapObject& x = a.objects[k];
    const engine::MapObject& y = b.objects[k];
    EXPECT_EQ(x.id, y.id);
    EXPECT_EQ(x.kind, y.kind);
    EXPECT_EQ(x.name, y.name);
    EXPECT_EQ(x.shape, y.shape);
    EXPECT_LT(length(x.position - y.position), 1e-11) << a.file << " " << x.id;
    EXPECT_LT(length(x.size - y.size), 1e-11) << a.file << " " << x.id;
    ASSERT_EQ(x.points.size(), y.points.size());
    for (std::size_t p = 0; p < x.points.size(); ++p) EXPECT_LT(length(x.points[p] - y.points[p]), 1e-11);
  }
}

/// Tiled keeps 15 digits of a number: after the first save, saving and loading does not change the bits.
TEST(Tiled, EveryLevelThatItSavesLoadsUnchanged) {
  if (std::system("QT_QPA_PLATFORM=offscreen tiled --version >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "tiled is not installed";
  }
  const std::string saved = scratch("saved.tmj");
  const std::string again = scratch("saved_again.tmj");
  for (const std::string& name : level_names()) {
    save_by_tiled(assets_folder() + "/levels/" + name + ".tmj", saved);
    save_by_tiled(saved, again);
    const Level level = load_level(name);
    const Level once = load_level(saved);
    expect_same(level.map, once.map);
    EXPECT_EQ(hash_of(load_level(again)), hash_of(once)) << name;
    EXPECT_EQ(hash_of(level), hash_of(once)) << name << " has a number of more than 15 digits";
  }
}

}  // namespace
}  // namespace game
