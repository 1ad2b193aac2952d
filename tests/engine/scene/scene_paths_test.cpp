// Bodies that follow paths and carry cords, and balloons.

#include "engine/scene/scene_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ribbon/box2d/convert.h"
#include "tests/engine/scene/scene_map.h"
#include "tests/support/constants.h"

namespace engine {
namespace {

using constants::dt;
using ribbon::Vec2;

MapObject path(std::vector<Vec2> points, bool closed = false) {
  MapObject object = thing(5, "path", closed ? MapShape::polygon : MapShape::polyline, points.front());
  object.points = std::move(points);
  return object;
}

MapObject rider(Vec2 at, double speed) {
  MapObject object = thing(8, "circle", MapShape::ellipse, at, {0.4, 0.4});
  object.properties.insert("path", std::int64_t{5});
  object.properties.insert("speed", speed);
  return object;
}

MapObject rope(Vec2 top) {
  MapObject object = thing(7, "cord", MapShape::polyline, top);
  object.points = {top, top - Vec2{0.0, 2.0}};
  object.properties.insert("columns", std::int64_t{21});
  object.properties.insert("mass", 0.4);
  return object;
}

Vec2 place(const Scene& scene) { return ribbon::box2d::to_double(scene.bodies()[0].body->GetPosition()); }

TEST(Track, TurnsBackAtItsEndsOrGoesRound) {
  const Track open({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, false);
  EXPECT_EQ(open.length(), 7.0);
  EXPECT_EQ(open.at(0.0), (Vec2{0.0, 0.0}));
  EXPECT_EQ(open.at(5.0), (Vec2{3.0, 2.0}));
  EXPECT_EQ(open.at(7.0), (Vec2{3.0, 4.0}));
  EXPECT_EQ(open.at(9.0), (Vec2{3.0, 2.0}));
  EXPECT_EQ(open.at(14.0 + 1.0), (Vec2{1.0, 0.0}));
  EXPECT_EQ(open.nearest({1.0, 0.5}), 1.0);
  EXPECT_EQ(open.nearest({9.0, 1.0}), 4.0);
  const Track closed({{0.0, 0.0}, {3.0, 0.0}, {3.0, 4.0}}, true);
  EXPECT_EQ(closed.length(), 12.0);
  EXPECT_EQ(closed.at(7.0 + 2.5), (Vec2{1.5, 2.0}));
  EXPECT_EQ(closed.at(12.0 + 5.0), (Vec2{3.0, 2.0}));
}

TEST(ScenePath, ACircleIsOnItsPathAtTheEndOfEachTick) {
  for (const bool closed : {false, true}) {
    const MapObject way = path({{2.0, 2.0}, {6.0, 2.0}, {6.0, 5.0}}, closed);
    const Track track(way.points, closed);
    Scene scene(map_of({rider({3.0, 2.0}, 2.5), way}));
    for (int k = 1; k <= 1200; ++k) {
      scene.tick(dt);
      ASSERT_LT(length(place(scene) - track.at(1.0 + 2.5 * k * dt)), 1e-5) << "tick " << k;
    }
  }
}

TEST(ScenePath, ACircleBeginsOnItsPathEvenIfItIsDrawnBesideIt) {
  const Scene scene(map_of({rider({3.0, 2.1}, 1.0), path({{2.0, 2.0}, {6.0, 2.0}})}));
  EXPECT_LT(length(place(scene) - Vec2{3.0, 2.0}), 1e-6);
  EXPECT_EQ(scene.bodies()[0].body->GetType(), b2_kinematicBody);
}

TEST(ScenePath, ItsTimeIsItsState) {
  const auto made = [] { return map_of({rider({3.0, 2.0}, 2.5), path({{2.0, 2.0}, {6.0, 2.0}, {6.0, 5.0}})}); };
  Scene one(made());
  for (int k = 0; k < 77; ++k) one.tick(dt);
  Scene other(made());
  other.rides().set_time(one.rides().time());
  for (int k = 0; k < 3; ++k) {  // in the first tick Box2D moves a body by at most 2 m
    one.tick(dt);
    other.tick(dt);
  }
  EXPECT_LT(length(place(one) - place(other)), 1e-5);
}

TEST(ScenePath, ACircleCarriesTheEndOfACord) {
  MapObject crane = rider({3.0, 8.0}, 1.0);
  crane.properties.insert("cord", std::int64_t{7});
  Scene scene(map_of({crane, path({{3.0, 8.0}, {6.0, 8.0}}), rope({3.0, 7.9})}));
  for (int k = 0; k < 240; ++k) {
    scene.tick(dt);
    ASSERT_LT(length(scene.coupling().cord(0).positions()[0] - place(scene) - Vec2{0.0, -0.1}), 1e-3) << "tick " << k;
  }
  EXPECT_EQ(scene.coupling().cord(0).island_total().unconverged, 0);
}

TEST(ScenePath, AnAnchorOnABodyGoesWithIt) {
  MapObject wheel = thing(8, "circle", MapShape::ellipse, {5.0, 7.0}, {2.0, 2.0});
  wheel.properties.insert("body", std::string("kinematic"));
  wheel.properties.insert("spin", 1.0);
  MapObject anchor = thing(9, "anchor", MapShape::point, {6.0, 7.0});
  anchor.properties.insert("body", std::int64_t{8});
  Scene scene(map_of({wheel, rope({6.0, 7.0}), anchor}));
  for (int k = 1; k <= 180; ++k) {
    scene.tick(dt);
    const Vec2 rim = Vec2{5.0, 7.0} + Vec2{std::cos(k * dt), std::sin(k * dt)};
    ASSERT_LT(length(scene.coupling().cord(0).positions()[0] - rim), 1e-3) << "tick " << k;
  }
}

TEST(SceneBalloon, RisesByItsGravityScaleAndTakesACordAlong) {
  MapObject balloon = thing(8, "circle", MapShape::ellipse, {5.0, 4.0}, {1.0, 1.0});
  balloon.properties.insert("gravity_scale", -0.5);
  balloon.properties.insert("density", 4.0);
  Scene scene(map_of({balloon}));
  for (int k = 0; k < 60; ++k) scene.tick(dt);
  EXPECT_NEAR(place(scene).y, 4.0 + 0.5 * 0.5 * 9.81, 0.1);
  balloon.properties.insert("cord", std::int64_t{7});
  MapObject line = rope({5.0, 3.5});
  line.properties.insert("pin_last", true);
  Scene moored(map_of({balloon, line}));
  for (int k = 0; k < 300; ++k) moored.tick(dt);
  EXPECT_NEAR(place(moored).y, 4.0, 0.02) << "its cord holds it";
}

TEST(ScenePath, IsRefusedWithTheObjectAndPropertyNamed) {
  const MapObject way = path({{2.0, 2.0}, {6.0, 2.0}});
  const auto says = [](const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << message;
  };
  says(refusal(map_of({rider({3.0, 2.0}, 1.0)})), "object 8: property \"path\" is 5, and there is no such object");
  says(refusal(map_of({rider({3.0, 2.0}, 0.0), way})), "\"speed\" is 0, accepted is a number from 0.01 to 100");
  says(refusal(map_of({rider({3.0, 3.0}, 1.0), way})),
       "its centre is 1 m from its path; accepted is one within 0.25 m");
  MapObject falling = rider({3.0, 2.0}, 1.0);
  falling.properties.insert("body", std::string("dynamic"));
  says(refusal(map_of({falling, way})), "property \"body\" is \"dynamic\" of a circle with \"path\"; accepted is");
  MapObject fast = rider({3.0, 2.0}, 1.0);
  fast.properties.insert("velocity_y", 1.0);
  says(refusal(map_of({fast, way})), "has \"path\" and \"velocity_y\"; accepted is one or the other");
  says(refusal(map_of({path({{2.0, 2.0}, {2.0, 2.001}})})), "closer than the 0.01 m accepted");
  says(refusal(map_of({thing(5, "path", MapShape::rectangle, {1.0, 1.0}, {1.0, 1.0})})), "the shape of a path is rect");
  MapObject anchor = thing(9, "anchor", MapShape::point, {6.0, 7.0});
  anchor.properties.insert("body", std::int64_t{7});
  says(refusal(map_of({rope({6.0, 7.0}), anchor})), "property \"body\" is 7, an object of class \"cord\"; accepted is");
  MapObject heavy = thing(8, "circle", MapShape::ellipse, {5.0, 4.0}, {1.0, 1.0});
  heavy.properties.insert("gravity_scale", 1e6);
  says(refusal(map_of({heavy})), "\"gravity_scale\" is 1e+06, accepted is a number from -100 to 100");
}

}  // namespace
}  // namespace engine
