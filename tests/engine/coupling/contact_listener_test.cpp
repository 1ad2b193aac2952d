#include "ribbon/box2d/contact_listener.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/engine/coupling/grip_world.h"

namespace engine {
namespace {

using ribbon::box2d::ContactListener;
using ribbon::box2d::CordId;
using ribbon::box2d::Surface;

/// A world with an edge from (−5, 0) to (5, 0), turned by an angle.
struct EdgeWorld : GripWorld {
  explicit EdgeWorld(float angle = 0.0F) {
    b2BodyDef def;
    def.angle = angle;
    b2EdgeShape edge;
    edge.SetTwoSided({-5.0F, 0.0F}, {5.0F, 0.0F});
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = 0.8F;
    platform = world.CreateBody(&def)->CreateFixture(&fixture);
  }
  CordId add_rope(double y, Vec2 velocity = {}) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.radius = 0.03;
    def.friction = 0.8;
    def.positions = test_support::equally_spaced(def.points, {-0.5, y}, {0.1, 0.0});
    Cord cord(def);
    for (int p = 0; p < cord.size(); ++p) cord.set_velocity(p, velocity);
    return coupling.add(std::move(cord));
  }
  double lowest(CordId cord) const {
    const auto x = coupling.cord(cord).positions();
    return std::min_element(x.begin(), x.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; })->y;
  }

  b2Fixture* platform;
};

/// Lets cords through from below.
struct OneWay : ContactListener {
  explicit OneWay(const EdgeWorld& of_scene) : scene(of_scene) {}
  bool pre_solve(CordId cord, const b2Fixture& fixture, Surface& /*surface*/) override {
    return &fixture != scene.platform || scene.lowest(cord) > 0.0;
  }
  const EdgeWorld& scene;
};

TEST(ContactListener, MakesAOneWayPlatform) {
  EdgeWorld scene;
  OneWay listener(scene);
  scene.coupling.listen(&listener);
  const CordId rope = scene.add_rope(-1.0, {0.0, 6.0});  // rises to 0.8 m
  double highest = -1.0;
  for (int k = 0; k < 180; ++k) {
    scene.tick();
    highest = std::max(highest, scene.lowest(rope));
  }
  EXPECT_GT(highest, 0.6) << "it passed from below";
  EXPECT_NEAR(scene.lowest(rope), 0.03 + static_cast<double>(b2_polygonRadius), 5e-3) << "and lies on the platform";
  scene.coupling.listen(nullptr);
  const CordId other = scene.add_rope(-1.0, {0.0, 6.0});
  scene.tick(60);
  EXPECT_LT(scene.lowest(other), 0.0) << "without the listener it is stopped";
}

/// Chooses by cord.
struct ByCord : ContactListener {
  bool pre_solve(CordId cord, const b2Fixture& /*fixture*/, Surface& surface) override {
    calls.push_back(cord);
    surface.friction = friction;
    return cord != passes;
  }
  CordId passes = -1;
  double friction = 0.8;
  std::vector<CordId> calls;
};

TEST(ContactListener, IsAskedOnceATickByCordAndDecidesForEach) {
  EdgeWorld scene;
  ByCord listener;
  scene.coupling.listen(&listener);
  const CordId stays = scene.add_rope(0.1);
  listener.passes = scene.add_rope(0.1);
  scene.tick();
  EXPECT_EQ(listener.calls, (std::vector<CordId>{stays, listener.passes}));
  scene.tick(30);
  EXPECT_GT(scene.lowest(stays), 0.0);
  EXPECT_LT(scene.lowest(listener.passes), -0.5);
  EXPECT_TRUE(scene.coupling.cord(listener.passes).touching().empty());
}

/// What sleeps on a platform falls when the listener lets it through.
TEST(ContactListener, WakesACordThatItLetsThrough) {
  EdgeWorld scene;
  ByCord listener;
  scene.coupling.listen(&listener);
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.radius = 0.03;
  def.friction = 0.8;
  def.allow_sleep = true;
  def.positions = test_support::equally_spaced(def.points, {-0.5, 0.05}, {0.1, 0.0});
  const CordId rope = scene.coupling.add(Cord(def));
  scene.tick(200);
  ASSERT_TRUE(scene.coupling.cord(rope).direct().is_asleep());
  listener.passes = rope;
  scene.tick(30);
  EXPECT_LT(scene.lowest(rope), -0.5);
}

TEST(ContactListener, ChangesTheFriction) {
  for (const double friction : {0.8, 0.0}) {
    EdgeWorld scene(0.3F);
    ByCord listener;
    listener.friction = friction;
    scene.coupling.listen(&listener);
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.radius = 0.03;
    def.friction = 0.8;
    const Vec2 along{std::cos(0.3), std::sin(0.3)};
    def.positions = test_support::equally_spaced(
        def.points, (0.03 + static_cast<double>(b2_polygonRadius)) * perp(along), 0.1 * along);
    const CordId rope = scene.coupling.add(Cord(def));
    scene.tick(60);
    const double slid = dot(def.positions[5] - scene.coupling.cord(rope).positions()[5], along);
    if (friction > 0.0) {
      EXPECT_NEAR(slid, 0.0, 2e-3);
    } else {
      EXPECT_NEAR(slid, 0.5 * g * std::sin(0.3), 0.05);
    }
  }
}

}  // namespace
}  // namespace engine
