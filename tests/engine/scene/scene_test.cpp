#include "engine/scene/scene.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/engine/scene/scene_json.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using test_support::refusal;
using test_support::says;

TEST(Scene, BuildsWhatTheMapDeclares) {
  const Scene scene(map_with(object("cord", line, cord_properties + "," + whole("rows", "3") + "," + yes("pin_first"))),
                    {});
  ASSERT_EQ(scene.coupling().size(), 1);
  const ribbon::ThesisCord& cord = scene.coupling().cord(0).thesis();
  EXPECT_EQ(cord.mesh().w, 9);
  EXPECT_EQ(cord.mesh().h, 3);
  EXPECT_DOUBLE_EQ(cord.mesh().spacing, 0.5);
  EXPECT_DOUBLE_EQ(cord.def().point_mass, 1.8 / 27);
  EXPECT_EQ(cord.def().bar_damping, 0.0);  // not declared
  EXPECT_FALSE(cord.def().self_collision);
  EXPECT_EQ(cord.kind(0), ribbon::PointKind::constrained);
  EXPECT_EQ(cord.kind(2), ribbon::PointKind::constrained);
  EXPECT_EQ(cord.kind(3), ribbon::PointKind::free);
  EXPECT_NEAR(cord.positions()[1].x, 2.0, 1e-12);  // from (2, 7), the map's y turned up, down to (2, 3)
  EXPECT_NEAR(cord.positions()[1].y, 7.0, 1e-12);
  EXPECT_NEAR(cord.positions()[25].y, 3.0, 1e-12);
}

TEST(Scene, BuildsADirectCordAsTheMapDeclares) {
  const std::string declared =
      direct_properties + "," + whole("rows", "3") + "," + number("width", "0.6") + "," + number("radius", "0.03") +
      "," + number("stretch_stiffness", "5000") + "," + number("bending_stiffness", "7") + "," +
      number("poisson_ratio", "0.3") + "," + number("area_stiffness", "1.5") + "," + number("damping", "0.02") + "," +
      number("drag", "0.1") + "," + number("gravity_scale", "-0.5") + "," + number("friction", "0.4") + "," +
      number("restitution", "0.7") + "," + yes("self_contact") + "," + yes("cord_contact") + "," + yes("allow_sleep") +
      "," + text("accuracy", "accurate") + "," + number("tolerance", "0.003") + "," + whole("max_iterations", "5") +
      "," + whole("max_work", "77") + "," + number("breaking_force", "60") + "," + yes("pin_last");
  const Scene scene(map_with(object("cord", line, declared)));
  const ribbon::Cord& cord = scene.coupling().cord(0).direct();
  const ribbon::CordDef& def = cord.def();
  EXPECT_EQ(def.points, 9);
  EXPECT_EQ(def.rows, 3);
  EXPECT_NEAR(def.length, 4.0, 1e-12);
  EXPECT_EQ(def.width, 0.6);
  EXPECT_EQ(def.radius, 0.03);
  EXPECT_NEAR(def.mass_per_length, 1.8 / 4.0, 1e-12);
  EXPECT_EQ(def.stretch_stiffness, 5000.0);
  EXPECT_EQ(def.bending_stiffness, 7.0);
  EXPECT_EQ(def.poisson_ratio, 0.3);
  EXPECT_EQ(def.area_stiffness, 1.5);
  EXPECT_EQ(def.breaking_force, 60.0);
  EXPECT_EQ(def.damping, 0.02);
  EXPECT_EQ(def.drag, 0.1);
  EXPECT_EQ(def.gravity_scale, -0.5);
  EXPECT_EQ(def.friction, 0.4);
  EXPECT_EQ(def.restitution, 0.7);
  EXPECT_TRUE(def.self_contact);
  EXPECT_TRUE(def.cord_contact);
  EXPECT_TRUE(def.allow_sleep);
  EXPECT_EQ(def.accuracy.substeps, ribbon::Accuracy::accurate().substeps);
  EXPECT_EQ(def.accuracy.tolerance, 0.003);
  EXPECT_EQ(def.accuracy.max_iterations, 5);
  EXPECT_EQ(def.accuracy.max_work, 77);
  EXPECT_EQ(def.pins, (std::vector<int>{24, 25, 26}));
  EXPECT_NEAR(cord.positions()[0].x, 1.7, 1e-12);  // down from (2, 7): the first row to its right
  EXPECT_NEAR(cord.positions()[2].x, 2.3, 1e-12);
  EXPECT_NEAR(cord.positions()[25].y, 3.0, 1e-12);
}

/// A term that is not declared is off; each preset and `tension_only` are passed on.
TEST(Scene, ADirectCordHasOnlyWhatItDeclares) {
  const auto def_of = [](const std::string& more) {
    return Scene(map_with(object("cord", line, direct_properties + more))).coupling().cord(0).direct().def();
  };
  ribbon::CordDef plain;
  const ribbon::CordDef def = def_of("");
  EXPECT_EQ(def.rows, 1);
  EXPECT_EQ(def.width, 0.0);
  EXPECT_EQ(def.radius, plain.radius);
  EXPECT_EQ(def.stretch_stiffness, std::numeric_limits<double>::infinity());
  EXPECT_EQ(def.bending_stiffness + def.area_stiffness + def.damping + def.drag, 0.0);
  EXPECT_EQ(def.drag_across + def.drag_along + def.displaced_area, 0.0);
  EXPECT_EQ(def.friction + def.restitution, 0.0);
  EXPECT_EQ(def.gravity_scale, 1.0);
  EXPECT_FALSE(def.tension_only || def.self_contact || def.cord_contact || def.allow_sleep);
  EXPECT_EQ(def.accuracy, ribbon::Accuracy::balanced());
  EXPECT_TRUE(def.pins.empty());
  EXPECT_EQ(def.breaking_force, std::numeric_limits<double>::infinity());
  EXPECT_EQ(def_of("," + number("breaking_force", "450")).breaking_force, 450.0);
  EXPECT_TRUE(def_of("," + yes("tension_only")).tension_only);
  EXPECT_TRUE(def_of("," + yes("self_contact")).self_contact);
  EXPECT_TRUE(def_of("," + yes("cord_contact")).cord_contact);
  EXPECT_EQ(def_of("," + text("accuracy", "fast")).accuracy, ribbon::Accuracy::fast());
  EXPECT_EQ(def_of("," + text("accuracy", "accurate")).accuracy, ribbon::Accuracy::accurate());
  EXPECT_EQ(def_of("," + whole("substeps", "3")).accuracy.substeps, 3);
  const ribbon::CordDef strip = def_of("," + whole("rows", "2") + "," + number("stretch_stiffness", "5000"));
  EXPECT_NEAR(strip.width, 0.5, 1e-12);  // square cells
}

TEST(Scene, ACordWithoutASolverHasTheDefault) {
  const std::string own =
      Scene::default_solver == ribbon::box2d::Solver::thesis ? number("spring_stiffness", "1000") : yes("pin_first");
  const Scene scene(map_with(object("cord", line, either_cord + "," + own)));
  EXPECT_EQ(scene.coupling().cord(0).solver(), Scene::default_solver);
}

/// Links that cut a corner, and those of a path that folds back on itself, have their rest length. So nothing moves.
TEST(Scene, ADirectCordAroundCornersStartsAtRest) {
  for (const char* path : {R"({"x":0,"y":0},{"x":13,"y":21},{"x":40,"y":-5},{"x":60,"y":-5})",
                           R"({"x":0,"y":0},{"x":50,"y":0},{"x":1,"y":1},{"x":51,"y":2})"}) {
    TiledMap map = map_with(object("cord", R"("width":0,"height":0,"polyline":[)" + std::string(path) + "]",
                                   direct_properties + "," + yes("pin_first") + "," + yes("pin_last")));
    map.properties.insert("gravity_y", 0.0);
    Scene scene(map);
    scene.tick(1.0 / 60.0);
    for (const ribbon::Vec2 v : scene.coupling().cord(0).direct().velocities()) EXPECT_LT(length(v), 1e-9) << path;
  }
}

TEST(Scene, ADirectCordExtendsFromTheStartOfItsPathToTheEnd) {
  const std::string path = R"("width":0,"height":0,"polyline":[{"x":0,"y":0},{"x":13,"y":21},{"x":40,"y":-5}])";
  const Scene scene(map_with(object("cord", path, direct_properties)));
  EXPECT_LT(length(scene.coupling().cord(0).positions().front() - ribbon::Vec2{2.0, 7.0}), 1e-12);
  EXPECT_LT(length(scene.coupling().cord(0).positions().back() - ribbon::Vec2{6.0, 7.5}), 1e-9);
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

/// Checks that the message names file, object and cause.
void expect_refused(const std::string& objects, const std::string& about) {
  SCOPED_TRACE(objects);
  const std::string message = refusal<MapError>([&] { const Scene scene(map_with(objects), {"player"}); });
  EXPECT_TRUE(says(message, "test.tmj"));
  EXPECT_TRUE(says(message, "7"));
  EXPECT_TRUE(says(message, about));
}

TEST(Scene, RefusesInvalidObjects) {
  expect_refused(object("sail", box), "sail");
  expect_refused(object("", box), "player");  // names what is accepted
  expect_refused(object("cord", box, cord_properties), "polyline");
  expect_refused(object("cord", line), "columns");
  expect_refused(object("cord", line, cord_properties + "," + whole("rows", "1")), "rows");
  expect_refused(object("cord", line, cord_properties + "," + number("stiffness", "1")), "stiffness");
  expect_refused(object("cord", line, cord_properties + "," + whole("substeps", "0")), "substeps");
  expect_refused(object("cord", line,
                        text("solver", "thesis") + "," + whole("columns", "9") + "," + number("mass", "0") + "," +
                            number("spring_stiffness", "1000")),
                 "mass");
  expect_refused(object("cord", line, text("solver", "magic") + "," + either_cord), "thesis, direct");
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
  // A star: every corner turns in the same direction, but the polygon is not convex.
  expect_refused(
      object("ground", R"("width":0,"height":0,"polygon":[{"x":0,"y":-40},{"x":23,"y":32},{"x":-38,"y":-12},)"
                       R"({"x":38,"y":-12},{"x":-23,"y":32}])"),
      "convex");
  // The area is so small that single precision cannot distinguish the polygon from an oblique line.
  expect_refused(object("ground", R"("rotation":30,"width":0,"height":0,"polygon":[{"x":0,"y":0},{"x":9000000,"y":0},)"
                                  R"({"x":4500000,"y":0.1}])"),
                 "sliver");
  expect_refused(object("ground", R"("width":0,"height":0,"polygon":[{"x":0,"y":0},{"x":40,"y":0},{"x":10,"y":10},)"
                                  R"({"x":0,"y":40}])"),
                 "convex");
}

TEST(Scene, RefusesAnInvalidDirectCord) {
  const auto refused = [](const std::string& more, const std::string& about) {
    expect_refused(object("cord", line, direct_properties + "," + more), about);
  };
  refused(number("stiffness", "1"), "stretch_stiffness");  // names what is accepted
  refused(text("accuracy", "perfect"), "fast, balanced, accurate");
  refused(number("tolerance", "0"), "tolerance");
  refused(whole("max_iterations", "0"), "max_iterations");
  refused(whole("max_iterations", "1001"), "1 to 1000");
  refused(whole("max_work", "0"), "max_work");
  refused(whole("substeps", "0"), "substeps");
  refused(whole("rows", "0"), "rows");
  refused(whole("rows", "2"), "stretch_stiffness");  // a ribbon stretches
  refused(number("stretch_stiffness", "-1"), "stretch_stiffness");
  refused(number("friction", "-0.1"), "friction");
  refused(number("friction", "10.5"), "friction");
  refused(number("restitution", "1.1"), "restitution");
  refused(number("gravity_scale", "1001"), "gravity_scale");
  refused(number("drag_across", "-1"), "drag_across");
  refused(number("drag_along", "1001"), "drag_along");
  refused(number("displaced_area", "-1"), "displaced_area");
  refused(number("breaking_force", "-1"), "breaking_force");
  refused(number("self_contact", "1"), "self_contact");
  refused(number("allow_sleep", "1"), "allow_sleep");
  refused(number("width", "0.1"), "rope");  // what the definition's own check says
  refused(whole("rows", "3") + "," + number("stretch_stiffness", "5000"), "bending_stiffness");
  expect_refused(object("cord", box, direct_properties), "polyline");
}

/// If only `solver` of a cord is changed, the message names the properties of the other solver.
TEST(Scene, RefusesPropertiesOfTheOtherSolver) {
  expect_refused(object("cord", line, direct_properties + "," + number("spring_stiffness", "1000")), "another solver");
  expect_refused(object("cord", line, direct_properties + "," + yes("self_collision")), "\"direct\"");
  expect_refused(object("cord", line, cord_properties + "," + number("radius", "0.1")), "another solver");
  expect_refused(object("cord", line, cord_properties + "," + yes("tension_only")), "\"thesis\"");
  expect_refused(object("cord", line, cord_properties + "," + number("friction", "0.5")), "another solver");
  const std::string others = Scene::default_solver == ribbon::box2d::Solver::thesis ? "damping" : "bar_damping";
  expect_refused(object("cord", line, either_cord + "," + number(others, "0")), "the default");
}

// --- the state hash of a direct cord

TEST(Scene, RefusesUnknownPropertiesOfTheMapAndTooManyObjects) {
  TiledMap map = map_with(object("player", box));
  map.properties.insert("gravty_y", -1.6);
  EXPECT_THROW(Scene(map, {"player"}), MapError);
  TiledMap crowded = map_with(object("player", box));
  crowded.objects.resize(2001, crowded.objects[0]);
  EXPECT_THROW(Scene(crowded, {"player"}), MapError);
}

/// Each cord alone is accepted. All together would need too much memory, for a file of a few hundred bytes.
TEST(Scene, RefusesMorePointsThanItCanHold) {
  const std::string thick =
      object("cord", line,
             text("solver", "direct") + "," + whole("columns", "5000") + "," + number("mass", "1") + "," +
                 whole("rows", "16") + "," + number("stretch_stiffness", "1000"));
  TiledMap map = map_with(thick);
  map.objects.resize(2, map.objects[0]);
  const std::string message = refusal<MapError>([&] { const Scene scene(map); });
  EXPECT_TRUE(says(message, "have 160000 points"));
  EXPECT_TRUE(says(message, "at most 100000"));
}

TEST(Scene, AnyShapeOfAKnownOtherKindIsPassedToTheCaller) {
  EXPECT_NO_THROW(Scene(map_with(object("player", box)), {"player"}));
}

}  // namespace
}  // namespace engine
