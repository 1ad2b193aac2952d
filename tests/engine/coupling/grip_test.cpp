#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <limits>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/grip_table.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/points.h"

// Grips at any place of a cord of the direct solver: hold, climb, slip.

namespace engine {
namespace {

/// Between two points, and off the body's centre: the anchor stays on the cord, and the pull is the weight.
TEST(Grip, HoldsBetweenPointsWithTheBodysWeight) {
  for (const double mass : {0.1, 70.0, 1000.0}) {
    GripWorld scene;
    scene.coupling.add(Cord(hanging()));
    b2Body* body = scene.add_body({0.0, -6.5}, mass);
    const ribbon::box2d::GripId grip =
        scene.coupling.hold(*body, {.cord = 0, .arc = 6.37, .local_anchor = {0.0F, 0.13F}});
    scene.tick(600);
    ASSERT_TRUE(scene.coupling.grip(grip).is_valid());
    const ribbon::box2d::GripState state = scene.coupling.grip(grip).state();
    EXPECT_NEAR(state.pull.y, g * static_cast<double>(body->GetMass()), 1e-3 * g * mass);
    EXPECT_NEAR(state.pull.x, 0.0, 1e-3 * g * mass);
    EXPECT_NEAR(state.arc, 6.37, 1e-9);
    EXPECT_NEAR(length(ribbon::box2d::to_double(body->GetWorldPoint({0.0F, 0.13F})) - scene.place(0, 6.37)), 0.0, 1e-5);
  }
}

/// A bar that hangs by its ends from two cords stays level; the sum of the two pulls is its weight. That needs a
/// coupled solve of both cords.
TEST(Grip, OneBodyHangsFromTwoCordsAndFromTwoPlacesOfOne) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging(-0.5)));
  scene.coupling.add(Cord(hanging(0.5)));
  b2Body* bar = scene.add_body({0.0, -7.0}, 40.0);
  const ribbon::box2d::GripId left = scene.coupling.hold(*bar, {.cord = 0, .arc = 7.0, .local_anchor = {-0.5F, 0.0F}});
  const ribbon::box2d::GripId right = scene.coupling.hold(*bar, {.cord = 1, .arc = 7.0, .local_anchor = {0.5F, 0.0F}});
  scene.tick(300);
  const double weight = g * static_cast<double>(bar->GetMass());
  EXPECT_NEAR(scene.coupling.grip(left).state().pull.y, 0.5 * weight, 1e-3 * weight);
  EXPECT_NEAR(scene.coupling.grip(right).state().pull.y, 0.5 * weight, 1e-3 * weight);
  EXPECT_NEAR(bar->GetPosition().y, -7.0, 1e-4);
  EXPECT_NEAR(bar->GetAngle(), 0.0, 1e-4);

  const ribbon::box2d::GripId above = scene.coupling.hold(*bar, {.cord = 0, .arc = 6.9, .local_anchor = {-0.5F, 0.1F}});
  scene.tick(60);
  EXPECT_NEAR(scene.coupling.grip(left).state().pull.y + scene.coupling.grip(above).state().pull.y +
                  scene.coupling.grip(right).state().pull.y,
              weight, 1e-3 * weight);
  EXPECT_NEAR(bar->GetPosition().y, -7.0, 1e-3);
}

/// The arc length changes under load at the requested speed, then stays constant.
TEST(Grip, ClimbsUnderLoad) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -8.0}, 70.0);
  const ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 8.0});
  scene.tick(10);
  scene.coupling.grip(grip).climb(3.3, 1.5);
  for (int k = 0; k < 180; ++k) {
    scene.tick();
    EXPECT_NEAR(body->GetPosition().y, -8.0 + 1.5 * dt * (k + 1), 0.02);
  }
  scene.tick(120);
  EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 3.3, 1e-9);
  EXPECT_NEAR(body->GetPosition().y, -3.3, 1e-3);
  EXPECT_NEAR(length(scene.coupling.body(*body).velocity()), 0.0, 1e-2);
}

/// A bar that hangs from two ropes that cannot push is thrown up; it rises as without ropes.
TEST(Grip, OnATensionOnlyCordDoesNotStopARisingBody) {
  GripWorld scene;
  for (const double x : {-0.5, 0.5}) {
    CordDef def = hanging(x);
    def.mass_per_length = 0.01;
    def.tension_only = true;
    scene.coupling.add(Cord(def));
  }
  b2Body* bar = scene.add_body({0.0, -10.0}, 40.0);
  scene.coupling.hold(*bar, {.cord = 0, .arc = 10.0, .local_anchor = {-0.5F, 0.0F}});
  scene.coupling.hold(*bar, {.cord = 1, .arc = 10.0, .local_anchor = {0.5F, 0.0F}});
  scene.tick(10);
  bar->SetLinearVelocity({0.0F, 3.0F});
  scene.tick(18);
  const double half_a_tick = 0.5 * g * dt;  // in the tick of the throw the cords begin taut and end slack
  EXPECT_NEAR(bar->GetLinearVelocity().y, 3.0 - g * 0.3, 1.1 * half_a_tick);
  EXPECT_NEAR(bar->GetPosition().y, -10.0 + 3.0 * 0.3 - 0.5 * g * 0.3 * 0.3, 0.05);
  EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
}

/// A body changes from one cord to the next in a swing: neither position nor velocity jumps.
TEST(Grip, GoesFromOneCordToAnotherWithoutAJolt) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  scene.coupling.add(Cord(hanging(1.0)));
  b2Body* body = scene.add_body({0.0, -9.0}, 70.0);
  ribbon::box2d::GripId grip = scene.coupling.hold(*body, {.cord = 0, .arc = 9.0});
  scene.tick();
  body->ApplyLinearImpulseToCenter({static_cast<float>(70.0 * 2.0), 0.0F}, true);
  bool changed = false;
  Vec2 position = ribbon::box2d::to_double(body->GetPosition());
  Vec2 velocity = scene.coupling.body(*body).velocity();
  for (int k = 0; k < 60; ++k) {
    if (!changed && position.x > 0.9) {
      // The nearest place of the other cord.
      const Vec2 nearest = scene.place(1, -position.y);
      ASSERT_LT(length(nearest - position), 0.2);
      EXPECT_TRUE(scene.coupling.grip(grip).release());
      grip = scene.coupling.hold(*body, {.cord = 1, .arc = -position.y});
      changed = true;
    }
    scene.tick();
    const Vec2 now = ribbon::box2d::to_double(body->GetPosition());
    const Vec2 next = scene.coupling.body(*body).velocity();
    if (k > 1) {
      EXPECT_LT(length(next - velocity), 0.6) << k;  // 2 g in a tick is 0.3 m/s
    }
    EXPECT_LT(length(now - position), 0.06) << k;
    position = now;
    velocity = next;
  }
  EXPECT_TRUE(changed);
  EXPECT_EQ(scene.coupling.grip(grip).state().cord, 1);
}

TEST(Grip, AKinematicBodyCarriesTheCordAtAnyPlace) {
  GripWorld scene;
  CordDef def = hanging();
  def.pins = {};
  scene.coupling.add(Cord(def));
  b2Body* hand = scene.add_body({0.0, -1.1}, 0.0, b2_kinematicBody);
  scene.coupling.hold(*hand, {.cord = 0, .arc = 1.1});
  hand->SetLinearVelocity({0.5F, 0.0F});
  for (int k = 0; k < 120; ++k) {
    scene.tick();
    EXPECT_NEAR(length(scene.place(0, 1.1) - ribbon::box2d::to_double(hand->GetPosition())), 0.0, 1e-4);
  }
}

/// A static or kinematic holder does not soften the contacts of its cord.
TEST(Grip, AStaticOrKinematicBodyHoldsACordWithContacts) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    GripWorld scene;
    scene.coupling.add(Cord(taut()));
    b2Body* hand = scene.add_body({1.03, 0.0}, 0.0, type);
    const ribbon::box2d::GripId grip = scene.coupling.hold(*hand, {.cord = 0, .arc = 1.03});
    b2Body* ball = scene.add_body({0.5, 0.25}, 1.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
    int touched = 0;
    for (int k = 0; k < 60; ++k) {
      scene.tick();
      ASSERT_LT(scene.coupling.cord(0).island_report().iterations, 1000) << k;
      touched += scene.coupling.cord(0).touching().empty() ? 0 : 1;
    }
    EXPECT_GT(touched, 30);
    EXPECT_EQ(scene.coupling.cord(0).island_total().unconverged, 0);
    EXPECT_NEAR(scene.coupling.grip(grip).state().arc, 1.03, 1e-9);
    EXPECT_NEAR(length(scene.place(0, 1.03) - ribbon::box2d::to_double(hand->GetPosition())), 0.0, 1e-4);
    EXPECT_GT(ball->GetPosition().y, 0.0F) << "it is carried";
  }
}

/// The pull on a static body is the weight, and on a kinematic one also what accelerates the cord.
TEST(Grip, PullsAStaticOrKinematicBodyWithTheCordsWeight) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    for (const double arc : {0.0, 0.1}) {
      GripWorld scene;
      CordDef def = hanging();
      def.pins = {};
      def.drag = 20.0;
      scene.coupling.add(Cord(def));
      b2Body* hand = scene.add_body({0.0, -arc}, 0.0, type);
      const ribbon::box2d::GripId grip = scene.coupling.hold(*hand, {.cord = 0, .arc = arc});
      b2Body* load = scene.add_body({0.0, -10.0}, 3.0);
      scene.coupling.hold(*load, {.cord = 0, .arc = 10.0});
      scene.tick(600);
      const double weight = (3.0 + def.length * def.mass_per_length) * g;
      const Vec2 pull = scene.coupling.grip(grip).state().pull;
      EXPECT_NEAR(pull.y, -weight, 1e-3 * weight) << type << ", arc " << arc;
      EXPECT_NEAR(pull.x, 0.0, 1e-3 * weight) << type << ", arc " << arc;
    }
  }
}

TEST(Grip, OfAStaticBodySharesThePullWithOthersAtItsPoint) {
  GripWorld scene;
  CordDef def = hanging();
  def.pins = {};
  def.drag = 20.0;
  scene.coupling.add(Cord(def));
  const auto hold = [&] { return scene.coupling.hold(*scene.add_body({}, 0.0, b2_staticBody), {.cord = 0}); };
  const ribbon::box2d::GripId first = hold();
  const ribbon::box2d::GripId second = hold();
  scene.tick(600);
  const double weight = def.length * def.mass_per_length * g;
  EXPECT_NEAR(scene.coupling.grip(first).state().pull.y, -0.5 * weight, 1e-3 * weight);
  scene.coupling.grip(second).release();
  scene.tick(60);
  EXPECT_NEAR(scene.coupling.grip(first).state().pull.y, -weight, 1e-3 * weight);
}

TEST(Grip, OfAStaticOrKinematicBodyIsReleasedAboveItsStrength) {
  for (const b2BodyType type : {b2_staticBody, b2_kinematicBody}) {
    for (const double arc : {0.0, 0.1}) {
      for (const double strength : {30.0, 60.0}) {  // N; it holds 4 kg
        GripWorld scene;
        CordDef def = hanging();
        def.pins = {};
        def.drag = 20.0;
        def.points = 101;
        def.positions = test_support::equally_spaced(def.points, {}, {0.0, -0.1});
        scene.coupling.add(Cord(def));
        b2Body* hook = scene.add_body({0.0, -arc}, 0.0, type);
        const ribbon::box2d::GripId grip =
            scene.coupling.hold(*hook, {.cord = 0, .arc = arc, .strength = strength, .lets_go = true});
        scene.coupling.hold(*scene.add_body({0.0, -10.0}, 3.0), {.cord = 0, .arc = 10.0});
        scene.tick(60);
        EXPECT_EQ(scene.coupling.grip(grip).is_valid(), strength > 4.0 * g) << type << ", arc " << arc;
      }
    }
  }
}

/// If only static grips hold a cord, a body that hits the cord transfers its momentum to them, as to pins.
TEST(Grip, AStaticBodyTakesTheMomentumOfWhatHitsTheCord) {
  const auto hit = [](bool pinned) {
    GripWorld scene;
    scene.world.SetGravity({0.0F, 0.0F});
    CordDef def;
    def.points = 21;
    def.length = 2.0;
    if (pinned) def.pins = {0, 20};
    scene.coupling.add(Cord(def));
    if (!pinned) {
      scene.coupling.hold(*scene.add_body({0.01, 0.0}, 0.0, b2_staticBody), {.cord = 0, .arc = 0.01});
      scene.coupling.hold(*scene.add_body({1.99, 0.0}, 0.0, b2_staticBody), {.cord = 0, .arc = 1.99});
    }
    b2Body* ball = scene.add_body({1.0, 0.3}, 2.0);
    ball->GetFixtureList()->SetFilterData(b2Filter());
    ball->SetLinearVelocity({0.0F, -3.0F});
    scene.tick(10);
    return scene.coupling.body(*ball).velocity().y;
  };
  EXPECT_GT(hit(true), -1.0) << "stopped, or thrown back";
  EXPECT_NEAR(hit(false), hit(true), 0.2);
}

TEST(Grip, ReelsAHangingBodyIn) {
  GripWorld scene;
  scene.coupling.add(Cord(hanging()));
  b2Body* body = scene.add_body({0.0, -10.0}, 70.0);
  scene.coupling.hold(*body, {.cord = 0, .arc = 10.0});
  scene.tick(5);
  scene.coupling.cord(0).direct().reel(0, 50, 6.0, 2.0);
  scene.tick(180);
  EXPECT_NEAR(body->GetPosition().y, -6.0, 0.01);
}

/// Any slip distance, also one of a failed solve, gives a place on the cord.
TEST(Grip, IsMovedToAPlaceOfItsCord) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr int columns = 51;
  constexpr int rows = 2;
  const auto moved = [](double by) {
    ribbon::box2d::GripMemory grip;
    grip.point = 2 * 7 + 1;
    grip.along = 0.25;
    ribbon::box2d::set_column(grip, 7.25 + by, columns, rows);
    EXPECT_EQ(grip.point % rows, 1);
    EXPECT_GE(grip.along, 0.0);
    EXPECT_LT(grip.along, 1.0);
    const int column = grip.point / rows;
    return column + grip.along;
  };
  EXPECT_EQ(moved(3.5), 10.75);
  EXPECT_EQ(moved(-0.25), 7.0);
  for (const double far : {50.0, 1e10, 1e300, infinity}) {
    EXPECT_EQ(moved(far), 50.0) << far;
    EXPECT_EQ(moved(-far), 0.0) << far;
  }
  EXPECT_EQ(moved(std::numeric_limits<double>::quiet_NaN()), 7.25) << "where it was";
}

/// A player is thrown up and falls into a rope that a crane carries along: the jerk may not throw it back faster than
/// it came, at rest or not, held at a point or between points.
TEST(Grip, OfACraneGivesNoEnergyToAJerk) {
  for (const float velocity : {0.0F, 0.01F, 2.0F, -8.0F}) {
    for (const double arc : {0.0, 0.07}) {
      GripWorld scene;
      CordDef def = hanging();
      def.pins.clear();
      def.drag = 0.8;
      const ribbon::box2d::CordId rope = scene.coupling.add(Cord(def));
      b2Body* crane = scene.add_body({0.0, 0.0}, 1.0, b2_kinematicBody);
      b2Body* player = scene.add_body({0.0, -10.0}, 70.0);
      scene.coupling.hold(*crane, {.cord = rope, .arc = arc, .local_anchor = {0.0F, static_cast<float>(-arc)}});
      scene.coupling.hold(*player, {.cord = rope, .arc = 10.0});
      crane->SetLinearVelocity({velocity, 0.0F});
      player->SetLinearVelocity({velocity, 6.0F});
      for (int p = 0; p < def.points; ++p) {
        scene.coupling.cord(rope).direct().set_velocity(p, {static_cast<double>(velocity), p == 50 ? 6.0 : 0.0});
      }
      double fastest = 0.0;
      for (int k = 0; k < 300; ++k) {
        scene.tick();
        if (k > 60) fastest = std::max(fastest, scene.coupling.body(*player).velocity().y);
      }
      EXPECT_LE(fastest, 3.0) << velocity << " m/s, held at " << arc << " m";
    }
  }
}

}  // namespace
}  // namespace engine
