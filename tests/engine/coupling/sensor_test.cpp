#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <tuple>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/thesis/thesis_cord.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/engine/coupling/sensor_world.h"
#include "tests/support/allocations.h"

// Sensors of Box2D: overlaps with cords that begin and end.

namespace engine {
namespace {

using ribbon::box2d::CordId;

TEST(Sensors, TellOnceThatARopeFallsIn) {
  std::vector<Vec2> ends;
  for (const bool with : {true, false}) {
    SensorWorld scene;
    Hears listener;
    scene.coupling.listen(&listener);
    const b2Fixture* const sensor = with ? scene.add_box({0.0, -1.0}, 0.3F) : nullptr;
    const CordId rope = scene.add_rope(0.0, 0.0);
    const std::vector<Seen> seen = scene.run(20);
    EXPECT_TRUE(seen.empty());
    // It falls 0.7 m in 22.7 ticks, and 1.3 m in 30.9.
    const std::vector<Seen> in = scene.run(7);
    const auto inside = scene.coupling.cord(rope).sensors();
    if (with) {
      EXPECT_EQ(in, (std::vector<Seen>{{rope, true, sensor}}));
      ASSERT_EQ(inside.size(), 1U);
      EXPECT_EQ(scene.coupling.fixture(inside[0]), sensor);
    }
    const std::vector<Seen> out = scene.run(20);
    if (with) {
      EXPECT_EQ(out, (std::vector<Seen>{{rope, false, sensor}}));
      EXPECT_EQ(listener.heard, (std::vector<Seen>{{rope, true, sensor}, {rope, false, sensor}}));
    } else {
      EXPECT_TRUE(in.empty() && out.empty() && inside.empty());
      EXPECT_EQ(listener.asked, 0) << "without sensors nothing is done";
    }
    EXPECT_TRUE(scene.coupling.cord(rope).sensors().empty());
    EXPECT_TRUE(scene.coupling.cord(rope).touching().empty());
    ends.push_back(scene.coupling.cord(rope).positions()[5]);
  }
  EXPECT_EQ(ends[0], ends[1]) << "it pushes nothing, to the last bit";
}

/// The tick in which a rope that comes at 1 m/s is seen, for each shape, tells how thick both are.
TEST(Sensors, HaveAnyShapeAndBody) {
  b2CircleShape circle;
  circle.m_radius = 0.5F;
  b2PolygonShape box;
  box.SetAsBox(0.5F, 0.5F);
  b2EdgeShape edge;
  edge.SetTwoSided({-0.5F, 0.5F}, {0.5F, 0.5F});
  const std::array<b2Vec2, 3> vertices{b2Vec2{-0.5F, 0.5F}, b2Vec2{0.0F, 0.5F}, b2Vec2{0.5F, 0.5F}};
  b2ChainShape chain;
  chain.CreateChain(vertices.data(), 3, {-1.0F, 0.5F}, {1.0F, 0.5F});
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody, b2_dynamicBody}) {
    for (const float density : {0.0F, 1.0F}) {
      for (const b2Shape* const shape : std::array<const b2Shape*, 4>{&circle, &box, &edge, &chain}) {
        SensorWorld scene;
        scene.density = density;
        scene.world.SetGravity({0.0F, 0.0F});
        const b2Fixture* const sensor = scene.add_sensor({100.0, 50.0}, *shape, type);
        const double thick = 0.5 + 0.02 + (shape == &circle ? 0.0 : static_cast<double>(b2_polygonRadius));
        const CordId rope = scene.add_rope(100.0, 50.0 + thick + 10.5 / 60.0, {0.0, -1.0});
        EXPECT_TRUE(scene.run(11).empty()) << shape->GetType();
        EXPECT_EQ(scene.run(1), (std::vector<Seen>{{rope, true, sensor}})) << shape->GetType();
      }
    }
  }
}

/// What passes within a tick is not seen, as between two fixtures of Box2D.
TEST(Sensors, LookWhereThingsAreOnceATick) {
  SensorWorld scene;
  scene.world.SetGravity({0.0F, 0.0F});
  scene.add_box({0.0, 0.0}, 0.05F);
  scene.add_rope(0.0, 1.0, {0.0, -60.0 * 0.66});
  EXPECT_TRUE(scene.run(10).empty());
}

TEST(Sensors, InsideARibbonCount) {
  SensorWorld scene;
  scene.world.SetGravity({0.0F, 0.0F});
  CordDef def;
  def.points = 5;
  def.rows = 3;
  def.length = 4.0;
  def.width = 2.0;
  def.stretch_stiffness = 1e4;
  def.bending_stiffness = 10.0;
  for (int p = 0; p < 15; ++p) {
    const int column = p / 3;
    def.positions.push_back({1.0 * column, 1.0 * (p % 3)});
  }
  const CordId ribbon = scene.coupling.add(Cord(def));
  const b2Fixture* const inside = scene.add_box({1.5, 0.5}, 0.1F);
  scene.add_box({4.5, 0.5}, 0.1F);
  EXPECT_EQ(scene.run(5), (std::vector<Seen>{{ribbon, true, inside}}));
}

TEST(Sensors, MeetCordsOfTheThesis) {
  SensorWorld scene;
  ribbon::ThesisDef def;
  const CordId cord = scene.coupling.add(ribbon::ThesisCord(def));
  const Vec2 middle = scene.coupling.cord(cord).positions()[scene.coupling.cord(cord).positions().size() / 2];
  const b2Fixture* const sensor = scene.add_box(middle, 0.2F);
  EXPECT_EQ(scene.run(1), (std::vector<Seen>{{cord, true, sensor}}));
}

/// A sensor that moves over a sleeping rope tells, and the rope goes on sleeping. So does the sensor's body.
TEST(Sensors, TellOfASleepingRopeAndDoNotWakeIt) {
  SensorWorld scene;
  const CordId rope = scene.add_rope(0.0, 0.0, {}, true);
  scene.run(200);
  ASSERT_TRUE(scene.coupling.cord(rope).direct().is_asleep());
  b2Fixture* const sensor = scene.add_box({0.0, 30.0}, 0.3F, b2_kinematicBody);
  b2Body* const body = sensor->GetBody();
  scene.run(10);
  const auto is_asleep = [&] { return scene.coupling.cord(rope).direct().is_asleep(); };
  body->SetTransform({0.0F, 0.1F}, 0.0F);
  body->SetAwake(false);
  EXPECT_EQ(scene.run(1), (std::vector<Seen>{{rope, true, sensor}}));
  EXPECT_TRUE(is_asleep());
  EXPECT_FALSE(body->IsAwake());
  EXPECT_TRUE(scene.run(30).empty());
  body->SetLinearVelocity({0.0F, 3.0F});
  EXPECT_EQ(scene.run(30), (std::vector<Seen>{{rope, false, sensor}}));
  EXPECT_TRUE(is_asleep());
  EXPECT_TRUE(scene.run(60).empty());
}

TEST(Sensors, AreFilteredAndRefused) {
  SensorWorld scene;
  Hears listener;
  scene.coupling.listen(&listener);
  b2Filter nothing;
  nothing.maskBits = 0;
  b2Fixture* const sensor = scene.add_box({0.0, 0.0}, 0.3F, b2_staticBody, nothing);
  const CordId rope = scene.add_rope(0.0, 0.0, {}, true);
  EXPECT_TRUE(scene.run(3).empty());
  EXPECT_EQ(listener.asked, 0);
  sensor->SetFilterData({});
  EXPECT_EQ(scene.run(3), (std::vector<Seen>{{rope, true, sensor}}));
  EXPECT_EQ(listener.asked, 3);
  listener.refused = rope;
  EXPECT_EQ(scene.run(3), (std::vector<Seen>{{rope, false, sensor}}));
  listener.refused = -1;
  EXPECT_EQ(scene.run(3), (std::vector<Seen>{{rope, true, sensor}}));
  sensor->SetFilterData(nothing);
  EXPECT_EQ(scene.run(3), (std::vector<Seen>{{rope, false, sensor}}));
}

/// Whatever ends an overlap is told once, with the fixture if it still exists.
TEST(Sensors, TellHoweverAnOverlapEnds) {
  struct Case {
    const char* what;
    bool fixture_is_gone;
    std::function<void(SensorWorld&, CordId, b2Fixture&)> end;
  };
  const std::vector<Case> cases{
      {"removed", false, [](SensorWorld& scene, CordId rope, b2Fixture&) { scene.coupling.remove(rope); }},
      {"disabled", false,
       [](SensorWorld& scene, CordId rope, b2Fixture&) { scene.coupling.cord(rope).set_enabled(false); }},
      {"replaced elsewhere", false,
       [](SensorWorld& scene, CordId rope, b2Fixture&) {
         CordDef def = scene.coupling.cord(rope).direct().def();
         for (Vec2& x : def.positions) x.y += 50.0;
         scene.coupling.cord(rope).replace(Cord(def));
       }},
      {"solid", false, [](SensorWorld&, CordId, b2Fixture& sensor) { sensor.SetSensor(false); }},
      {"far away", false,
       [](SensorWorld&, CordId, b2Fixture& sensor) {
         sensor.GetBody()->SetTransform({500.0F, 0.0F}, 0.0F);
       }},
      {"body disabled", false, [](SensorWorld&, CordId, b2Fixture& sensor) { sensor.GetBody()->SetEnabled(false); }},
      {"destroyed", true,
       [](SensorWorld& scene, CordId, b2Fixture& sensor) { scene.coupling.destroy(scene.world, *sensor.GetBody()); }},
      {"destroyed by Box2D", true,
       [](SensorWorld& scene, CordId, b2Fixture& sensor) { scene.world.DestroyBody(sensor.GetBody()); }},
      {"fixture destroyed", true,
       [](SensorWorld& scene, CordId, b2Fixture& sensor) {
         scene.coupling.forget(sensor);
         sensor.GetBody()->DestroyFixture(&sensor);
       }},
      {"removed and destroyed", true,
       [](SensorWorld& scene, CordId rope, b2Fixture& sensor) {
         scene.coupling.remove(rope);
         scene.coupling.destroy(scene.world, *sensor.GetBody());
       }},
  };
  for (const Case& of : cases) {
    SensorWorld scene;
    b2Fixture* const sensor = scene.add_box({0.0, 0.0}, 0.3F, b2_kinematicBody);
    scene.add_box({200.0, 0.0}, 0.3F);  // a newer body, by which that one is known
    const CordId rope = scene.add_rope(0.0, 0.0, {}, true);
    ASSERT_EQ(scene.run(2), (std::vector<Seen>{{rope, true, sensor}})) << of.what;
    of.end(scene, rope, *sensor);
    const std::vector<Seen> seen = scene.run(5);
    EXPECT_EQ(seen, (std::vector<Seen>{{rope, false, of.fixture_is_gone ? nullptr : sensor}})) << of.what;
  }
}

/// The whole cord leaves, and the piece that is there comes.
TEST(Sensors, FollowACut) {
  SensorWorld scene;
  const CordId rope = scene.add_rope(0.0, 0.0, {}, true);
  const b2Fixture* const sensor = scene.add_box({-0.4, 0.0}, 0.05F);
  scene.run(2);
  const auto cut = scene.coupling.cord(rope).cut(0.5);
  EXPECT_EQ(scene.run(3), (std::vector<Seen>{{rope, false, sensor}, {*cut.first, true, sensor}}));
}

/// By cord; of each the ends first, and both by number of the sensor.
TEST(Sensors, TellInADeterminedOrder) {
  SensorWorld scene;
  std::vector<b2Fixture*> sensors;
  for (int k = 0; k < 4; ++k) sensors.push_back(scene.add_box({0.0, 10.0 + k}, 0.3F, b2_kinematicBody));
  const CordId first = scene.add_rope(0.0, 0.0, {}, true);
  const CordId second = scene.add_rope(0.0, 0.1, {}, true);
  const auto place = [&](int k, float y) {
    sensors[static_cast<std::size_t>(k)]->GetBody()->SetTransform({0.0F, y}, 0.0F);
  };
  place(0, 0.0F);
  place(1, 0.0F);
  const std::vector<Seen> begun = scene.run(2);
  ASSERT_EQ(begun.size(), 4U);
  for (int k = 0; k < 4; ++k) place(k, k < 2 ? 10.0F : 0.0F);
  const std::vector<Seen> seen = scene.run(2);
  ASSERT_EQ(seen.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_EQ(std::get<0>(seen[k]), k < 4 ? first : second);
    EXPECT_EQ(std::get<1>(seen[k]), k % 4 >= 2);
  }
  for (const std::size_t k : {0U, 1U}) EXPECT_EQ(std::get<2>(seen[k]), std::get<2>(begun[k])) << "the order stays";
}

}  // namespace
}  // namespace engine
