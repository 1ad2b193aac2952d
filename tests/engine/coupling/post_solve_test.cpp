#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "ribbon/box2d/state_hash.h"
#include "tests/engine/coupling/grip_world.h"

// ContactListener::post_solve, and tangent speeds in pre_solve.

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::Integrator;
using ribbon::box2d::ContactListener;
using ribbon::box2d::CordId;
using ribbon::box2d::Surface;
using ribbon::box2d::TouchImpulse;

/// Sums the impulses of each body in a tick.
struct Impulses : ContactListener {
  bool pre_solve(CordId /*cord*/, const b2Fixture& fixture, Surface& surface) override {
    if (&fixture == belt) surface.tangent_speed = belt_speed;
    return true;
  }
  bool wants_impulses() const override { return wanted; }
  void post_solve(CordId cord, const b2Fixture& fixture, std::span<const TouchImpulse> touches) override {
    ++calls;
    EXPECT_FALSE(touches.empty());
    order.emplace_back(cord, &fixture);
    for (const TouchImpulse& touch : touches) {
      sum[fixture.GetBody()] += touch.impulse;
      const Vec2 parts = touch.normal_impulse * touch.normal + touch.tangent_impulse * perp(touch.normal);
      EXPECT_NEAR(length(parts - touch.impulse), 0.0, 1e-12 + 1e-12 * length(touch.impulse));
      normal += touch.normal_impulse;
      tangent += std::abs(touch.tangent_impulse);
    }
  }
  void clear() {
    sum.clear();
    order.clear();
    normal = tangent = 0.0;
  }
  bool wanted = true;
  const b2Fixture* belt = nullptr;
  double belt_speed = 0.0;
  int calls = 0;
  double normal = 0.0;
  double tangent = 0.0;
  std::map<const b2Body*, Vec2> sum;
  std::vector<std::pair<CordId, const b2Fixture*>> order;
};

b2Body* add_ball(GripWorld& scene, Vec2 position, double mass, float restitution = 0.0F) {
  b2Body* const ball = scene.add_body(position, mass);
  ball->GetFixtureList()->SetFilterData(b2Filter());
  ball->GetFixtureList()->SetFriction(0.5F);
  ball->GetFixtureList()->SetRestitution(restitution);
  return ball;
}

CordDef bridge(const Accuracy& accuracy) {
  CordDef def = taut();
  def.radius = 0.02;
  def.friction = 0.5;
  def.drag = 2.0;
  def.accuracy = accuracy;
  return def;
}

/// At rest the cords carry the weight: m·g·dt.
TEST(PostSolve, GivesTheWeightOfABodyAtRest) {
  for (const Accuracy& accuracy : {Accuracy::fast(), Accuracy::balanced(), Accuracy::accurate()}) {
    GripWorld scene;
    Impulses impulses;
    scene.coupling.listen(&impulses);
    scene.coupling.add(Cord(bridge(accuracy)));
    scene.coupling.add(Cord(bridge(accuracy)));
    b2Body* const ball = add_ball(scene, {1.0, 0.25}, 5.0);
    ball->SetFixedRotation(true);
    scene.tick(900);
    impulses.clear();
    scene.tick();
    const double weight = static_cast<double>(ball->GetMass()) * g * dt;
    EXPECT_NEAR(impulses.sum[ball].y / weight, 1.0, 1e-3);
    EXPECT_NEAR(impulses.sum[ball].x / weight, 0.0, 1e-3);
    const b2Fixture* const fixture = ball->GetFixtureList();
    EXPECT_EQ(impulses.order, (std::vector<std::pair<CordId, const b2Fixture*>>{{0, fixture}, {1, fixture}}));
  }
}

/// In each tick of an impact with restitution and friction the impulses are what changes the velocity of the body. (In
/// the worst of them the energy guard takes half a millijoule out of all velocities.)
void expect_impulses_of_an_impact(Accuracy accuracy) {
  for (const auto& [restitution, soft] : {std::pair{0.0F, false}, {0.6F, false}, {0.0F, true}, {0.6F, true}}) {
    GripWorld scene;
    accuracy.soft_contacts = soft;
    Impulses impulses;
    scene.coupling.listen(&impulses);
    scene.coupling.add(Cord(bridge(accuracy)));
    b2Body* const ball = add_ball(scene, {0.8, 1.0}, 2.0, restitution);
    ball->SetLinearVelocity({1.0F, -2.0F});
    ball->SetAngularVelocity(5.0F);
    const auto mass = static_cast<double>(ball->GetMass());
    double largest = 0.0;
    double error = 0.0;
    double tangent = 0.0;
    for (int k = 0; k < 90; ++k) {
      const Vec2 before = std::as_const(scene.coupling).body(*ball).velocity();
      impulses.clear();
      scene.tick();
      const Vec2 after = std::as_const(scene.coupling).body(*ball).velocity();
      const Vec2 got = mass * (after - before + Vec2{0.0, g * dt});
      error = std::max(error, length(got - impulses.sum[ball]));
      largest = std::max(largest, length(got));
      tangent += impulses.tangent;
    }
    EXPECT_GT(largest, 5.0);
    EXPECT_GT(tangent, 0.1) << "friction acts";
    // Newton steps of soft contacts may end before their forces are those of their depths.
    const bool settled = !soft || accuracy.integrator == Integrator::implicit_euler;
    EXPECT_LT(error, (settled ? 1e-3 : 1e-2) * largest) << restitution << " " << soft << " " << accuracy.substeps;
  }
}

TEST(PostSolve, GivesWhatABodyGetsInAnImpact) {
  Accuracy fast = Accuracy::fast();
  fast.tolerance = 1e-4;
  expect_impulses_of_an_impact(fast);
  expect_impulses_of_an_impact(Accuracy::balanced());
  expect_impulses_of_an_impact(Accuracy::accurate());
}

/// The impulses of a step that is solved by halves are those of all its parts.
TEST(PostSolve, AddsUpThePartsOfAStep) {
  GripWorld scene;
  Impulses impulses;
  scene.coupling.listen(&impulses);
  CordDef def = bridge(Accuracy::accurate());
  def.stretch_stiffness = 1e4;
  def.accuracy.max_work = 1'000'000;  // with less, substeps are not halved
  scene.coupling.add(Cord(def));
  b2Body* const ball = add_ball(scene, {0.8, 1.0}, 1000.0);
  ball->SetLinearVelocity({1.0F, -20.0F});
  const auto mass = static_cast<double>(ball->GetMass());
  int halved = 0;
  double error = 0.0;
  for (int k = 0; k < 60; ++k) {
    const Vec2 before = std::as_const(scene.coupling).body(*ball).velocity();
    impulses.clear();
    scene.tick();
    if (scene.coupling.last_step().report().halvings == 0) continue;
    ++halved;
    const Vec2 after = std::as_const(scene.coupling).body(*ball).velocity();
    const Vec2 got = mass * (after - before + Vec2{0.0, g * dt});
    error = std::max(error, length(got - impulses.sum[ball]));
  }
  EXPECT_LT(error, 1e-3 * mass * 20.0) << "of the momentum of the ball";
  EXPECT_GT(halved, 5);
}

/// Without a wish for impulses nothing is called and nothing is stored, and the wish changes no bit of the motion.
TEST(PostSolve, ChangesNothing) {
  std::vector<Vec2> ends;
  for (const bool wanted : {false, true}) {
    GripWorld scene;
    Impulses impulses;
    impulses.wanted = wanted;
    scene.coupling.listen(&impulses);
    const CordId cord = scene.coupling.add(Cord(bridge(Accuracy::balanced())));
    add_ball(scene, {0.8, 0.4}, 2.0, 0.5F);
    bool any = false;
    for (int k = 0; k < 120; ++k) {
      scene.tick();
      for (const ribbon::Touch& touch : scene.coupling.cord(cord).direct().touches())
        any = any || !(touch.push == Vec2{});
    }
    EXPECT_EQ(impulses.calls > 0, wanted);
    EXPECT_EQ(any, wanted);
    ends.push_back(scene.coupling.cord(cord).positions()[10]);
  }
  EXPECT_EQ(ends[0], ends[1]);
}

/// A sled with a belt: what the rope gains, the sled loses.
TEST(TangentSpeed, GivesADynamicBodyTheReaction) {
  GripWorld scene;
  b2BodyDef of_ground;
  b2EdgeShape edge;
  edge.SetTwoSided({-50.0F, -1.0F}, {50.0F, -1.0F});
  b2FixtureDef ground;
  ground.shape = &edge;
  ground.friction = 0.0F;
  ground.filter.categoryBits = 2;
  scene.world.CreateBody(&of_ground)->CreateFixture(&ground);
  b2BodyDef of_sled;
  of_sled.type = b2_dynamicBody;
  of_sled.position.Set(0.0F, -0.585F);  // as Box2D lets it lie on the edge
  b2PolygonShape box;
  box.SetAsBox(10.0F, 0.4F);
  b2FixtureDef top;
  top.shape = &box;
  top.density = 0.5F;  // 4 kg
  top.friction = 0.4F;
  b2Body* const sled = scene.world.CreateBody(&of_sled);
  Impulses impulses;
  impulses.belt = sled->CreateFixture(&top);
  scene.coupling.listen(&impulses);
  CordDef def;
  def.points = 11;
  def.length = 1.0;
  def.mass_per_length = 2.0;
  def.radius = 0.02;
  def.friction = 0.4;
  def.positions = test_support::equally_spaced(def.points, {-0.5, -0.185 + 0.03}, {0.1, 0.0});
  b2Filter of_cord;
  of_cord.maskBits = 1;
  const CordId rope = scene.coupling.add(Cord(def), of_cord);
  scene.tick(30);
  impulses.belt_speed = 3.0;
  const auto speeds = [&] {
    Vec2 mean;
    for (const Vec2 v : scene.coupling.cord(rope).direct().velocities()) mean += (1.0 / def.points) * v;
    return std::pair{mean.x, std::as_const(scene.coupling).body(*sled).velocity().x};
  };
  scene.tick(20);
  // The end points have half the mass of the others, but all points have the same velocity.
  const auto [early, early_sled] = speeds();
  EXPECT_NEAR(early / (0.4 * g * 20 * dt), 1.0, 0.02);
  EXPECT_NEAR(2.0 * early + static_cast<double>(sled->GetMass()) * early_sled, 0.0, 0.01);
  scene.tick(100);
  const auto [late, late_sled] = speeds();
  EXPECT_NEAR(late - late_sled, 3.0, 0.02);
  EXPECT_NEAR(2.0 * late + static_cast<double>(sled->GetMass()) * late_sled, 0.0, 0.02);
}

/// What is out of range counts as the nearest value in it.
TEST(TangentSpeed, OutOfRangeIsLimited) {
  for (const double speed : {std::nan(""), 1e300, -std::numeric_limits<double>::infinity()}) {
    GripWorld scene;
    Impulses impulses;
    scene.coupling.listen(&impulses);
    const CordId cord = scene.coupling.add(Cord(bridge(Accuracy::balanced())));
    impulses.belt = add_ball(scene, {1.0, 0.25}, 1.0)->GetFixtureList();
    impulses.belt_speed = speed;
    scene.tick(60);
    for (const Vec2 x : scene.coupling.cord(cord).positions()) EXPECT_LT(length(x), 10.0);
  }
}

}  // namespace
}  // namespace engine
