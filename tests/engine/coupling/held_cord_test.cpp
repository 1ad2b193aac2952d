#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/cord_forces.h"
#include "tests/support/allocations.h"
#include "tests/support/constants.h"
#include "tests/support/exact_chain.h"
#include "tests/support/heavy_swing.h"
#include "tests/support/points.h"
#include "tests/support/shape_world.h"

// A Box2D body held by a cord of the direct solver.

namespace engine {
namespace {

using constants::dt;
using constants::infinity;
using ribbon::Vec2;
using test_support::path_length;

struct HoldingWorld {
  b2World world{{0.0F, -9.81F}};
  ribbon::box2d::Coupling coupling;
  b2Body* body = nullptr;

  void make_body(Vec2 position, double mass, double inertia) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.position = ribbon::box2d::to_float(position);
    definition.allowSleep = false;
    body = world.CreateBody(&definition);
    b2MassData data;
    data.mass = static_cast<float>(mass);
    data.center.SetZero();
    data.I = static_cast<float>(inertia);
    body->SetMassData(&data);
  }
  void tick() { coupling.tick(world, dt); }
};

/// A holder gets the whole impulse per tick or force, whether it is applied before or after the coupling's part of the
/// tick.
TEST(HeldCord, AHolderGetsAllImpulsesAndForces) {
  ribbon::CordDef def;
  def.points = 31;
  def.length = 6.0;
  def.mass_per_length = 0.5;
  def.pins = {0};
  def.positions = test_support::equally_spaced(31, {0.0, 0.0}, {0.0, -0.2});
  constexpr double mass = 60.0;
  constexpr double push = 270.0;  // N
  ribbon::CordDef fine = def;
  fine.accuracy.substeps = 64;
  ribbon::Cord exact(fine);
  exact.attach_mass(30, mass);
  exact.set_load(30, {push, 0.0});
  for (int k = 0; k < 60; ++k) exact.step(dt, {0.0, -9.81});
  for (const bool impulse : {true, false}) {
    for (const bool before : {true, false}) {
      HoldingWorld scene;
      scene.coupling.add(ribbon::Cord(def));
      scene.make_body({0.0, -6.0}, mass, 0.0);
      scene.coupling.hold(0, 30, *scene.body, {0.0F, 0.0F});
      const auto give = [&] {
        if (impulse) scene.body->ApplyLinearImpulseToCenter({static_cast<float>(push * dt), 0.0F}, true);
        if (!impulse) scene.body->ApplyForceToCenter({static_cast<float>(push), 0.0F}, true);
      };
      for (int k = 0; k < 60; ++k) {
        if (before) give();
        test_support::step_cords(scene.coupling, scene.world, dt);
        if (!before) give();
        scene.world.Step(static_cast<float>(dt), 8, 3);
      }
      // An impulse acts half a tick before or after the force of the same size: 1.7 % of the distance in a second.
      const Vec2 way = ribbon::box2d::to_double(scene.body->GetPosition()) - Vec2{0.0, -6.0};
      EXPECT_NEAR(way.x, exact.positions()[30].x, 0.02 * exact.positions()[30].x) << impulse << before;
      EXPECT_NEAR(scene.coupling.body(*scene.body).velocity().x, exact.velocities()[30].x, 0.05) << impulse << before;
    }
  }
}

/// heavy_swing with a body of Box2D as its load, held at its centre. Accepted errors: 2 cm and 0.05 %.
TEST(HeldCord, HeavySwingThroughBox2D) {
  const std::vector<Vec2> exact = test_support::exact_heavy_load();
  for (const double inertia : {0.0, 7.0}) {
    HoldingWorld scene;
    ribbon::Cord cord = test_support::heavy_swing(infinity, ribbon::Accuracy::balanced());
    cord.attach_mass(50, 0.0);
    scene.coupling.add(std::move(cord));
    scene.make_body({10.0, 0.0}, 70.0, inertia);
    scene.coupling.hold(0, 50, *scene.body, {0.0F, 0.0F});
    std::vector<Vec2> path;
    double stretch = 0.0;
    for (int k = 0; k < 300; ++k) {
      scene.tick();
      path.push_back(ribbon::box2d::to_double(scene.body->GetPosition()));
      stretch = std::max(stretch, path_length(scene.coupling.cord(0).direct().positions()) / 10.0 - 1.0);
    }
    EXPECT_LE(test_support::rms_distance(path, exact), 0.02);
    EXPECT_LE(stretch, 5e-4);
    RecordProperty("rms_mm", std::to_string(1e3 * test_support::rms_distance(path, exact)));
    RecordProperty("stretch_percent", std::to_string(100.0 * stretch));
  }
}

class HeldMassRatio : public testing::TestWithParam<double> {};

/// After a drop with a slightly slack cord, the stretch is that of the elasticity, and the body rests without jitter.
TEST_P(HeldMassRatio, StretchesByItsElasticityAndRests) {
  const double ratio = GetParam();
  for (const double stiffness : {infinity, 1e3}) {  // EA / Mg
    ribbon::CordDef def;
    def.points = 31;
    def.length = 3.0;
    def.mass_per_length = 1.0 / 3.0;
    def.stretch_stiffness = stiffness * (1.0 + ratio) * 9.81;
    def.damping = 0.02;
    def.pins = {0};
    for (int p = 0; p <= 30; ++p) def.positions.push_back({0.0, -0.1 * p});
    HoldingWorld scene;
    scene.coupling.add(ribbon::Cord(def));
    scene.make_body({0.0, -3.0}, ratio, 0.1 * ratio);
    scene.coupling.hold(0, 30, *scene.body, {0.0F, 0.0F});
    double stretch = 0.0;
    for (int k = 0; k < 600; ++k) {
      scene.tick();
      stretch = std::max(stretch, path_length(scene.coupling.cord(0).direct().positions()) / 3.0 - 1.0);
    }
    const double elastic = 2.0 / stiffness;  // released at rest length it falls twice as far as its static stretch
    EXPECT_LE(stretch, 1.05 * elastic + 5e-4);
    double jitter = 0.0;
    for (int k = 0; k < 60; ++k) {
      const Vec2 before = ribbon::box2d::to_double(scene.body->GetPosition());
      scene.tick();
      jitter = std::max(jitter, length(ribbon::box2d::to_double(scene.body->GetPosition()) - before));
    }
    EXPECT_LE(jitter, 1e-6 * 3.0);
    const double pull = scene.coupling.cord(0).direct().tensions()[29];
    EXPECT_NEAR(pull, (ratio + scene.coupling.cord(0).direct().mass(30)) * 9.81, 1e-3 * ratio * 9.81);
  }
}

INSTANTIATE_TEST_SUITE_P(Ratios, HeldMassRatio, testing::Values(168.0, 200.0, 672.0, 1000.0, 1800.0, 1e6));

/// Returns the kinetic energy of a body from its momentary velocities, J.
double energy(const HoldingWorld& scene, double turning) {
  const Vec2 v = scene.coupling.body(*scene.body).velocity();
  return 0.5 * static_cast<double>(scene.body->GetMass()) * dot(v, v) +
         0.5 * static_cast<double>(scene.body->GetInertia()) * turning * turning +
         9.81 * static_cast<double>(scene.body->GetMass() * scene.body->GetPosition().y);
}

/// A bar that is held at its end swings as a pendulum; the angular velocity in Box2D is the mean of a tick.
TEST(HeldCord, TheAngularVelocityIsThatAtTheEndOfATick) {
  HoldingWorld scene;
  ribbon::CordDef def;
  def.points = 2;
  def.length = 0.1;
  def.mass_per_length = 1e-3;
  def.positions = {{0.0, 0.0}, {0.1, 0.0}};
  def.pins = {0};
  def.accuracy = ribbon::Accuracy::accurate();
  scene.coupling.add(ribbon::Cord(def));
  scene.make_body({0.6, 0.0}, 2.0, 2.0 / 12.0);
  scene.coupling.hold(0, 1, *scene.body, {-0.5F, 0.0F});
  const double start = energy(scene, 0.0);
  double off = 0.0;
  double off_of_means = 0.0;
  for (int k = 0; k < 120; ++k) {
    scene.tick();
    const double now = energy(scene, scene.coupling.body(*scene.body).angular_velocity()) +
                       energy_of(scene.coupling.cord(0).direct(), {0.0, -9.81}).total();
    const double by_means = energy(scene, static_cast<double>(scene.body->GetAngularVelocity())) +
                            energy_of(scene.coupling.cord(0).direct(), {0.0, -9.81}).total();
    off = std::max(off, std::abs(now - start));
    off_of_means = std::max(off_of_means, std::abs(by_means - start));
  }
  EXPECT_LT(off, 0.03 * 2.0 * 9.81 * 0.6);
  EXPECT_GT(off_of_means, 3.0 * off);
}

/// A box on the ground, held by a cord, with a carry and a step of Box2D that the test chooses.
class CarryOfABoxOnTheGround : public testing::Test {
 protected:
  CarryOfABoxOnTheGround() {
    ribbon::CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.pins = {0};
    scene.coupling.add(ribbon::Cord(def));
    scene.make_body({1.0, 0.0}, 2.0, 0.2);
    b2PolygonShape box;
    box.SetAsBox(0.2F, 0.2F);
    scene.body->CreateFixture(&box, 10.0F);
    b2BodyDef ground;
    ground.position = {0.0F, -0.7F};
    b2PolygonShape flat;
    flat.SetAsBox(5.0F, 0.5F);
    scene.world.CreateBody(&ground)->CreateFixture(&flat, 0.0F);
    scene.coupling.hold(0, 10, *scene.body, {0.0F, 0.0F});
    for (int k = 0; k < 10; ++k) scene.tick();
    EXPECT_TRUE(scene.body->GetContactList() != nullptr && scene.body->GetContactList()->contact->IsTouching());
  }

  /// Returns the angular carry that is left of `carry` after a push of Box2D, rad/s.
  double turning(double carry, double push) {
    ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    state.carries.at(0).memory.angular_carry = carry;
    state.carries.at(0).memory.angular_velocity = angular_velocity() - push;
    scene.coupling.restore(state, scene.world);
    return scene.coupling.body(*scene.body).angular_velocity() - angular_velocity();
  }

  /// Returns the body's velocity along x [m/s] after it moved with `velocity`, with a `carry`, and Box2D pushed it.
  double moving(double velocity, double carry, double push) {
    const float moved = static_cast<float>(velocity + push);
    scene.body->SetLinearVelocity({moved, 0.0F});
    ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    ribbon::box2d::CarryState& memory = state.carries.at(0).memory;
    memory.carry = {carry, 0.0};
    memory.velocity = {static_cast<double>(moved) - push, 0.0};
    memory.start =
        ribbon::box2d::to_double(scene.body->GetWorldCenter()) - memory.dt * Vec2{static_cast<double>(moved), 0.0};
    memory.expected_delta_v = {};
    scene.coupling.restore(state, scene.world);
    return scene.coupling.body(*scene.body).velocity().x;
  }

  /// Returns the push [m/s] in a direction that the solver expects of the ground after one of 4 m/s in the tick before,
  /// and another one that changed the body's velocity from `start_velocity` to 0.
  double expected_push(Vec2 direction, double start_velocity) {
    scene.body->SetLinearVelocity({0.0F, 0.0F});
    ribbon::box2d::Coupling::State state = scene.coupling.save(scene.world);
    ribbon::box2d::CarryState& memory = state.carries.at(0).memory;
    memory.carry = {};
    memory.velocity = -4.0 * direction;
    memory.start_velocity = start_velocity * direction;
    memory.start = ribbon::box2d::to_double(scene.body->GetWorldCenter());
    memory.contact_delta_v = 4.0 * direction;
    scene.coupling.restore(state, scene.world);
    scene.tick();
    return dot(scene.coupling.save(scene.world).carries.at(0).memory.expected_delta_v, direction);
  }

  double angular_velocity() const { return static_cast<double>(scene.body->GetAngularVelocity()); }

  HoldingWorld scene;
};

/// It ends if Box2D has pushed against it, and continues if not.
TEST_F(CarryOfABoxOnTheGround, OfARotationEndsWithAnOpposingPush) {
  EXPECT_EQ(turning(5.0, -1.0), 0.0);
  EXPECT_EQ(turning(-5.0, 1.0), 0.0);
  EXPECT_NEAR(turning(5.0, 0.0), 5.0, 1e-12);
}

/// A push with it did the work that the body has in Box2D, and no more.
TEST_F(CarryOfABoxOnTheGround, OfARotationGainsNoEnergyByAPush) {
  const double now = angular_velocity();
  const double end = now + turning(5.0, 1.0);
  EXPECT_NEAR(end * end, (now + 4.0) * (now + 4.0) + now * now - (now - 1.0) * (now - 1.0), 1e-9);
}

/// A contact ends the carry. Where a cord slowed the body down, the carry is against its velocity: a light touch must
/// not give the velocity back.
TEST_F(CarryOfABoxOnTheGround, IsNotReturnedByALightContact) {
  EXPECT_NEAR(moving(10.0, 2.0, -0.5), 9.5, 1e-6);
  EXPECT_NEAR(moving(10.0, -2.0, -0.5), std::sqrt(8.0 * 8.0 + 9.5 * 9.5 - 10.0 * 10.0), 1e-6);
  EXPECT_NEAR(moving(10.0, -2.0, 0.0), 8.0, 1e-6);
}

/// A push that holds a body against a load goes on. An impact is over, also one that took two ticks: a body that the
/// solver expects to be pushed again is thrown back.
TEST_F(CarryOfABoxOnTheGround, DoesNotExtrapolateAnImpact) {
  const Vec2 along{1.0, 0.0};
  EXPECT_NEAR(expected_push(along, 0.0), 4.0, 1e-6);
  EXPECT_NEAR(expected_push(along, -4.0), 0.0, 1e-6);
  EXPECT_NEAR(expected_push(along, -3.0), 1.0, 1e-6);
}

/// The solver finds it itself.
TEST_F(CarryOfABoxOnTheGround, DoesNotExpectThePushOfASupport) {
  EXPECT_NEAR(expected_push({0.0, 1.0}, 0.0), 0.0, 1e-6);
}

TEST(HeldCord, AfterReleaseBodyAndCordKeepTheirMotion) {
  HoldingWorld scene;
  ribbon::Cord cord = test_support::heavy_swing(infinity, ribbon::Accuracy::balanced());
  cord.attach_mass(50, 0.0);
  scene.coupling.add(std::move(cord));
  scene.make_body({10.0, 0.0}, 70.0, 0.0);
  scene.coupling.hold(0, 50, *scene.body, {0.0F, 0.0F});
  for (int k = 0; k < 80; ++k) scene.tick();
  const Vec2 velocity = scene.coupling.body(*scene.body).velocity();
  EXPECT_TRUE(scene.coupling.body(*scene.body).release());
  scene.tick();
  const Vec2 after = ribbon::box2d::to_double(scene.body->GetLinearVelocity());
  EXPECT_NEAR(length(after - (velocity + dt * Vec2{0.0, -9.81})), 0.0, 1e-4);
  for (int k = 0; k < 60; ++k) scene.tick();
  EXPECT_GT(length(ribbon::box2d::to_double(scene.body->GetPosition())), 10.1);
  EXPECT_EQ(scene.coupling.cord(0).island_report().unconverged, 0);
}

TEST(HeldCord, CordsOfBothSolversShareAWorld) {
  HoldingWorld scene;
  scene.coupling.add(ribbon::ThesisCord(ribbon::ThesisDef{}));
  scene.coupling.add(test_support::heavy_swing(infinity, ribbon::Accuracy::fast()));
  EXPECT_EQ(scene.coupling.cord(0).positions().size(), 50U);
  EXPECT_EQ(scene.coupling.cord(1).positions().size(), 51U);
  EXPECT_THROW(scene.coupling.cord(1).thesis(), ribbon::CallError);
  EXPECT_THROW(scene.coupling.cord(0).direct(), ribbon::CallError);
  scene.make_body({10.0, 0.0}, 5.0, 1.0);
  EXPECT_THROW(scene.coupling.hold(1, 51, *scene.body, b2Vec2_zero), ribbon::DefinitionError);
  const auto nearest = scene.coupling.nearest_point({10.0, 0.1}, 0.5);
  ASSERT_TRUE(nearest.has_value());
  EXPECT_EQ(nearest->cord, 1);
  EXPECT_EQ(nearest->point, 50);
  scene.coupling.hold(1, 50, *scene.body, {0.0F, 0.0F});
  scene.tick();
  const test_support::AllocationCount count;
  test_support::step_cords(scene.coupling, scene.world, dt);
  EXPECT_EQ(count.so_far(), 0);
}

}  // namespace
}  // namespace engine
