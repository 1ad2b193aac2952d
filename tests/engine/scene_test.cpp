#include "engine/scene.h"

#include <gtest/gtest.h>

#include <string>

namespace engine {
namespace {

/// A map of 10 × 10 m, 10 pixels a metre, with these objects.
TiledMap map_with(const std::string& objects) {
  return parse_tiled_map(
      R"({"type":"map","version":"1.8","orientation":"orthogonal","renderorder":"right-down","infinite":false,)"
      R"("width":10,"height":10,"tilewidth":10,"tileheight":10,"tilesets":[],)"
      R"("properties":[{"name":"pixels_per_metre","type":"float","value":10}],)"
      R"("layers":[{"type":"objectgroup","id":1,"name":"level","visible":true,"x":0,"y":0,"objects":[)" +
          objects + "]}]}",
      "test.tmj");
}

std::string object(const std::string& kind, const std::string& shape, const std::string& properties = "") {
  return R"({"id":7,"name":"thing","type":")" + kind + R"(","x":20,"y":30,"rotation":0,"visible":true,)" + shape +
         R"(,"properties":[)" + properties + "]}";
}

std::string number(const std::string& name, const std::string& value) {
  return R"({"name":")" + name + R"(","type":"float","value":)" + value + "}";
}

std::string whole(const std::string& name, const std::string& value) {
  return R"({"name":")" + name + R"(","type":"int","value":)" + value + "}";
}

const std::string line = R"("width":0,"height":0,"polyline":[{"x":0,"y":0},{"x":0,"y":40}])";
const std::string disc = R"("width":10,"height":10,"ellipse":true)";
const std::string box = R"("width":40,"height":10)";
const std::string cord_properties =
    whole("columns", "9") + "," + number("mass", "1.8") + "," + number("spring_stiffness", "1000");

TEST(Scene, BuildsWhatTheMapDeclares) {
  const Scene scene(map_with(object("cord", line,
                                    cord_properties + "," + whole("rows", "3") +
                                        R"(,{"name":"pin_first","type":"bool","value":true})")),
                    {});
  ASSERT_EQ(scene.coupling().size(), 1);
  const ribbon::ThesisCord& cord = scene.coupling().cord(0);
  EXPECT_EQ(cord.mesh().w, 9);
  EXPECT_EQ(cord.mesh().h, 3);
  EXPECT_DOUBLE_EQ(cord.mesh().spacing, 0.5);
  EXPECT_DOUBLE_EQ(cord.def().point_mass, 1.8 / 27);
  EXPECT_EQ(cord.def().bar_damping, 0.0);  // not declared: not there
  EXPECT_FALSE(cord.def().self_collision);
  EXPECT_EQ(cord.kind(0), ribbon::PointKind::constrained);
  EXPECT_EQ(cord.kind(2), ribbon::PointKind::constrained);
  EXPECT_EQ(cord.kind(3), ribbon::PointKind::free);
  EXPECT_NEAR(cord.positions()[1].x, 2.0, 1e-12);  // from (2, 7), the map's y turned up, down to (2, 3)
  EXPECT_NEAR(cord.positions()[1].y, 7.0, 1e-12);
  EXPECT_NEAR(cord.positions()[25].y, 3.0, 1e-12);
}

TEST(Scene, BuildsGroundAndCircles) {
  const Scene scene(map_with(object("ground", box) + "," +
                             R"({"id":8,"name":"b","type":"circle","x":0,"y":0,"rotation":0,"visible":true,)" + disc +
                             R"(,"properties":[{"name":"body","type":"string","value":"kinematic"},)" +
                             number("velocity_x", "2.5") + "]}"),
                    {});
  const b2Body* circle = scene.world().GetBodyList();
  EXPECT_EQ(circle->GetType(), b2_kinematicBody);
  EXPECT_EQ(circle->GetPosition(), b2Vec2(0.5F, 9.5F));
  EXPECT_EQ(circle->GetLinearVelocity(), b2Vec2(2.5F, 0.0F));
  EXPECT_EQ(circle->GetNext()->GetType(), b2_staticBody);
  EXPECT_EQ(circle->GetNext()->GetPosition(), b2Vec2(4.0F, 6.5F));
}

/// The sentence names file, object and what is wrong.
void expect_refused(const std::string& objects, const std::string& about) {
  try {
    const Scene scene(map_with(objects), {"player"});
    ADD_FAILURE() << "accepted: " << objects;
  } catch (const MapError& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("test.tmj"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find('7'), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(about), std::string::npos) << sentence;
  }
}

TEST(Scene, RefusesWhatItCannotBuild) {
  expect_refused(object("sail", box), "sail");
  expect_refused(object("", box), "player");  // names what is accepted
  expect_refused(object("cord", box, cord_properties), "polyline");
  expect_refused(object("cord", line), "columns");
  expect_refused(object("cord", line, cord_properties + "," + whole("rows", "1")), "rows");
  expect_refused(object("cord", line, cord_properties + "," + number("stiffness", "1")), "stiffness");
  expect_refused(object("cord", line, cord_properties + "," + whole("substeps", "0")), "substeps");
  expect_refused(object("cord", line,
                        whole("columns", "9") + "," + number("mass", "0") + "," + number("spring_stiffness", "1000")),
                 "mass");
  expect_refused(object("cord", R"("width":0,"height":0,"polyline":[{"x":0,"y":0},{"x":0,"y":0}])", cord_properties),
                 "millimetre");
  expect_refused(object("cord", R"("width":0,"height":0,"polyline":[{"x":0,"y":0},{"x":0,"y":0},{"x":0,"y":40}])",
                        cord_properties),
                 "corners 1 and 2");
  expect_refused(object("circle", R"("width":10,"height":14,"ellipse":true)"), "as wide as high");
  expect_refused(object("circle", disc, R"({"name":"body","type":"string","value":"ghost"})"), "ghost");
  expect_refused(object("circle", disc, number("density", "-1")), "density");
  expect_refused(object("ground", disc), "ellipse");
  expect_refused(
      object("ground", R"("width":0,"height":0,"polygon":[{"x":0,"y":0},{"x":40,"y":0},{"x":80,"y":0.000001}])"),
      "sliver");
  // A star: every corner turns the same way, and yet it is not convex.
  expect_refused(
      object("ground", R"("width":0,"height":0,"polygon":[{"x":0,"y":-40},{"x":23,"y":32},{"x":-38,"y":-12},)"
                       R"({"x":38,"y":-12},{"x":-23,"y":32}])"),
      "convex");
  expect_refused(object("ground", R"("width":0,"height":0,"polygon":[{"x":0,"y":0},{"x":40,"y":0},{"x":10,"y":10},)"
                                  R"({"x":0,"y":40}])"),
                 "convex");
}

TEST(Scene, RefusesUnknownPropertiesOfTheMapAndTooManyObjects) {
  TiledMap map = map_with(object("player", box));
  map.properties.insert("gravty_y", -1.6);
  EXPECT_THROW(Scene(map, {"player"}), MapError);
  TiledMap crowded = map_with(object("player", box));
  crowded.objects.resize(2001, crowded.objects[0]);
  EXPECT_THROW(Scene(crowded, {"player"}), MapError);
}

TEST(Scene, AnyShapeOfAKnownOtherKindIsLeftToTheCaller) {
  EXPECT_NO_THROW(Scene(map_with(object("player", box)), {"player"}));
}

}  // namespace
}  // namespace engine
