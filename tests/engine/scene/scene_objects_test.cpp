// Loads, anchors, ribbons and solid cords of a map.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

#include "ribbon/box2d/convert.h"
#include "tests/engine/scene/scene_map.h"

namespace engine {
namespace {

using ribbon::Vec2;

/// A cord of 2 m that hangs from (5, 9), pinned unless an anchor does that.
MapObject cord(int id, bool pinned = true) {
  MapObject object = thing(id, "cord", MapShape::polyline, {5.0, 9.0});
  object.points = {{5.0, 9.0}, {5.0, 7.0}};
  object.properties.insert("columns", std::int64_t{21});
  object.properties.insert("mass", 0.4);
  object.properties.insert("pin_first", pinned);
  return object;
}

/// A load 1 m wide and high, with its top 0.2 m below the cord's end.
MapObject block_on(int id, std::int64_t of_cord) {
  MapObject object = thing(id, "load", MapShape::rectangle, {5.0, 6.3});
  object.size = {1.0, 1.0};
  object.properties.insert("mass", 400.0);
  if (of_cord != 0) object.properties.insert("cord", of_cord);
  return object;
}

TEST(SceneLoad, HangsFromTheNearerEndOfTheCordItNames) {
  Scene scene(map_of({block_on(8, 7), cord(7)}));  // in either order
  ASSERT_EQ(scene.bodies().size(), 1U);
  const SceneBody made = scene.bodies()[0];
  EXPECT_EQ(made.kind, BodyKind::load);
  EXPECT_EQ(made.object, 8);
  EXPECT_NEAR(made.body->GetMass(), 400.0F, 1e-3F);
  const auto held = scene.coupling().body(*made.body).held_place();
  ASSERT_TRUE(held);
  EXPECT_EQ(held->point, 20);
  for (int k = 0; k < 300; ++k) scene.tick(1.0 / 60.0);
  EXPECT_NEAR(static_cast<double>(made.body->GetPosition().y), 6.3, 1e-3);  // a thousand times as heavy: no stretch
}

/// The top of the load is at the cord's end or above: a holder does not collide with its cord.
TEST(SceneLoad, HangsByItsTopEdgeOrFromWithin) {
  for (const double y : {6.5, 6.8}) {
    SCOPED_TRACE(y);
    MapObject block = block_on(8, 7);
    block.position = {5.0, y};
    Scene scene(map_of({cord(7), block}));
    b2Body& body = *scene.bodies()[0].body;
    body.SetLinearVelocity({2.0F, 0.0F});
    const auto from_pin = [&] {
      return (body.GetWorldPoint({0.0F, static_cast<float>(7.0 - y)}) - b2Vec2(5.0F, 9.0F)).Length();
    };
    for (int k = 0; k < 600; ++k) {
      scene.tick(1.0 / 60.0);
      ASSERT_TRUE(scene.coupling().body(body).held_place());
      ASSERT_NEAR(from_pin(), 2.0F, 2e-3F) << k;
    }
    EXPECT_EQ(scene.coupling().cord(0).island_total().unconverged, 0);
  }
}

TEST(SceneLoad, WithoutACordFalls) {
  Scene scene(map_of({block_on(8, 0)}));
  for (int k = 0; k < 60; ++k) scene.tick(1.0 / 60.0);
  EXPECT_LT(scene.bodies()[0].body->GetPosition().y, 2.0F);
}

TEST(SceneLoad, IsRefusedWithTheObjectAndPropertyNamed) {
  EXPECT_NE(refusal(map_of({cord(7), block_on(8, 12)})).find("object 8"), std::string::npos);
  EXPECT_NE(refusal(map_of({cord(7), block_on(8, 12)})).find("\"cord\" is 12, and there is no such object"),
            std::string::npos);
  EXPECT_NE(refusal(map_of({cord(7), block_on(8, 9), block_on(9, 0)})).find("an object of class \"load\""),
            std::string::npos);
  MapObject far = block_on(8, 7);
  far.position = {5.0, 2.0};
  EXPECT_NE(refusal(map_of({cord(7), far})).find("from the end of its cord"), std::string::npos);
  MapObject shape = block_on(8, 7);
  shape.shape = MapShape::point;
  EXPECT_NE(refusal(map_of({cord(7), shape})).find("the shape of a load is point"), std::string::npos);
  MapObject none = block_on(8, 7);
  none.properties = Properties("test.tmj: object 8");
  EXPECT_NE(refusal(map_of({cord(7), none})).find("mass"), std::string::npos);
}

TEST(SceneAnchor, ConstrainsTheNearestPointToItsPlace) {
  MapObject anchor = thing(9, "anchor", MapShape::point, {5.1, 9.0});
  Scene scene(map_of({cord(7, false), anchor}));
  EXPECT_EQ(scene.coupling().cord(0).kind(0), ribbon::PointKind::constrained);
  EXPECT_EQ(scene.coupling().cord(0).kind(1), ribbon::PointKind::free);
  scene.tick(1.0 / 60.0);
  EXPECT_NEAR(scene.coupling().cord(0).positions()[0].x, 5.1, 1e-12);
  EXPECT_THROW(scene.coupling().cord(1).pin(0, {}), ribbon::CallError);
  EXPECT_THROW(scene.coupling().cord(0).pin(21, {}), ribbon::DefinitionError);
}

TEST(SceneAnchor, ConstrainsTheCordThatItNames) {
  MapObject other = cord(6, false);
  for (Vec2& point : other.points) point.x += 0.02;
  MapObject anchor = thing(9, "anchor", MapShape::point, {5.0, 9.0});
  anchor.properties.insert("cord", std::int64_t{6});
  const Scene scene(map_of({cord(7, false), other, anchor}));
  EXPECT_EQ(scene.coupling().cord(0).kind(0), ribbon::PointKind::free);
  EXPECT_EQ(scene.coupling().cord(1).kind(0), ribbon::PointKind::constrained);
}

/// A cord that begins 0.1 m beside the end of cord 7.
MapObject next_cord(int id) {
  MapObject object = cord(id, false);
  object.points = {{5.1, 7.0}, {5.1, 5.0}};
  return object;
}

TEST(SceneTie, TiesTheNearestPointsOfTwoCords) {
  MapObject tie = thing(9, "tie", MapShape::point, {5.05, 7.0});
  tie.properties.insert("breaking_force", 77.0);
  Scene scene(map_of({tie, cord(7), next_cord(8)}));
  const ribbon::box2d::TieState state = scene.coupling().tie(1).state();
  EXPECT_EQ(state.cord + state.other_cord, 1);
  EXPECT_EQ(state.point + state.other_point, 20);
  EXPECT_NEAR(state.gap, 0.1, 1e-12);
  for (int k = 0; k < 120; ++k) scene.tick(1.0 / 60.0);
  EXPECT_EQ(scene.coupling().tie(1).state().gap, 0.0);
  EXPECT_EQ(scene.coupling().save(scene.world()).ties[0].breaking_force, 77.0);
}

TEST(SceneTie, TiesTheCordsThatItNames) {
  MapObject tie = thing(9, "tie", MapShape::point, {5.0, 7.0});
  tie.properties.insert("cord", std::int64_t{6});
  tie.properties.insert("other_cord", std::int64_t{8});
  MapObject named = cord(6);
  for (Vec2& point : named.points) point.x += 0.02;
  const Scene scene(map_of({cord(7), named, next_cord(8), tie}));
  EXPECT_EQ(scene.coupling().tie(1).state().cord, 1);
  EXPECT_EQ(scene.coupling().tie(1).state().other_cord, 2);
}

TEST(SceneTie, IsRefusedWhereItCannotBe) {
  const MapObject far = thing(9, "tie", MapShape::point, {5.0, 7.0});
  EXPECT_NE(refusal(map_of({cord(7), far})).find("within 0.25 m of points of two cords"), std::string::npos);
  const MapObject box = thing(9, "tie", MapShape::ellipse, {5.0, 7.0});
  EXPECT_NE(refusal(map_of({cord(7), next_cord(8), box})).find("the shape of a tie is ellipse"), std::string::npos);
  MapObject itself = far;
  itself.properties.insert("cord", std::int64_t{7});
  itself.properties.insert("other_cord", std::int64_t{7});
  EXPECT_NE(refusal(map_of({cord(7), itself})).find("to itself"), std::string::npos);
  const MapObject twice = thing(10, "tie", MapShape::point, {5.0, 7.0});
  EXPECT_NE(refusal(map_of({cord(7), next_cord(8), far, twice})).find("already"), std::string::npos);
}

TEST(SceneAnchor, IsRefusedWithoutACordNearIt) {
  const MapObject anchor = thing(9, "anchor", MapShape::point, {2.0, 9.0});
  EXPECT_NE(refusal(map_of({cord(7), anchor})).find("within 0.25 m"), std::string::npos);
  const MapObject box = thing(9, "anchor", MapShape::ellipse, {5.0, 9.0});
  EXPECT_NE(refusal(map_of({cord(7), box})).find("the shape of an anchor is ellipse"), std::string::npos);
}

TEST(SceneRibbon, IsACordOfThreeRowsUnlessGiven) {
  MapObject cloth = cord(7);
  cloth.kind = "ribbon";
  cloth.properties.insert("stretch_stiffness", 5000.0);
  cloth.properties.insert("bending_stiffness", 1.0);
  EXPECT_EQ(Scene(map_of({cloth})).coupling().cord(0).shape().rows, 3);
  EXPECT_EQ(Scene(map_of({cloth})).cord_object(0), 7);
  EXPECT_EQ(Scene(map_of({cloth})).cord_object(5), 0);
  cloth.properties.insert("rows", std::int64_t{1});
  EXPECT_NE(refusal(map_of({cloth})).find("rows"), std::string::npos);
}

/// A ball of a category that does not collide with the game's cords.
TEST(SceneCord, IfSolidCollidesOutsideTheFilterOfOtherCords) {
  const auto lowest = [](bool solid) {
    MapObject bridge = cord(7);
    bridge.points = {{3.0, 5.0}, {7.0, 5.0}};
    bridge.properties.insert("pin_last", true);
    bridge.properties.insert("radius", 0.1);
    bridge.properties.insert("solid", solid);
    b2Filter keeps_out;
    keeps_out.maskBits = 0xFFFD;
    Scene scene(map_of({bridge}), {}, keeps_out);
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = {5.0F, 6.0F};
    b2Body* ball = scene.world().CreateBody(&definition);
    b2CircleShape disc;
    disc.m_radius = 0.3F;
    b2FixtureDef fixture;
    fixture.shape = &disc;
    fixture.density = 1.0F;
    fixture.filter.categoryBits = 0x0002;
    ball->CreateFixture(&fixture);
    for (int k = 0; k < 120; ++k) scene.tick(1.0 / 60.0);
    return static_cast<double>(ball->GetPosition().y);
  };
  EXPECT_GT(lowest(true), 4.5);
  EXPECT_LT(lowest(false), 0.0);
}

/// A rope that is laid along two straight lines swings by half a metre, unless it starts at rest.
TEST(SceneCord, StartsAtRestIfItIsToldTo) {
  const auto moved = [](bool at_rest) {
    MapObject rope = thing(7, "cord", MapShape::polyline, {1.0, 8.0});
    rope.points = {{1.0, 8.0}, {4.0, 5.0}, {8.0, 8.0}};
    rope.properties.insert("columns", std::int64_t{41});
    rope.properties.insert("mass", 2.0);
    rope.properties.insert("pin_first", true);
    rope.properties.insert("pin_last", true);
    rope.properties.insert("at_rest", at_rest);
    Scene scene(map_of({rope}));
    const Vec2 start = scene.coupling().cord(0).positions()[10];
    double most = 0.0;
    for (int k = 0; k < 60; ++k) {
      scene.tick(1.0 / 60.0);
      most = std::max(most, length(scene.coupling().cord(0).positions()[10] - start));
    }
    return most;
  };
  EXPECT_GT(moved(false), 0.1);
  EXPECT_LT(moved(true), 1e-3);
}

TEST(SceneCord, StartsAtRestOnlyFromAPin) {
  MapObject rope = thing(7, "cord", MapShape::polyline, {1.0, 8.0});
  rope.points = {{1.0, 8.0}, {4.0, 5.0}};
  rope.properties.insert("columns", std::int64_t{41});
  rope.properties.insert("mass", 2.0);
  rope.properties.insert("at_rest", true);
  EXPECT_EQ(refusal(map_of({rope})),
            "test.tmj: object 7: pins are empty; accepted is a cord that hangs from one point or more");
}

/// The overlap cannot be removed. It once made ticks a thousand times as expensive, and unconverged.
TEST(SceneCord, HangsFromTheCornerOfARockThatItIsFixedIn) {
  MapObject bridge = cord(7);
  bridge.points = {{3.0, 5.0}, {5.0, 4.6}, {7.0, 5.0}};
  bridge.properties.insert("pin_last", true);
  bridge.properties.insert("radius", 0.15);
  bridge.properties.insert("friction", 0.6);
  MapObject rock = thing(1, "ground", MapShape::rectangle, {2.0, 4.0});
  rock.size = {2.0, 2.0};  // the bridge begins at its corner
  MapObject peg = thing(2, "circle", MapShape::ellipse, {7.0, 5.0});
  peg.size = {0.4, 0.4};
  peg.properties.insert("body", std::string("static"));
  Scene scene(map_of({rock, peg, bridge}));
  for (int k = 0; k < 300; ++k) scene.tick(1.0 / 60.0);
  EXPECT_EQ(scene.coupling().cord(0).island_total().unconverged, 0);
  EXPECT_LT(scene.coupling().cord(0).island_total().iterations, 300 * 30);
}

TEST(Replacing, ACordReleasesItsHoldersAndResetsItsCounts) {
  Scene scene(map_of({cord(7), block_on(8, 7)}));
  for (int k = 0; k < 10; ++k) scene.tick(1.0 / 60.0);
  ribbon::CordDef def;
  def.points = 5;
  def.length = 1.0;
  def.mass_per_length = 0.1;
  def.positions = {{1.0, 5.0}, {1.25, 5.0}, {1.5, 5.0}, {1.75, 5.0}, {2.0, 5.0}};
  scene.coupling().cord(0).replace(ribbon::Cord(def));
  EXPECT_FALSE(scene.coupling().body(*scene.bodies()[0].body).held_place());
  EXPECT_EQ(scene.coupling().size(), 1);
  EXPECT_EQ(scene.coupling().cord(0).positions().size(), 5U);
  EXPECT_EQ(scene.coupling().cord(0).island_total().stages, 0);
  for (int k = 0; k < 10; ++k) scene.tick(1.0 / 60.0);
  EXPECT_LT(scene.bodies()[0].body->GetLinearVelocity().y, -1.0F);
  EXPECT_THROW(scene.coupling().cord(1).replace(ribbon::Cord(def)), ribbon::CallError);
}

TEST(Replacing, RefusesACordOfTheThesis) {
  MapObject object = cord(7);
  object.properties.insert("solver", std::string("thesis"));
  object.properties.insert("spring_stiffness", 1000.0);
  Scene scene(map_of({object}));
  ribbon::CordDef def;
  EXPECT_THROW(scene.coupling().cord(0).replace(ribbon::Cord(def)), ribbon::CallError);
  EXPECT_EQ(scene.coupling().cord(0).solver(), ribbon::box2d::Solver::thesis);
}

TEST(NearestPlace, IsBetweenPointsOfADirectCordAndNotOnTheExcludedCord) {
  Scene scene(map_of({cord(7)}));
  const auto place = scene.coupling().nearest_place({5.3, 8.23}, 1.0);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->point, 7);
  EXPECT_NEAR(place->along, 0.7, 1e-9);
  EXPECT_NEAR(place->distance, 0.3, 1e-12);
  EXPECT_NEAR(scene.coupling().cord(place->cord).arc(place->point, place->along), 0.77, 1e-9);
  EXPECT_NEAR(scene.coupling().cord(place->cord).position(place->point, place->along).y, 8.23, 1e-9);
  EXPECT_FALSE(scene.coupling().nearest_place({5.3, 8.23}, 0.2));
  EXPECT_FALSE(scene.coupling().nearest_place({5.3, 8.23}, 1.0, std::array{ribbon::box2d::CordId{0}}));
}

TEST(MovingAHand, MovesTheBodyAndRefusesAGripThatDoesNotExist) {
  Scene scene(map_of({cord(7), block_on(8, 0)}));
  b2Body& body = *scene.bodies()[0].body;
  ribbon::box2d::GripDef grip;
  grip.arc = 2.0;
  grip.local_anchor = {0.0F, 0.7F};
  const ribbon::box2d::GripId id = scene.coupling().hold(body, grip);
  for (int k = 0; k < 60; ++k) {
    scene.coupling().grip(id).move_anchor({0.0F, 0.7F + 0.005F * static_cast<float>(k)});
    scene.tick(1.0 / 60.0);
  }
  EXPECT_NEAR(static_cast<double>(body.GetPosition().y), 7.0 - 0.7 - 0.295, 0.02);
  EXPECT_NEAR(scene.coupling().grip(id).state().place.y, 7.0, 1e-3);
  EXPECT_THROW(scene.coupling().grip(id + 1).move_anchor(b2Vec2_zero), ribbon::CallError);
}

}  // namespace
}  // namespace engine
