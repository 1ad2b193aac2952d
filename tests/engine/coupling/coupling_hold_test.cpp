#include "ribbon/box2d/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "tests/engine/coupling/thesis_coupling.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"
#include "tests/support/thesis_scenes.h"

// Bodies that hold a cord of the thesis's solver.

namespace engine {
namespace {

using ribbon::ThesisCord;
using test_support::step_cords;

/// A cord that hangs from (0, 0) and a body of `mass` at its end, which holds the end's first point.
struct Hanging {
  b2World world{{0.0F, -9.81F}};
  ribbon::box2d::Coupling coupling;
  b2Body* body = nullptr;
  ribbon::box2d::CordId held = 0;
  ribbon::box2d::GripId grip = 0;

  /// With `others`, two cords are far away, one added before this cord and one after it.
  explicit Hanging(double mass, double drag = 0.5, bool others = false) {
    if (others) coupling.add(ThesisCord(pinned_at_both_ends({-50.0, 0.0})));
    ThesisDef def = cord_def();
    def.drag = drag;
    def.substeps = 16;
    def.positions = ribbon::lay_along(std::array{Vec2{0.0, 0.0}, Vec2{0.0, -1.0}}, def.w, def.h, def.spacing);
    def.pins = {0, 1};
    b2Filter nothing;
    nothing.maskBits = 0;
    held = coupling.add(ThesisCord(def), nothing);
    if (others) coupling.add(ThesisCord(pinned_at_both_ends({50.0, 0.0})));
    body = add_circle(world, end(), 0.1, b2_dynamicBody, mass / (std::numbers::pi * 0.01));
    grip = coupling.hold(held, 40, *body, {0.0F, 0.0F});
  }
  Vec2 end() const { return coupling.cord(held).thesis().positions()[40]; }
  void run(int ticks) {
    for (int k = 0; k < ticks; ++k) tick(coupling, world);
  }
};

TEST(CouplingHold, TheCordCarriesTheWeightOfTheBody) {
  Hanging hanging(1.0, 2.0);
  hanging.run(1800);
  EXPECT_NEAR(y_of(hanging.body), -4.0, 0.2);
  EXPECT_LT(static_cast<double>(hanging.body->GetLinearVelocity().Length()), 0.01);
  EXPECT_NEAR(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetPosition())), 0.0, 1e-3);
  // The impulse of one more tick balances gravity.
  const b2Vec2 before = hanging.body->GetLinearVelocity();
  step_cords(hanging.coupling, hanging.world, dt);
  const double gain = static_cast<double>(hanging.body->GetLinearVelocity().y - before.y);
  EXPECT_NEAR(gain / dt, 9.81, 0.1);
}

/// Swings a hanging body; returns its maximum excursions to the right, one per period.
std::vector<double> excursions(Hanging& hanging, int ticks) {
  std::vector<double> widest;
  double last_speed = 0.0;
  for (int k = 0; k < ticks; ++k) {
    hanging.run(1);
    const double speed = hanging.coupling.body(*hanging.body).velocity().x;
    if (last_speed > 0.0 && speed <= 0.0) widest.push_back(static_cast<double>(hanging.body->GetPosition().x));
    last_speed = speed;
  }
  return widest;
}

/// Other cords do not matter.
TEST(CouplingHold, SwingsLikeAPendulum) {
  Hanging alone(5.0, 0.0);
  Hanging hanging(5.0, 0.0, true);
  alone.run(300);
  hanging.run(300);
  EXPECT_EQ(hanging.body->GetPosition(), alone.body->GetPosition());
  hanging.body->SetLinearVelocity({4.0F, 0.0F});
  const std::vector<double> widest = excursions(hanging, 2400);
  ASSERT_GE(widest.size(), 9U);
  EXPECT_GT(widest[0], 1.8);
  EXPECT_LT(widest[0], 2.45);  // the excursion of a 4 m pendulum with 4 m/s
  for (std::size_t k = 1; k < widest.size(); ++k) {
    EXPECT_LT(widest[k], 1.002 * widest[k - 1]);
    EXPECT_GT(widest[k], 0.98 * widest[k - 1]);  // without the velocity carry: 0.945
  }
}

TEST(CouplingHold, AHolderAtAWallOrOnTheGroundGainsNoEnergy) {
  for (const bool wall : {true, false}) {
    Hanging hanging(5.0, 0.0);
    hanging.run(120);
    b2BodyDef definition;
    definition.position = wall ? b2Vec2(1.2F, -4.0F) : b2Vec2(0.0F, -4.65F);
    b2PolygonShape box;
    box.SetAsBox(wall ? 0.5F : 20.0F, wall ? 20.0F : 0.5F);
    hanging.world.CreateBody(&definition)->CreateFixture(&box, 0.0F);
    hanging.body->SetLinearVelocity({6.0F, wall ? 0.0F : -6.0F});
    const double start = y_of(hanging.body);
    double fastest = 0.0;
    double highest = start;
    for (int k = 0; k < 1200; ++k) {
      hanging.run(1);
      fastest = std::max(fastest, length(hanging.coupling.body(*hanging.body).velocity()));
      highest = std::max(highest, y_of(hanging.body));
    }
    EXPECT_LT(fastest, 8.6) << wall;
    EXPECT_LT(highest, start + 72.0 / (2.0 * 9.81) + 0.2) << wall;
    EXPECT_TRUE(test_support::all_finite(hanging.coupling.cord(0).thesis()));
  }
}

TEST(CouplingHold, HeldOffCentreABodyHangsWithItsCentreBelowTheAnchor) {
  Hanging hanging(2.0, 2.0);
  hanging.body->SetTransform(ribbon::box2d::to_float(hanging.end() + Vec2{0.3, 0.0}), 0.0F);
  hanging.body->SetAngularDamping(1.0F);
  hanging.coupling.grip(hanging.grip).move_anchor({-0.3F, 0.0F});
  hanging.run(1800);
  const Vec2 hand = ribbon::box2d::to_double(hanging.body->GetWorldPoint({-0.3F, 0.0F}));
  const Vec2 center = ribbon::box2d::to_double(hanging.body->GetWorldCenter());
  EXPECT_NEAR(center.x - hand.x, 0.0, 5e-3);
  EXPECT_NEAR(center.y - hand.y, -0.3, 5e-3);
  EXPECT_NEAR(static_cast<double>(hanging.body->GetAngularVelocity()), 0.0, 0.02);
  EXPECT_NEAR(length(hanging.end() - hand), 0.0, 2e-3);
}

TEST(CouplingHold, AnAnchorThatMovesOnItsBodyArrivesWithinTheTick) {
  Hanging hanging(5.0);
  hanging.run(120);
  hanging.coupling.grip(hanging.grip).move_anchor({0.05F, 0.1F});
  hanging.run(1);
  EXPECT_NEAR(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetWorldPoint({0.05F, 0.1F}))), 0.0, 5e-3);
}

TEST(CouplingHold, AReleasedBodyKeepsItsVelocity) {
  Hanging hanging(2.0);
  hanging.body->SetLinearVelocity({3.0F, 0.0F});
  hanging.run(20);
  const Vec2 velocity = hanging.coupling.body(*hanging.body).velocity();
  EXPECT_TRUE(hanging.coupling.body(*hanging.body).held_place());
  EXPECT_TRUE(hanging.coupling.body(*hanging.body).release());
  EXPECT_FALSE(hanging.coupling.body(*hanging.body).release());
  EXPECT_FALSE(hanging.coupling.body(*hanging.body).held_place());
  hanging.run(1);
  EXPECT_NEAR(length(hanging.coupling.body(*hanging.body).velocity() - velocity - Vec2{0.0, -9.81 * dt}), 0.0, 1e-5);
}

TEST(CouplingHold, ConservesTheMomentumOfCordAndHolder) {
  b2World world({0.0F, 0.0F});
  ribbon::box2d::Coupling coupling;
  coupling.add(ThesisCord(cord_def()));
  b2Body* body = add_circle(world, {4.5, 0.3}, 0.2, b2_dynamicBody, 8.0);
  body->SetLinearVelocity({1.0F, 2.0F});
  body->SetAngularVelocity(2.0F);
  coupling.hold(0, 41, *body, {-0.5F, -0.2F});  // where the cord's last point is
  const auto total = [&] {
    return test_support::momentum(coupling.cord(0).thesis()) +
           static_cast<double>(body->GetMass()) * coupling.body(*body).velocity();
  };
  const Vec2 before = total();
  for (int k = 0; k < 600; ++k) {
    tick(coupling, world);
    const Vec2 now = total();
    ASSERT_EQ(coupling.cord(0).thesis_report().motion_limited, 0);
    ASSERT_NEAR(length(now - before), 0.0, 1e-9 * length(before)) << "tick " << k;
  }
}

TEST(CouplingHold, AHolderThatIsDestroyedReleases) {
  Hanging hanging(2.0);
  hanging.run(10);
  hanging.world.DestroyBody(hanging.body);  // without telling the coupling
  hanging.run(10);
  EXPECT_TRUE(test_support::all_finite(hanging.coupling.cord(0).thesis()));

  Hanging told(2.0);
  told.run(10);
  told.coupling.destroy(told.world, *told.body);
  b2Body* next = add_circle(told.world, {5.0, 5.0}, 0.1);  // Box2D reuses the address
  told.run(10);
  EXPECT_FALSE(told.coupling.body(*next).held_place());
  EXPECT_NEAR(static_cast<double>(next->GetPosition().x), 5.0, 1e-6);
}

TEST(CouplingHold, AHolderMovedFarAwayIsPulledBackAndStaysFinite) {
  Hanging hanging(5.0);
  hanging.run(60);
  hanging.body->SetTransform({8.0F, 3.0F}, 0.0F);
  double fastest = 0.0;
  for (int k = 0; k < 600; ++k) {
    hanging.run(1);
    fastest = std::max(fastest, length(hanging.coupling.body(*hanging.body).velocity()));
  }
  EXPECT_LT(fastest, 60.0);
  EXPECT_LT(length(hanging.end() - ribbon::box2d::to_double(hanging.body->GetPosition())), 0.05);
  EXPECT_EQ(test_support::inverted_triangles(hanging.coupling.cord(0).thesis()), 0);
}

TEST(CouplingHold, RefusesUnknownCordsPointsAndBodies) {
  Hanging hanging(2.0);
  EXPECT_THROW(hanging.coupling.hold(1, 0, *hanging.body, b2Vec2_zero), ribbon::CallError);
  EXPECT_THROW(hanging.coupling.hold(-1, 0, *hanging.body, b2Vec2_zero), ribbon::CallError);
  EXPECT_THROW(hanging.coupling.hold(0, 42, *hanging.body, b2Vec2_zero), ribbon::DefinitionError);
  const b2Vec2 nowhere(std::numeric_limits<float>::quiet_NaN(), 0.0F);
  EXPECT_THROW(hanging.coupling.hold(0, 40, *hanging.body, nowhere), ribbon::DefinitionError);
  EXPECT_EQ(hanging.coupling.body(*hanging.body).held_place()->point, 40);  // as before
}

}  // namespace
}  // namespace engine
