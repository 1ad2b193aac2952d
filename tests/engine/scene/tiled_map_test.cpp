#include "engine/scene/tiled_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "ribbon/box2d/state_hash.h"
#include "tests/engine/scene/map_json.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using std::numbers::pi;
using test_support::says;

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
  // After a quarter turn the right edge points down: the centre is left of and below the pivot at (1, 2) m.
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
  // About the origin, where an error of 10⁻¹⁶ is not rounded away.
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

TEST(TiledMap, TheKindIsTypeOrClassDependingOnTheVersion) {
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

TEST(TiledMap, ContentHashIsThatOfTheBytes) {
  const std::string text = map_of(json::array()).dump();
  EXPECT_EQ(parse_tiled_map(text, file).content_hash, ribbon::box2d::hash_bytes(text));
  EXPECT_NE(parse_tiled_map(text + "\n", file).content_hash, ribbon::box2d::hash_bytes(text));
}

}  // namespace
}  // namespace engine
