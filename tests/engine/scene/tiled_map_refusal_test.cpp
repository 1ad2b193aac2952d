#include "engine/scene/tiled_map.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ribbon/box2d/state_hash.h"
#include "tests/engine/scene/map_json.h"
#include "tests/support/refusal.h"

// Maps that are refused, and the messages.

namespace engine {
namespace {

using test_support::says;

TEST(TiledMap, LoadsFromAFileAndNamesItInErrors) {
  const std::string path = testing::TempDir() + "tiled_map_test_" + std::to_string(getpid()) + ".tmj";
  std::ofstream(path) << map_of(list(point())).dump(1);
  const TiledMap map = load_tiled_map(path);
  EXPECT_EQ(map.file, path);
  EXPECT_EQ(map.objects.size(), 1U);
  EXPECT_EQ(map.content_hash, ribbon::box2d::hash_bytes(map_of(list(point())).dump(1)));

  EXPECT_EQ(error_of([] { load_tiled_map("/nowhere.tmj"); }), "/nowhere.tmj: there is no such file");
  EXPECT_TRUE(says(error_of([] { load_tiled_map(testing::TempDir()); }), "is a directory"));
  EXPECT_TRUE(says(error_of([] { load_tiled_map("/dev/zero"); }), "is a device or pipe"));
  std::ofstream(path) << std::string((4U << 20) + 1, ' ');
  EXPECT_EQ(error_of([&] { load_tiled_map(path); }), path + ": the file is longer than the 4194304 bytes accepted");
  std::filesystem::remove(path);
}

TEST(TiledMap, MalformedJsonNamesFileAndLine) {
  const auto error = [](const std::string& text) { return error_of([&] { parse_tiled_map(text, file); }); };
  EXPECT_TRUE(says(error("{\n\"width\": 3,\n\"height\" 4\n}"), file + ": not valid JSON: parse error at line 3"));
  EXPECT_TRUE(says(error(""), file + ": not valid JSON: parse error at line 1"));
  EXPECT_TRUE(says(error("{\"width\": NaN}"), file + ": not valid JSON: parse error at line 1"));
  EXPECT_TRUE(says(error("{\"width\": 1e999}"), file + ": not valid JSON: number overflow parsing '1e999'"));
  EXPECT_TRUE(says(error("\"\xff\""), file + ": not valid JSON"));
  EXPECT_TRUE(says(error("[1, 2]"), file + ": map: found is an array, accepted is an object"));
  EXPECT_TRUE(says(error(std::string(1'000'000, '[')), file + ": nested more than the 64 levels deep accepted"));
  EXPECT_LT(error('"' + std::string(1'000'000, 'x')).size(), 400U) << "a message must not quote the whole file";
}

TEST(TiledMap, ATruncatedFileIsRefused) {
  const std::string whole = map_of(list(rectangle(0, 0, 1, 1), polyline(1, 2, list(at(0, 0))))).dump();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_TRUE(says(error_of([&] { parse_tiled_map(whole.substr(0, size), file); }), file + ": not valid JSON"));
  }
}

TEST(TiledMap, EveryFieldOfTheMapIsChecked) {
  struct Case {
    const char* key;
    json value;
    const char* expected;
  };
  const std::vector<Case> cases{
      {"type", "tileset", "\"type\" is \"tileset\", accepted is \"map\""},
      {"orientation", "isometric", "\"orientation\" is \"isometric\", accepted is \"orthogonal\""},
      {"infinite", true, "\"infinite\" is true, accepted is false"},
      {"infinite", 1, "\"infinite\" is 1, accepted is true or false"},
      {"width", "10", "\"width\" is \"10\", accepted is a whole number from 1 to 100000"},
      {"width", 10.5, "\"width\" is 10.5"},
      {"height", 0, "\"height\" is 0"},
      {"tilewidth", -32, "\"tilewidth\" is -32"},
      {"tileheight", 18446744073709551615U, "\"tileheight\" is 18446744073709551615"},
      {"layers", "none", "\"layers\" is \"none\", accepted is an array"},
      {"properties", json::object(), "\"properties\" is an object, accepted is an array"},
  };
  for (const Case& wrong : cases) {
    json map = map_of(json::array());
    map[wrong.key] = wrong.value;
    EXPECT_TRUE(says(error_of(map), file + ": map: " + wrong.expected));
  }
  for (const char* key : {"type", "orientation", "width", "height", "tilewidth", "tileheight", "layers"}) {
    json map = map_of(json::array());
    map.erase(key);
    EXPECT_TRUE(says(error_of(map), file + ": map: \"" + key + "\" is missing, accepted is "));
  }
}

TEST(TiledMap, PixelsPerMetreMustBePositive) {
  json map = map_of(json::array());
  for (const json& wrong : {json(0), json(-64), json(1e9)}) {
    map["properties"] = list(property("pixels_per_metre", "float", wrong));
    EXPECT_TRUE(says(error_of(map), file + ": map: property \"pixels_per_metre\" is "));
  }
  map["properties"] = list(property("pixels_per_metre", "string", "64"));
  EXPECT_TRUE(says(error_of(map), "property \"pixels_per_metre\" is \"64\", accepted is a number from 0.001"));
}

TEST(TiledMap, LayersThatWouldBeMissingFromTheGameAreRefused) {
  for (const char* type : {"tilelayer", "imagelayer", "hologram"}) {
    json map = map_of(json::array());
    map["layers"].push_back({{"type", type}, {"name", "sky"}});
    EXPECT_TRUE(says(error_of(map), file + ": layer \"sky\": \"type\" is \"" + type + "\", accepted is objectgroup"));
  }
  json traced = map_of(list(point()));
  traced["layers"].push_back({{"type", "imagelayer"}, {"name", "photo"}, {"visible", false}});
  EXPECT_EQ(load(traced).objects.size(), 1U);
}

TEST(TiledMap, LimitsHowDeepGroupsNest) {
  const auto nested = [](int depth) {
    json layer = {{"type", "objectgroup"}, {"name", "innermost"}, {"objects", json::array()}};
    for (int i = 0; i < depth; ++i) layer = {{"type", "group"}, {"name", "group"}, {"layers", list(layer)}};
    json map = map_of(json::array());
    map["layers"] = list(layer);
    return map;
  };
  EXPECT_NO_THROW(load(nested(16)));
  EXPECT_TRUE(says(error_of(nested(17)), file + ": layer \"group\": group layers nest more than the 16 deep"));
}

TEST(TiledMap, EveryFieldOfAnObjectIsCheckedAndTheObjectNamed) {
  struct Case {
    json object;
    const char* expected;
  };
  const auto with = [](json object, const char* key, const json& value) {
    object[key] = value;
    return object;
  };
  const auto without = [](json object, const char* key) {
    object.erase(key);
    return object;
  };
  const json box = rectangle(0, 0, 10, 10);
  const json one_point = list(at(0, 0));
  const std::vector<Case> cases{
      {with(box, "x", "left"), "\"x\" is \"left\", accepted is a number from -1e+07 to 1e+07"},
      {with(box, "y", 1e300), "\"y\" is 1e+300, accepted is a number from -1e+07 to 1e+07"},
      {without(box, "x"), "\"x\" is missing"},
      {with(box, "width", 0), "\"width\" is 0, accepted is a number from 0.01"},
      {with(box, "height", -5), "\"height\" is -5, accepted is a number from 0.01"},
      {without(box, "height"), "\"height\" is missing"},
      {with(box, "rotation", true), "\"rotation\" is true, accepted is a number"},
      {with(box, "ellipse", "yes"), "\"ellipse\" is \"yes\", accepted is true or false"},
      {with(box, "class", 5), "\"class\" is 5, accepted is a text"},
      {with(box, "gid", 7), "has \"gid\": accepted are point, rectangle, ellipse, polygon and polyline objects"},
      {with(box, "text", {{"text", "hello"}}), "has \"text\""},
      {with(box, "template", "rope.tx"), "has \"template\""},
      {with(with(box, "point", true), "ellipse", true), "is both point and ellipse, accepted is one shape"},
      {polyline(0, 0, one_point), "polyline has 1 points, accepted are 2 or more"},
      {with(object_at(0, 0), "polygon", json::array()), "polygon has 0 points, accepted are 3 or more"},
      {polyline(0, 0, list(at(0, 0), json::object({{"x", 1}}))), "polyline point 2: \"y\" is missing"},
      {polyline(0, 0, list(at(0, 0), 5)), "polyline point 2: found is 5, accepted is an object"},
      {polyline(0, 0, "line"), "\"polyline\" is \"line\", accepted is an array"},
      {point(list(property("a", "class", json::object()))), "property \"a\": \"type\" is \"class\""},
      {point(list(property("a", "float", "1.5"))), "property \"a\": \"value\" is \"1.5\", accepted is a number"},
      {point(list(property("a", "int", 1.5))), "property \"a\": \"value\" is 1.5, accepted is a whole number"},
      {point(list(property("a", "bool", 1))), "property \"a\": \"value\" is 1, accepted is true or false"},
      {point(list(property("a", "string", 1))), "property \"a\": \"value\" is 1, accepted is a text"},
      {point(list(json::object({{"name", "a"}, {"type", "bool"}}))), "property \"a\": \"value\" is missing"},
      {point(list(json::object({{"type", "bool"}}))), "property number 1: \"name\" is missing"},
      {point(list(property("a", "int", 1), property("a", "int", 2))), "property \"a\": is there twice"},
  };
  for (const Case& wrong : cases) {
    EXPECT_TRUE(says(object_error(wrong.object), file + ": object 12 \"rope\": " + wrong.expected));
  }
}

TEST(TiledMap, ObjectsWithoutAValidIdAreNamedByTheirNumber) {
  json object = point();
  for (const json& wrong : {json(0), json(-1), json("12"), json(1.5), json(3'000'000'000)}) {
    object["id"] = wrong;
    EXPECT_TRUE(says(object_error(object), file + ": layer \"things\": object number 1: \"id\" is "));
  }
  object.erase("id");
  EXPECT_TRUE(says(object_error(object), file + ": layer \"things\": object number 1: \"id\" is missing"));
  EXPECT_TRUE(says(error_of(map_of(list(point(), point()))), file + ": object 12 \"rope\": the id is taken"));
}

}  // namespace
}  // namespace engine
