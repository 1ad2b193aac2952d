#include "engine/scene/tiled_map.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "ribbon/box2d/state_hash.h"

namespace engine {
namespace {

using nlohmann::json;
using std::numbers::pi;

const std::string file = "levels/swing.tmj";

/// An array of JSON: braces alone make of one element the element itself.
template <class... Items>
json list(const Items&... items) {
  return json::array({json(items)...});
}

json at(double x, double y) { return {{"x", x}, {"y", y}}; }

/// A map of 10 × 5 tiles of 32 px: 320 × 160 px, 5 × 2.5 m at 64 px a metre.
json map_of(const json& objects) {
  const json layer = {{"type", "objectgroup"}, {"name", "things"}, {"objects", objects}};
  return {{"type", "map"},     {"version", "1.10"}, {"orientation", "orthogonal"},
          {"infinite", false}, {"width", 10},       {"height", 5},
          {"tilewidth", 32},   {"tileheight", 32},  {"layers", list(layer)}};
}

json object_at(double x, double y) { return {{"id", 12}, {"name", "rope"}, {"x", x}, {"y", y}}; }

json rectangle(double x, double y, double width, double height, double rotation = 0.0) {
  json object = object_at(x, y);
  object.update({{"width", width}, {"height", height}, {"rotation", rotation}});
  return object;
}

json polyline(double x, double y, const json& points, double rotation = 0.0) {
  json object = object_at(x, y);
  object.update({{"polyline", points}, {"rotation", rotation}});
  return object;
}

json property(const char* name, const char* type, const json& value) {
  return {{"name", name}, {"type", type}, {"value", value}};
}

json point(const json& properties = json::array()) {
  json object = object_at(32, 32);
  object.update({{"point", true}, {"properties", properties}});
  return object;
}

TiledMap load(const json& map) { return parse_tiled_map(map.dump(), file); }
MapObject load_object(const json& object) { return load(map_of(list(object))).objects.at(0); }

/// The message of the MapError that `call` ends in.
template <class Call>
std::string error_of(const Call& call) {
  try {
    call();
  } catch (const MapError& error) {
    return error.what();
  }
  return "no error";
}
std::string error_of(const json& map) {
  return error_of([&] { load(map); });
}
std::string object_error(const json& object) { return error_of(map_of(list(object))); }

testing::AssertionResult says(const std::string& message, const std::string& part) {
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the message is: " << message << "\nand should say: " << part;
}

void expect_near(ribbon::Vec2 a, ribbon::Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-14);
  EXPECT_NEAR(a.y, b.y, 1e-14);
}

TEST(TiledMap, MeasuresInMetresFromTheBottomLeft) {
  json map = map_of(list(object_at(64, 32)));
  map["layers"][0]["objects"][0]["point"] = true;
  EXPECT_EQ(load(map).size, (ribbon::Vec2{5.0, 2.5}));
  EXPECT_EQ(load(map).objects[0].position, (ribbon::Vec2{1.0, 2.0}));

  map["properties"] = list(property("pixels_per_metre", "float", 32));
  EXPECT_EQ(load(map).pixels_per_metre, 32.0);
  EXPECT_EQ(load(map).size, (ribbon::Vec2{10.0, 5.0}));
  EXPECT_EQ(load(map).objects[0].position, (ribbon::Vec2{2.0, 4.0}));
}

TEST(TiledMap, ARectangleHasItsCentre) {
  const MapObject box = load_object(rectangle(64, 32, 128, 64));
  EXPECT_EQ(box.shape, MapShape::rectangle);
  EXPECT_EQ(box.size, (ribbon::Vec2{2.0, 1.0}));
  EXPECT_EQ(box.position, (ribbon::Vec2{2.0, 1.5}));
  EXPECT_EQ(box.rotation, 0.0);
  EXPECT_FALSE(std::signbit(box.rotation));
}

TEST(TiledMap, ARectangleTurnsClockwiseAboutItsTopLeftCorner) {
  // Turned by a quarter, its right edge hangs down: the centre is left of and below the pivot at (1, 2) m.
  const MapObject quarter = load_object(rectangle(64, 32, 128, 64, 90));
  EXPECT_EQ(quarter.position, (ribbon::Vec2{0.5, 1.0}));
  EXPECT_DOUBLE_EQ(quarter.rotation, -pi / 2);
  EXPECT_EQ(load_object(rectangle(64, 32, 128, 64, 180)).position, (ribbon::Vec2{0.0, 2.5}));
  EXPECT_EQ(load_object(rectangle(64, 32, 128, 64, -90)).position, (ribbon::Vec2{1.5, 3.0}));
  EXPECT_EQ(load_object(rectangle(64, 32, 128, 64, 450)).position, quarter.position);

  const MapObject tilted = load_object(rectangle(64, 32, 128, 64, 30));
  const double c = std::cos(pi / 6);
  const double s = std::sin(pi / 6);
  expect_near(tilted.position, {1.0 + c * 1.0 - s * 0.5, 2.0 - s * 1.0 - c * 0.5});
  EXPECT_DOUBLE_EQ(tilted.rotation, -pi / 6);
}

TEST(TiledMap, AnEllipseIsPlacedLikeARectangle) {
  json round = rectangle(64, 32, 128, 64, 90);
  round["ellipse"] = true;
  const MapObject ellipse = load_object(round);
  EXPECT_EQ(ellipse.shape, MapShape::ellipse);
  EXPECT_EQ(ellipse.position, (ribbon::Vec2{0.5, 1.0}));
  EXPECT_EQ(ellipse.size, (ribbon::Vec2{2.0, 1.0}));
}

TEST(TiledMap, PointsOfAPolylineAreInTheWorld) {
  const json points = list(at(0, 0), at(64, 0), at(64, 32));
  const MapObject straight = load_object(polyline(64, 32, points));
  EXPECT_EQ(straight.shape, MapShape::polyline);
  EXPECT_EQ(straight.position, (ribbon::Vec2{1.0, 2.0}));
  EXPECT_EQ(straight.points, (std::vector<ribbon::Vec2>{{1.0, 2.0}, {2.0, 2.0}, {2.0, 1.5}}));

  const MapObject turned = load_object(polyline(64, 32, points, 90));
  EXPECT_EQ(turned.points, (std::vector<ribbon::Vec2>{{1.0, 2.0}, {1.0, 1.0}, {0.5, 1.0}}));
}

TEST(TiledMap, QuarterTurnsAreExact) {
  // About the origin, where an error of 10⁻¹⁶ has nothing to disappear in.
  const json points = list(at(0, 0), at(64, 0));
  EXPECT_EQ(load_object(polyline(0, 160, points, 90)).points[1], (ribbon::Vec2{0.0, -1.0}));
  EXPECT_EQ(load_object(polyline(0, 160, points, -90)).points[1], (ribbon::Vec2{0.0, 1.0}));
  EXPECT_EQ(load_object(polyline(0, 160, points, 180)).points[1], (ribbon::Vec2{-1.0, 0.0}));
}

TEST(TiledMap, APolygonKeepsItsCornersInFileOrder) {
  json object = object_at(0, 160);
  object["polygon"] = list(at(0, 0), at(64, 0), at(0, -64));
  const MapObject polygon = load_object(object);
  EXPECT_EQ(polygon.shape, MapShape::polygon);
  EXPECT_EQ(polygon.points, (std::vector<ribbon::Vec2>{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}));
}

TEST(TiledMap, LayersAddTheirOffsetsAndKeepFileOrder) {
  const auto numbered = [](int id) {
    json object = object_at(0, 0);
    object.update({{"id", id}, {"point", true}});
    return object;
  };
  json map = map_of(list(numbered(3)));
  const json inner = {
      {"type", "objectgroup"}, {"name", "inner"}, {"offsetx", 64}, {"offsety", 32}, {"objects", list(numbered(1))}};
  const json plain = {{"type", "objectgroup"}, {"name", "plain"}, {"objects", list(numbered(4))}};
  map["layers"].push_back(
      {{"type", "group"}, {"name", "outer"}, {"offsetx", 32}, {"visible", false}, {"layers", list(inner, plain)}});
  map["layers"].push_back({{"type", "objectgroup"}, {"name", "last"}, {"objects", list(numbered(2))}});

  const TiledMap loaded = load(map);
  ASSERT_EQ(loaded.objects.size(), 4U);
  EXPECT_EQ(loaded.objects[0].id, 3);
  EXPECT_EQ(loaded.objects[1].id, 1);
  EXPECT_EQ(loaded.objects[2].id, 4);
  EXPECT_EQ(loaded.objects[3].id, 2);
  EXPECT_EQ(loaded.objects[0].position, (ribbon::Vec2{0.0, 2.5}));
  EXPECT_EQ(loaded.objects[1].position, (ribbon::Vec2{1.5, 2.0}));
  EXPECT_EQ(loaded.objects[2].position, (ribbon::Vec2{0.5, 2.5})) << "a group moves what is in it";
  EXPECT_EQ(loaded.objects[3].position, (ribbon::Vec2{0.0, 2.5})) << "an offset must not outlive its layer";
  EXPECT_EQ(loaded.find(1), &loaded.objects[1]);
  EXPECT_EQ(loaded.find(7), nullptr);
}

TEST(TiledMap, TheKindIsTypeOrClassAsTheVersionHasIt) {
  json object = point();
  EXPECT_EQ(load_object(object).kind, "");
  object["type"] = "cord";
  EXPECT_EQ(load_object(object).kind, "cord");
  object["class"] = "";
  EXPECT_EQ(load_object(object).kind, "cord");
  object.erase("type");
  object["class"] = "bridge";
  EXPECT_EQ(load_object(object).kind, "bridge");
}

TEST(TiledMap, BackgroundColour) {
  json map = map_of(json::array());
  EXPECT_FALSE(load(map).background);
  map["backgroundcolor"] = "#123456";
  EXPECT_EQ(load(map).background, (MapColour{0x12, 0x34, 0x56, 0xff}));
  map["backgroundcolor"] = "#80ABCdef";
  EXPECT_EQ(load(map).background, (MapColour{0xab, 0xcd, 0xef, 0x80}));
  for (const char* wrong : {"", "red", "#12345", "#12345g", "#+23456", "1234567"}) {
    map["backgroundcolor"] = wrong;
    EXPECT_TRUE(says(error_of(map), file + ": map: \"backgroundcolor\" is \"" + wrong + "\", accepted is #rrggbb"));
  }
}

TEST(TiledMap, ContentHashIsOfTheVeryBytes) {
  const std::string text = map_of(json::array()).dump();
  EXPECT_EQ(parse_tiled_map(text, file).content_hash, ribbon::box2d::hash_bytes(text));
  EXPECT_NE(parse_tiled_map(text + "\n", file).content_hash, ribbon::box2d::hash_bytes(text));
}

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

TEST(TiledMap, CutAnywhereIsRefused) {
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

TEST(TiledMap, GroupsNestOnlySoDeep) {
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

TEST(TiledMap, ObjectsWithoutProperIdAreNamedByTheirPlace) {
  json object = point();
  for (const json& wrong : {json(0), json(-1), json("12"), json(1.5), json(3'000'000'000)}) {
    object["id"] = wrong;
    EXPECT_TRUE(says(object_error(object), file + ": layer \"things\": object number 1: \"id\" is "));
  }
  object.erase("id");
  EXPECT_TRUE(says(object_error(object), file + ": layer \"things\": object number 1: \"id\" is missing"));
  EXPECT_TRUE(says(error_of(map_of(list(point(), point()))), file + ": object 12 \"rope\": the id is taken"));
}

TEST(Properties, AreReadByType) {
  const Properties p =
      load_object(point(list(property("stiffness", "float", 1.5), property("whole", "float", 2),
                             property("count", "int", 7), property("loose", "bool", true),
                             property("material", "string", "hemp"), property("tint", "color", "#ff0000"),
                             property("anchor", "object", 4), json::object({{"name", "untyped"}, {"value", "x"}}))))
          .properties;
  EXPECT_EQ(p.number("stiffness"), 1.5);
  EXPECT_EQ(p.number("whole"), 2.0);
  EXPECT_EQ(p.number("count"), 7.0);
  EXPECT_EQ(p.integer("count"), 7);
  EXPECT_EQ(p.integer("anchor"), 4);
  EXPECT_TRUE(p.boolean("loose"));
  EXPECT_EQ(p.text("material", {"hemp", "wire"}), "hemp");
  EXPECT_EQ(p.text("tint"), "#ff0000");
  EXPECT_EQ(p.text("untyped"), "x");
  EXPECT_TRUE(p.has("count"));
  EXPECT_FALSE(p.has("weight"));
}

TEST(Properties, AbsentOnesFallBackOnlyWhereThatIsAskedFor) {
  const Properties p = load_object(point()).properties;
  EXPECT_EQ(p.number_or("a", 2.5, {0, 1}), 2.5);
  EXPECT_EQ(p.integer_or("a", -3), -3);
  EXPECT_TRUE(p.boolean_or("a", true));
  EXPECT_EQ(p.text_or("a", "hemp", {"wire"}), "hemp");
  const std::string missing = file + ": object 12 \"rope\": property \"a\" is missing, accepted is ";
  EXPECT_EQ(error_of([&] { p.number("a", {0.5, 20}); }), missing + "a number from 0.5 to 20");
  EXPECT_EQ(error_of([&] { p.number("a"); }), missing + "a number");
  EXPECT_EQ(error_of([&] { p.integer("a", {.min = 1}); }), missing + "a whole number, 1 or more");
  EXPECT_EQ(error_of([&] { p.boolean("a"); }), missing + "true or false");
  EXPECT_EQ(error_of([&] { p.text("a", {"hemp", "wire"}); }), missing + "one of hemp, wire");
}

TEST(Properties, WrongOnesNameFileObjectPropertyValueAndWhatIsAccepted) {
  const Properties p = load_object(point(list(property("length", "float", 99.5), property("count", "int", 9),
                                              property("loose", "bool", true), property("material", "string", "silk"))))
                           .properties;
  const std::string owner = file + ": object 12 \"rope\": property ";
  EXPECT_EQ(error_of([&] {
              p.number("length", {0.1, 20});
            }),
            owner + "\"length\" is 99.5, accepted is a number from 0.1 to 20");
  EXPECT_EQ(error_of([&] { p.number_or("length", 1, {.max = 20}); }),
            owner + "\"length\" is 99.5, accepted is a number, 20 or less");
  EXPECT_EQ(error_of([&] { p.number("material"); }), owner + "\"material\" is \"silk\", accepted is a number");
  EXPECT_EQ(error_of([&] {
              p.integer("count", {1, 8});
            }),
            owner + "\"count\" is 9, accepted is a whole number from 1 to 8");
  EXPECT_EQ(error_of([&] { p.integer_or("length", 1); }), owner + "\"length\" is 99.5, accepted is a whole number");
  EXPECT_EQ(error_of([&] { p.boolean_or("count", true); }), owner + "\"count\" is 9, accepted is true or false");
  EXPECT_EQ(error_of([&] { p.text("loose"); }), owner + "\"loose\" is true, accepted is a text");
  EXPECT_EQ(error_of([&] {
              p.text_or("material", "hemp", {"hemp", "wire"});
            }),
            owner + "\"material\" is \"silk\", accepted is one of hemp, wire");
}

TEST(Properties, UnknownOnesAreRefusedWithThoseKnown) {
  const Properties p =
      load_object(point(list(property("length", "float", 1), property("lenght", "float", 2)))).properties;
  EXPECT_NO_THROW(p.check_known_properties({"lenght", "length", "material"}));
  EXPECT_EQ(error_of([&] {
              p.check_known_properties({"length", "material"});
            }),
            file + ": object 12 \"rope\": property \"lenght\" is unknown, accepted are: length, material");
  EXPECT_TRUE(says(error_of([&] { p.check_known_properties({}); }), "accepted are: none"));
}

TEST(Properties, OfANamelessObjectAreNamedByItsId) {
  json nameless = point();
  nameless.erase("name");
  const MapObject object = load_object(nameless);
  EXPECT_STREQ(object.error("is too short").what(), (file + ": object 12: is too short").c_str());
}

}  // namespace
}  // namespace engine
