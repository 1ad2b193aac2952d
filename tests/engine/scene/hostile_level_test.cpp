// A level with any numbers runs, or is refused with a message that names the cause.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using test_support::refusal;
using test_support::says;
using test_support::starts_with;

using NamedValue = std::pair<std::string, std::string>;  // name and value, as in the file

std::string property(const NamedValue& p) {
  const char* const type = p.second.find('"') != std::string::npos             ? "string"
                           : p.second == "true"                                ? "bool"
                           : p.second.find_first_of(".e") != std::string::npos ? "float"
                                                                               : "int";
  return R"({"name":")" + p.first + R"(","type":")" + type + R"(","value":)" + p.second + "}";
}

/// A level with one object with these fields and properties, behind others; of equal names the last one counts.
std::string level(const std::string& fields, const std::vector<NamedValue>& properties,
                  const std::string& others = {}) {
  std::string list;
  for (std::size_t k = 0; k < properties.size(); ++k) {
    bool again = false;
    for (std::size_t later = k + 1; later < properties.size(); ++later) {
      again = again || properties[later].first == properties[k].first;
    }
    if (again) continue;
    if (!list.empty()) list += ',';
    list += property(properties[k]);
  }
  return R"({"type":"map","orientation":"orthogonal","width":10,"height":10,"tilewidth":10,"tileheight":10,)"
         R"("layers":[{"type":"objectgroup","objects":[)" +
         others + R"({"id":7,"name":"thing","x":20,"y":30,)" + fields + R"(,"properties":[)" + list + "]}]}]}";
}

bool all_finite(const Scene& scene) {
  for (const ribbon::box2d::CordId c : scene.coupling().cords()) {
    for (const ribbon::Vec2 x : scene.coupling().cord(c).positions()) {
      if (!std::isfinite(x.x) || !std::isfinite(x.y)) return false;
    }
  }
  for (const b2Body* body = scene.world().GetBodyList(); body != nullptr; body = body->GetNext()) {
    if (!body->GetPosition().IsValid() || !std::isfinite(body->GetAngle())) return false;
  }
  return true;
}

/// Checks that the level runs, or that the message of its refusal names file, object and cause.
void expect_runs_or_is_refused(const std::string& text, const std::string& culprit) {
  SCOPED_TRACE(text);
  try {
    Scene scene(parse_tiled_map(text, "hostile.tmj"));
    for (int k = 0; k < 3; ++k) scene.tick(1.0 / 60.0);
    EXPECT_TRUE(all_finite(scene));
  } catch (const MapError& error) {
    EXPECT_TRUE(starts_with(error.what(), "hostile.tmj: object 7 \"thing\""));
    EXPECT_TRUE(says(error.what(), culprit));
    EXPECT_TRUE(says(error.what(), "accepted"));
  }
}

const std::vector<std::string> hostile = {"-1",    "0",      "0.0",    "-0.0",   "1e-300",     "-1e-300",
                                          "1e300", "-1e300", "4e-324", "1.0e38", "2147483647", "-9223372036854775808",
                                          "true",  "\"1\""};

struct Kind {
  std::string fields;
  std::vector<NamedValue> properties;
  std::vector<std::string> numbers;
  std::string others = {};
};

const std::string polyline = R"("class":"cord","polyline":[{"x":0,"y":0},{"x":0,"y":40}])";
const std::string circle = R"("class":"circle","width":10,"height":10,"ellipse":true)";

const std::string load = R"("class":"load","width":10,"height":10)";
/// A path through the middle of the circle.
const std::string path_of_circle =
    R"({"id":8,"class":"path","x":25,"y":35,"polyline":[{"x":0,"y":0},{"x":30,"y":0},{"x":30,"y":20}]},)";

std::string wheel(const std::string& size) {
  return R"("class":"wheel","ellipse":true,"width":)" + size + R"(,"height":)" + size;
}

/// A rope with its corner at the wheel, and a load.
const std::string around_the_wheel =
    R"({"id":8,"class":"cord","x":20,"y":80,"polyline":[{"x":0,"y":0},{"x":5,"y":-55},{"x":10,"y":0}],"properties":[)"
    R"({"name":"columns","type":"int","value":41},{"name":"mass","type":"float","value":1.8}]},)"
    R"({"id":9,"class":"load","x":15,"y":80,"width":10,"height":10,"properties":[)"
    R"({"name":"mass","type":"float","value":5.0},{"name":"cord","type":"object","value":8}]},)";

const std::vector<Kind> kinds = {
    {polyline,
     {{"columns", "9"}, {"mass", "1.8"}, {"pin_first", "true"}},
     {"columns",        "rows",          "mass",        "stretch_stiffness", "bending_stiffness", "damping",
      "drag",           "gravity_scale", "radius",      "substeps",          "tolerance",         "max_iterations",
      "max_work",       "friction",      "restitution", "self_contact",      "allow_sleep",       "accuracy",
      "integrator",     "solver",        "pin_last",    "breaking_force",    "drag_across",       "drag_along",
      "displaced_area", "at_rest"}},
    {polyline,
     {{"columns", "9"},
      {"rows", "3"},
      {"mass", "1.8"},
      {"stretch_stiffness", "5000.0"},
      {"bending_stiffness", "1.0"},
      {"area_stiffness", "1.0"}},
     {"rows", "stretch_stiffness", "bending_stiffness", "poisson_ratio", "area_stiffness", "width", "damping", "mass"}},
    {polyline,
     {{"solver", "\"thesis\""}, {"columns", "9"}, {"mass", "1.8"}, {"spring_stiffness", "1000.0"}},
     {"columns", "rows", "mass", "spring_stiffness", "bar_damping", "drag", "area_stiffness", "substeps",
      "self_collision"}},
    {circle,
     {},
     {"body", "density", "friction", "restitution", "angular_damping", "velocity_x", "velocity_y", "spin",
      "gravity_scale", "cord", "path", "speed", "sticky"}},
    {circle, {{"path", "8"}}, {"body", "velocity_x", "velocity_y", "spin", "path", "speed"}, path_of_circle},
    {load,
     {{"mass", "5.0"}},
     {"mass", "friction", "restitution", "angular_damping", "gravity_scale", "cord", "sticky"}},
    {R"("class":"path","polyline":[{"x":0,"y":0},{"x":0,"y":40}])", {}, {"speed"}},
    {R"("class":"ground","width":40,"height":10)", {}, {"friction", "sticky"}},
    {wheel("10"),
     {{"cord", "8"}},
     {"cord", "body", "turns", "inertia", "friction", "motor_speed", "motor_torque"},
     around_the_wheel},
};

TEST(HostileLevel, EveryPropertyIsAcceptedOrRefusedByName) {
  for (const Kind& kind : kinds) {
    for (const std::string& name : kind.numbers) {
      for (const std::string& value : hostile) {
        std::vector<NamedValue> properties = kind.properties;
        properties.emplace_back(name, value);
        expect_runs_or_is_refused(level(kind.fields, properties, kind.others), name);
      }
    }
  }
}

/// The wheel is where its rope is: what is refused above is refused for its value.
TEST(HostileLevel, AWheelWithoutAHostileValueTurns) {
  Scene scene(parse_tiled_map(level(wheel("10"), {{"cord", "8"}}, around_the_wheel), "plain.tmj"));
  ASSERT_EQ(scene.wheels().size(), 1U);
  for (int k = 0; k < 10; ++k) scene.tick(1.0 / 60.0);
  EXPECT_NE(scene.coupling().pulley(scene.wheels()[0].pulley).state().turning, 0.0);
}

std::string ground_with(const std::string& name, const std::string& value) {
  return R"("class":"ground",")" + std::string(name == "width" ? "height" : "width") + R"(":10,")" + name +
         "\":" + value;
}

std::string cord_to(const std::string& x) {
  return R"("class":"cord","polyline":[{"x":0,"y":0},{"x":)" + x + R"(,"y":40}])";
}

std::string turned_circle(const std::string& degrees) { return circle + R"(,"rotation":)" + degrees; }

/// The fields of the object itself accept only numbers.
TEST(HostileLevel, EveryPositionAndSizeIsAcceptedOrRefusedByName) {
  for (const std::string& value : hostile) {
    if (value.find_first_of("t\"") != std::string::npos) continue;
    for (const std::string name : {"width", "height"}) {
      expect_runs_or_is_refused(level(ground_with(name, value), {}), name);
    }
    expect_runs_or_is_refused(level(turned_circle(value), {}), "rotation");
    expect_runs_or_is_refused(level(wheel(value), {{"cord", "8"}}, around_the_wheel), "");
    expect_runs_or_is_refused(level(cord_to(value), {{"columns", "9"}, {"mass", "1.8"}}), "");
  }
}

/// An object that is a ribbon of 50,000 points.
std::string wide_ribbon(const std::string& id) {
  std::string ribbon = R"({"id":)" + id + R"(,"x":0,"y":0,)" + polyline + R"(,"properties":[)";
  for (const NamedValue& p :
       {NamedValue{"mass", "1.0"}, {"rows", "10"}, {"stretch_stiffness", "1e6"}, {"bending_stiffness", "1e-3"}}) {
    ribbon += property(p);
    ribbon += ',';
  }
  return ribbon + property({"columns", "5000"}) + "]}";
}

TEST(HostileLevel, ALevelTooLargeForMemoryIsRefused) {
  const std::string cords = wide_ribbon("1") + "," + wide_ribbon("2") + "," + wide_ribbon("3");
  const std::string text =
      R"({"type":"map","orientation":"orthogonal","width":10,"height":10,"tilewidth":10,"tileheight":10,)"
      R"("layers":[{"type":"objectgroup","objects":[)" +
      cords + "]}]}";
  EXPECT_EQ(refusal<MapError>([&] { const Scene scene(parse_tiled_map(text, "many.tmj")); }),
            "many.tmj: object 3: the cords up to this one have 150000 points, columns times rows; accepted are at most "
            "100000");
}

std::string reference_to_99(const std::string& name) {
  return R"({"name":")" + name + R"(","type":"object","value":99},)";
}

/// No property of a cord refers to another object. One that does is unknown, and the message lists the known ones.
TEST(HostileLevel, AReferenceToAnObjectIsRefusedByItsName) {
  for (const std::string reference : {"anchor", "load", "target"}) {
    std::string referring = level(polyline, {{"columns", "9"}, {"mass", "1.8"}});
    const std::string list = R"("properties":[)";
    referring.insert(referring.find(list) + list.size(), reference_to_99(reference));
    EXPECT_TRUE(says(refusal<MapError>([&] { const Scene scene(parse_tiled_map(referring, "hostile.tmj")); }),
                     "property \"" + reference + "\" is unknown, accepted are: solver"));
  }
}

}  // namespace
}  // namespace engine
