#include "ribbon/box2d/debug_draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "ribbon/smooth_line.h"
#include "tests/engine/coupling/handle_cords.h"
#include "tests/support/allocations.h"
#include "tests/support/freed_body.h"

namespace ribbon::box2d {
namespace {

/// Counts and keeps what is drawn. It has memory for a few thousand shapes.
struct Recorder : b2Draw {
  struct Segment {
    b2Vec2 a, b;
    b2Color color;
  };
  struct Point {
    b2Vec2 at;
    b2Color color;
  };

  explicit Recorder(uint32 flags) {
    SetFlags(flags);
    segments.reserve(4000);
    points.reserve(4000);
    polygons.reserve(400);
  }
  // NOLINTBEGIN(readability-identifier-naming): named by Box2D
  void DrawPolygon(const b2Vec2* vertices, int32 count, const b2Color& /*color*/) override {
    polygons.insert(polygons.end(), vertices, vertices + count);
  }
  void DrawSolidPolygon(const b2Vec2* /*vertices*/, int32 /*count*/, const b2Color& /*color*/) override {}
  void DrawCircle(const b2Vec2& center, float radius, const b2Color& /*color*/) override {
    circles.emplace_back(center, radius);
  }
  void DrawSolidCircle(const b2Vec2& /*center*/, float /*radius*/, const b2Vec2& /*axis*/,
                       const b2Color& /*color*/) override {}
  void DrawSegment(const b2Vec2& a, const b2Vec2& b, const b2Color& color) override {
    segments.push_back({a, b, color});
  }
  void DrawTransform(const b2Transform& /*transform*/) override {}
  void DrawPoint(const b2Vec2& at, float /*size*/, const b2Color& color) override { points.push_back({at, color}); }
  // NOLINTEND(readability-identifier-naming)

  std::vector<Segment> segments;
  std::vector<Point> points;
  std::vector<b2Vec2> polygons;
  std::vector<std::pair<b2Vec2, float>> circles;
};

Recorder drawn(const Coupling& coupling, uint32 flags) {
  Recorder recorder(flags);
  debug_draw(coupling, recorder);
  return recorder;
}

bool is(const b2Color& a, const b2Color& b) { return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a; }

// Of b2World::DebugDraw.
const b2Color awake(0.9F, 0.7F, 0.7F);
const b2Color asleep(0.6F, 0.6F, 0.6F);
const b2Color disabled(0.5F, 0.5F, 0.3F);
const b2Color static_color(0.5F, 0.9F, 0.5F);
const b2Color kinematic(0.5F, 0.5F, 0.9F);

TEST(DebugDraw, ARopeIsItsLinksAndPoints) {
  Coupling coupling;
  const CordId id = coupling.add(rope(3.0));
  coupling.cord(id).drag(7, {0.7, 4.0});
  const Recorder recorder = drawn(coupling, b2Draw::e_shapeBit);
  const auto x = coupling.cord(id).positions();
  ASSERT_EQ(recorder.segments.size(), 20U);
  ASSERT_EQ(recorder.points.size(), 21U);
  for (std::size_t i = 0; i < 21; ++i) {
    EXPECT_EQ(recorder.points[i].at, to_float(x[i]));
    EXPECT_TRUE(is(recorder.points[i].color, i == 0 || i == 20 ? static_color : i == 7 ? kinematic : awake)) << i;
    if (i == 20) continue;
    EXPECT_EQ(recorder.segments[i].a, to_float(x[i]));
    EXPECT_EQ(recorder.segments[i].b, to_float(x[i + 1]));
    EXPECT_TRUE(is(recorder.segments[i].color, awake));
  }
  EXPECT_TRUE(recorder.polygons.empty());
}

/// Each link of the outline is drawn once, and no other.
TEST(DebugDraw, ARibbonIsItsOutline) {
  Coupling coupling;
  CordDef def;
  def.points = 6;
  def.rows = 3;
  def.length = 1.0;
  def.width = 0.4;
  def.stretch_stiffness = 1e3;
  def.bending_stiffness = 1.0;
  coupling.add(Cord(def));
  const Recorder recorder = drawn(coupling, b2Draw::e_shapeBit);
  EXPECT_EQ(recorder.points.size(), 18U);
  ASSERT_EQ(recorder.segments.size(), 2U * 5U + 2U * 2U);
  std::vector<std::pair<float, float>> middles;
  for (const auto& [a, b, color] : recorder.segments) {
    const bool is_level = a.y == b.y && (a.y == 0.0F || a.y == 0.4F);
    const bool is_upright = a.x == b.x && (a.x == 0.0F || a.x == 1.0F);
    EXPECT_TRUE(is_level || is_upright);
    EXPECT_NEAR((b - a).Length(), 0.2F, 1e-6F) << "one link";
    middles.emplace_back(0.5F * (a.x + b.x), 0.5F * (a.y + b.y));
  }
  std::sort(middles.begin(), middles.end());
  EXPECT_EQ(std::adjacent_find(middles.begin(), middles.end()), middles.end());
}

TEST(DebugDraw, TheThesissCordIsItsOutline) {
  Coupling coupling;
  const CordId id = coupling.add(curtain());
  const CordShape shape = coupling.cord(id).shape();
  const Recorder recorder = drawn(coupling, b2Draw::e_shapeBit);
  EXPECT_EQ(recorder.segments.size(), static_cast<std::size_t>(2 * (shape.columns - 1) + 2 * (shape.rows - 1)));
  EXPECT_TRUE(is(recorder.points[0].color, static_color));
  EXPECT_TRUE(is(recorder.points[2].color, awake));
}

TEST(DebugDraw, SleepingAndDisabledCordsHaveOtherColours) {
  RopeWorld scene;
  CordDef def;
  def.points = 11;
  def.pins = {0};
  def.positions = test_support::equally_spaced(11, {}, {0.0, -1.0});
  def.allow_sleep = true;
  const CordId id = scene.coupling.add(Cord(def));
  const auto color = [&] { return drawn(scene.coupling, b2Draw::e_shapeBit).segments.front().color; };
  EXPECT_TRUE(is(color(), awake));
  scene.tick(60);
  ASSERT_TRUE(scene.coupling.cord(id).direct().is_asleep());
  EXPECT_TRUE(is(color(), asleep));
  scene.coupling.cord(id).set_enabled(false);
  EXPECT_TRUE(is(color(), disabled));
}

TEST(DebugDraw, AGripReachesFromTheBodyToTheCord) {
  RopeWorld scene;
  const CordId id = scene.coupling.add(rope());
  b2Body& ball = scene.ball({0.55, -0.5});
  GripDef def;
  def.cord = id;
  def.arc = 0.55;
  def.local_anchor.Set(0.0F, 0.25F);
  scene.coupling.hold(ball, def);
  const Recorder recorder = drawn(scene.coupling, b2Draw::e_jointBit);
  ASSERT_EQ(recorder.segments.size(), 2U);
  EXPECT_EQ(recorder.segments[0].a, ball.GetPosition());
  EXPECT_EQ(recorder.segments[0].b, ball.GetWorldPoint({0.0F, 0.25F}));
  EXPECT_EQ(recorder.segments[1].a, recorder.segments[0].b);
  EXPECT_NEAR((recorder.segments[1].b - b2Vec2(0.55F, 0.0F)).Length(), 0.0F, 1e-6F);
  ASSERT_EQ(recorder.points.size(), 1U);
  EXPECT_EQ(recorder.points[0].at, recorder.segments[1].b);
}

/// A body may be destroyed before drawing, and its memory must not be read.
TEST(DebugDraw, LeavesOutGripsOfDestroyedBodies) {
  RopeWorld scene;
  const CordId id = scene.coupling.add(rope());
  b2Body& gone = scene.ball({0.5, 0.0});
  b2Body& stays = scene.ball({1.0, 0.0});
  scene.coupling.hold(id, 5, gone, {0.0F, 0.0F});
  scene.coupling.hold(id, 10, stays, {0.0F, 0.0F});
  scene.tick(3);
  scene.world.DestroyBody(&gone);
  const test_support::FreedBody watch(&gone);
  const Recorder recorder = drawn(scene.coupling, b2Draw::e_jointBit);
  ASSERT_EQ(recorder.segments.size(), 2U);
  EXPECT_EQ(recorder.segments[0].a, stays.GetPosition());
}

TEST(DebugDraw, AWheelHasASpoke) {
  RopeWorld scene;
  PulleyDef wheel{.center = {0.0, 1.0}, .radius = 0.25, .counterclockwise = false};
  const ReevedCord reeved = reeve({-0.25, -1.0}, {&wheel, 1}, {0.25, -1.0}, 41);
  CordDef def;
  def.points = 41;
  def.length = reeved.length;
  def.positions = reeved.positions;
  b2Body& beam = scene.ball({0.0, 2.0});
  scene.coupling.add_pulley(scene.coupling.add(Cord(def)), beam, reeved.pulleys[0]);
  const Recorder recorder = drawn(scene.coupling, b2Draw::e_jointBit);
  ASSERT_EQ(recorder.circles.size(), 1U);
  EXPECT_LT((recorder.circles[0].first - b2Vec2(0.0F, 1.0F)).Length(), 1e-6F);
  EXPECT_EQ(recorder.circles[0].second, 0.25F);
  ASSERT_EQ(recorder.segments.size(), 1U);
  EXPECT_NEAR((recorder.segments[0].b - recorder.segments[0].a).Length(), 0.25F, 1e-6F);
}

TEST(DebugDraw, ContactsHaveNormals) {
  RopeWorld scene;
  const CordId id = scene.coupling.add(rope());
  scene.ball({1.0, 0.3});
  scene.tick(40);
  const auto touches = scene.coupling.cord(id).direct().touches();
  ASSERT_FALSE(touches.empty());
  Recorder recorder = drawn(scene.coupling, b2Draw::e_pairBit);
  ASSERT_EQ(recorder.points.size(), touches.size());
  ASSERT_EQ(recorder.segments.size(), touches.size());
  EXPECT_EQ(recorder.points[0].at, to_float(touches[0].point));
  EXPECT_EQ(recorder.segments[0].a, to_float(touches[0].point));
  EXPECT_GT(recorder.segments[0].b.y - recorder.segments[0].a.y, 0.25F) << "up, to the ball";
  scene.coupling.cord(id).set_enabled(false);
  recorder = drawn(scene.coupling, b2Draw::e_pairBit);
  EXPECT_TRUE(recorder.points.empty());
}

TEST(DebugDraw, BoxesAreThoseOfTheLastGather) {
  RopeWorld scene;
  const CordId id = scene.coupling.add(rope());
  EXPECT_TRUE(drawn(scene.coupling, b2Draw::e_aabbBit).polygons.empty()) << "nothing was gathered";
  scene.tick();
  const Recorder recorder = drawn(scene.coupling, b2Draw::e_aabbBit);
  const Box box = scene.coupling.cord(id).swept_aabb();
  ASSERT_EQ(recorder.polygons.size(), 4U);
  EXPECT_EQ(recorder.polygons[0], to_float(box.low));
  EXPECT_EQ(recorder.polygons[2], to_float(box.high));
  EXPECT_GT(b2Cross(recorder.polygons[1] - recorder.polygons[0], recorder.polygons[2] - recorder.polygons[1]), 0.0F)
      << "counter-clockwise";
  EXPECT_TRUE(recorder.segments.empty());
  scene.coupling.cord(id).set_enabled(false);
  EXPECT_TRUE(drawn(scene.coupling, b2Draw::e_aabbBit).polygons.empty());
}

TEST(DebugDraw, WithoutFlagsNothingIsDrawn) {
  RopeWorld scene;
  const CordId id = scene.coupling.add(rope());
  scene.coupling.hold(id, 5, scene.ball({0.5, 0.0}), {0.0F, 0.0F});
  scene.ball({1.0, 0.15});
  scene.tick(10);
  for (const uint32 flags : {0U, static_cast<unsigned>(b2Draw::e_centerOfMassBit)}) {
    const Recorder recorder = drawn(scene.coupling, flags);
    EXPECT_TRUE(recorder.segments.empty() && recorder.points.empty() && recorder.polygons.empty());
  }
}

/// Two couplings in the same scene, of which one is drawn after each part of each tick.
TEST(DebugDraw, ChangesAndAllocatesNothing) {
  RopeWorld seen;
  RopeWorld unseen;
  for (RopeWorld* scene : {&seen, &unseen}) {
    const CordId id = scene->coupling.add(rope());
    scene->coupling.add(curtain());
    scene->coupling.hold(id, 5, scene->ball({0.5, 0.0}), {0.0F, 0.0F});
    scene->ball({1.0, 0.3});
  }
  Recorder recorder(0xFFU);
  long allocated = 0;
  const auto draw = [&] {
    recorder.segments.clear();
    recorder.points.clear();
    recorder.polygons.clear();
    const test_support::AllocationCount allocations;
    debug_draw(seen.coupling, recorder);
    allocated += allocations.so_far();
  };
  for (int tick = 0; tick < 40; ++tick) {
    seen.coupling.gather(seen.world, RopeWorld::dt);
    draw();
    seen.coupling.step();
    draw();
    seen.coupling.apply();
    draw();
    seen.world.Step(static_cast<float>(RopeWorld::dt), 8, 3);
    draw();
    unseen.coupling.tick(unseen.world, RopeWorld::dt);
  }
  EXPECT_EQ(allocated, 0);
  EXPECT_FALSE(recorder.segments.empty());
  EXPECT_TRUE(seen.coupling.save(seen.world) == unseen.coupling.save(unseen.world));
}

/// Both solvers' cords are drawn smoothly by the same call.
TEST(CordGrid, HasThePositionsAndRestLengthsOfEitherSolver) {
  Coupling coupling;
  const CordId direct = coupling.add(rope());
  const CordId thesis = coupling.add(curtain());
  EXPECT_EQ(coupling.cord(direct).grid().columns(), 21);
  EXPECT_EQ(coupling.cord(direct).grid().rest_lengths[3], coupling.cord(direct).direct().rest_length(3));
  const PointGrid grid = coupling.cord(thesis).grid();
  EXPECT_EQ(grid.rows, coupling.cord(thesis).shape().rows);
  EXPECT_EQ(grid.columns(), coupling.cord(thesis).shape().columns);
  EXPECT_EQ(grid.rest_lengths[3], coupling.cord(thesis).thesis().def().spacing);
  std::vector<StripVertex> strip(smooth_strip_size(grid.columns(), 4));
  EXPECT_EQ(smooth_strip(grid, 0.0, 4, strip).back().arc, strip[strip.size() - 2].arc);
}

}  // namespace
}  // namespace ribbon::box2d
