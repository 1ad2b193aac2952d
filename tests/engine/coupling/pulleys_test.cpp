#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/replay/solver_step.h"
#include "ribbon/pulley.h"
#include "ribbon/weather.h"
#include "tests/engine/coupling/grip_world.h"
#include "tests/support/allocations.h"
#include "tests/support/freed_body.h"
#include "tests/support/pulleys.h"
#include "tests/support/refusal.h"

namespace engine {
namespace {

using ribbon::Accuracy;
using ribbon::CallError;
using ribbon::DefinitionError;
using ribbon::PulleyDef;
using ribbon::ReevedCord;
using ribbon::box2d::CordId;
using ribbon::box2d::Coupling;
using ribbon::box2d::CutEvent;
using ribbon::box2d::PulleyId;
using ribbon::box2d::PulleyState;
using test_support::refusal;
using test_support::says;

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Two bodies that hold the ends of a cord over a wheel on a wall.
struct BodiesOverAWheel : GripWorld {
  explicit BodiesOverAWheel(double left_mass = 10.0, double right_mass = 12.0, double inertia = 0.5) {
    wheel = {.center = {0.0, 5.0}, .radius = 0.25, .counterclockwise = false, .inertia = inertia};
    const ReevedCord reeved = ribbon::reeve({-0.25, 1.5}, {&wheel, 1}, {0.25, 1.5}, 61);
    CordDef def;
    def.points = 61;
    def.length = reeved.length;
    def.positions = reeved.positions;
    def.mass_per_length = 1e-4;
    cord = coupling.add(Cord(def));
    wall = add_body({0.0, 4.0}, 1.0, b2_staticBody);
    pulley = coupling.add_pulley(cord, *wall, reeved.pulleys[0]);
    left = add_body({-0.25, 1.5}, left_mass);
    right = add_body({0.25, 1.5}, right_mass);
    coupling.hold(*left, {.cord = cord, .arc = 0.0});
    coupling.hold(*right, {.cord = cord, .arc = reeved.length});
  }
  double acceleration() const {
    const double masses = static_cast<double>(left->GetMass() + right->GetMass());
    const double difference = static_cast<double>(right->GetMass() - left->GetMass());
    return difference * g / (masses + wheel.inertia / (wheel.radius * wheel.radius));
  }
  PulleyState state() const { return coupling.pulley(pulley).state(); }

  PulleyDef wheel;
  CordId cord;
  PulleyId pulley;
  b2Body* wall;
  b2Body* left;
  b2Body* right;
};

TEST(Pulleys, GiveIdsAndHandles) {
  BodiesOverAWheel scene;
  EXPECT_EQ(scene.pulley, 1);
  EXPECT_TRUE(scene.coupling.pulley(1).is_valid());
  EXPECT_FALSE(scene.coupling.pulley(2).is_valid());
  const PulleyState state = scene.state();
  EXPECT_EQ(state.cord, scene.cord);
  EXPECT_LT(length(state.center - Vec2{0.0, 5.0}), 1e-6);
  EXPECT_NEAR(state.arc, std::numbers::pi, 1e-9);
  EXPECT_EQ(state.def.radius, 0.25);
}

/// The bar of the formula, with bodies of Box2D that the cord carries.
TEST(Pulleys, CarryBodiesAsAtwoodsMachineDoes) {
  for (const double inertia : {0.0, 0.5, 3.0}) {
    BodiesOverAWheel scene(10.0, 12.0, inertia);
    scene.tick(120);
    const double speed = 2.0 * scene.acceleration();
    EXPECT_NEAR(scene.coupling.body(*scene.left).velocity().y / speed, 1.0, 1e-3) << inertia;
    EXPECT_NEAR(-scene.coupling.body(*scene.right).velocity().y / speed, 1.0, 1e-3);
    EXPECT_NEAR(scene.state().turning / (-speed / 0.25), 1.0, 1e-3);
    EXPECT_NEAR(scene.state().tension_before / (10.0 * (g + scene.acceleration())), 1.0, 1e-3);
    EXPECT_EQ(scene.coupling.last_step().report().unconverged, 0);
  }
}

TEST(Pulleys, CarryABlockOfATackle) {
  GripWorld scene;
  const ReevedCord reeved = test_support::reeve_tackle(181);
  CordDef def;
  def.points = 181;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.mass_per_length = 1e-5;
  def.pins = {180};
  const CordId cord = scene.coupling.add(Cord(def));
  b2Body* const fixed = scene.add_body(test_support::fixed_block, 1.0, b2_staticBody);
  b2Body* const block = scene.add_body(test_support::moving_block, 40.0);
  b2Body* const hand = scene.add_body(reeved.positions[0], 11.0);
  for (std::size_t k = 0; k < 4; ++k) scene.coupling.add_pulley(cord, k % 2 == 0 ? *fixed : *block, reeved.pulleys[k]);
  scene.coupling.hold(*hand, {.cord = cord, .arc = 0.0});
  scene.tick(120);
  const auto h = static_cast<double>(hand->GetMass());
  const auto load = static_cast<double>(block->GetMass());
  const double a = g * (4.0 * h - load) / (16.0 * h + load);
  EXPECT_NEAR(scene.coupling.body(*block).velocity().y / (2.0 * a), 1.0, 2e-3);
  EXPECT_NEAR(scene.coupling.body(*hand).velocity().y / (-8.0 * a), 1.0, 2e-3);
  EXPECT_LT(std::abs(block->GetAngle()), 1e-3F);
}

TEST(Pulleys, LiftWithAMotor) {
  BodiesOverAWheel scene(10.0, 12.0);
  scene.coupling.pulley(scene.pulley).set_motor(2.0, 500.0);
  scene.tick(60);
  EXPECT_NEAR(scene.state().turning, 2.0, 1e-9);
  EXPECT_NEAR(static_cast<double>(scene.right->GetLinearVelocity().y), 0.5, 1e-3);
  scene.coupling.pulley(scene.pulley).set_motor(0.0, unlimited);
  scene.tick(60);
  EXPECT_NEAR(static_cast<double>(scene.right->GetLinearVelocity().y), 0.0, 1e-3);
}

TEST(Pulleys, EndWithTheirBodyCordOrCall) {
  for (const int how : {0, 1, 2, 3, 4, 5}) {
    BodiesOverAWheel scene;
    scene.tick(10);
    if (how == 0) scene.world.DestroyBody(scene.wall);
    if (how == 1) scene.coupling.destroy(scene.world, *scene.wall);
    if (how == 2) scene.wall->SetEnabled(false);
    if (how == 3) scene.coupling.pulley(scene.pulley).remove();
    if (how == 4) scene.coupling.remove(scene.cord);
    if (how == 5) scene.coupling.cord(scene.cord).set_enabled(false);
    scene.tick(60);
    EXPECT_FALSE(scene.coupling.pulley(scene.pulley).is_valid()) << how;
    EXPECT_FALSE(scene.coupling.pulley(scene.pulley).remove());
    EXPECT_LT(scene.left->GetPosition().y, 1.0F) << "it falls, " << how;
    EXPECT_TRUE(
        says(refusal<CallError>([&] { (void)scene.coupling.pulley(scene.pulley).state(); }), "pulley is 1; accepted"));
  }
}

TEST(Pulleys, GoToThePieceThatHasThem) {
  BodiesOverAWheel scene;
  scene.tick(10);
  const CutEvent below = scene.coupling.cord(scene.cord).cut(7.0);
  ASSERT_TRUE(scene.coupling.pulley(scene.pulley).is_valid());
  EXPECT_EQ(scene.state().cord, *below.first);
  scene.tick(30);
  const CutEvent before = scene.coupling.cord(*below.first).cut(0.5);
  EXPECT_EQ(scene.state().cord, *before.second);
  scene.tick(3);
  scene.coupling.cut({0.0, 5.0}, {0.0, 5.5});
  EXPECT_FALSE(scene.coupling.pulley(scene.pulley).is_valid()) << "cut on the wheel";
  scene.tick(30);
}

TEST(Pulleys, AreSavedAndRestored) {
  BodiesOverAWheel scene;
  scene.coupling.pulley(scene.pulley).set_motor(1.0, 20.0);
  scene.tick(40);
  const Coupling::State saved = scene.coupling.save(scene.world);
  ASSERT_EQ(saved.pulleys.size(), 1U);
  const std::vector<b2Body*> bodies{scene.left, scene.right};
  std::vector<b2Transform> places;
  std::vector<b2Vec2> speeds;
  for (b2Body* body : bodies) {
    places.push_back(body->GetTransform());
    speeds.push_back(body->GetLinearVelocity());
  }
  scene.tick(30);
  const Coupling::State after = scene.coupling.save(scene.world);
  scene.coupling.pulley(scene.pulley).remove();
  scene.tick(3);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    bodies[k]->SetTransform(places[k].p, places[k].q.GetAngle());
    bodies[k]->SetLinearVelocity(speeds[k]);
    bodies[k]->SetAngularVelocity(0.0F);
  }
  scene.coupling.restore(saved, scene.world);
  EXPECT_EQ(scene.coupling.save(scene.world), saved);
  scene.tick(30);
  EXPECT_TRUE(scene.coupling.pulley(scene.pulley).is_valid());
  EXPECT_EQ(std::get<Cord::State>(scene.coupling.save(scene.world).cords[0].state).pulleys[0].lead,
            std::get<Cord::State>(after.cords[0].state).pulleys[0].lead);

  Coupling::State wrong = saved;
  wrong.pulleys.clear();
  EXPECT_EQ(refusal<DefinitionError>([&] { scene.coupling.restore(wrong, scene.world); }),
            "state.pulleys are not those of its cords; accepted is one for each pulley of a cord");
  wrong = saved;
  wrong.pulleys[0].memory.cord = 7;
  EXPECT_TRUE(
      says(refusal<DefinitionError>([&] { scene.coupling.restore(wrong, scene.world); }), "state.pulleys.cord"));
}

TEST(Pulleys, StopAClimber) {
  BodiesOverAWheel scene(10.0, 10.0);
  b2Body* const climber = scene.add_body({-0.25, 2.5}, 0.1);
  const auto grip = scene.coupling.hold(*climber, {.cord = scene.cord, .arc = 1.0});
  scene.coupling.grip(grip).climb(7.0, 2.0);
  for (int k = 0; k < 240; ++k) {
    scene.tick();
    const auto state = scene.coupling.grip(grip).state();
    ASSERT_LE(state.point + state.along, scene.state().def.before);
  }
  EXPECT_GT(scene.coupling.grip(grip).state().arc, 2.5);
}

TEST(Pulleys, TellTheirStateWithoutTheirBody) {
  BodiesOverAWheel scene;
  scene.tick(3);
  scene.world.DestroyBody(scene.wall);
  const test_support::FreedBody watch(scene.wall);
  EXPECT_EQ(scene.state().def.radius, 0.25);
}

TEST(Pulleys, AllocateNothingInASteadyTick) {
  BodiesOverAWheel scene;
  scene.tick(20);
  const test_support::AllocationCount allocations;
  scene.tick(60);
  EXPECT_EQ(allocations.so_far(), 0);
}

/// Contacts, grips, ties and cuts beside a pulley.
TEST(Pulleys, WorkBesideEverythingElse) {
  BodiesOverAWheel scene(10.0, 10.5);
  CordDef rung;
  rung.points = 6;
  rung.length = 0.5;
  rung.positions = test_support::equally_spaced(6, {-0.25, 3.0}, {0.1, 0.0});
  rung.cord_contact = true;
  const CordId tied = scene.coupling.add(Cord(rung));
  scene.coupling.tie({scene.cord, 15, tied, 0});
  b2Body* const box = scene.add_body({-0.4, 3.8}, 2.0);
  for (b2Fixture* f = box->GetFixtureList(); f != nullptr; f = f->GetNext()) f->SetFilterData({});
  b2Body* const climber = scene.add_body({0.25, 3.0}, 1.0);
  const auto grip = scene.coupling.hold(*climber, {.cord = scene.cord, .arc = 6.0});
  scene.coupling.grip(grip).climb(5.0, 0.5);
  for (int k = 0; k < 240; ++k) {
    scene.tick();
    for (const CordId id : scene.coupling.cords()) {
      for (const Vec2 x : scene.coupling.cord(id).positions()) {
        ASSERT_TRUE(ribbon::is_finite(x)) << k;
        ASSERT_LT(length(x), 40.0) << k;
      }
    }
  }
}

/// A winch at the first end lifts what hangs at the other one by as much as it winds up.
TEST(Pulleys, LetAWinchLift) {
  BodiesOverAWheel scene(10.0, 12.0);
  Cord& cord = scene.coupling.cord(scene.cord).direct();
  scene.coupling.cord(scene.cord).pin(0, cord.positions()[0]);
  scene.tick(30);
  const double before = scene.coupling.cord(scene.cord).positions().back().y;
  double part = 0.0;
  for (int link = 0; link < 20; ++link) part += cord.rest_length(link);
  cord.reel(0, 20, part - 0.5, 0.25);
  scene.tick(240);
  EXPECT_NEAR(scene.coupling.cord(scene.cord).positions().back().y - before, 0.5, 2e-3);
  EXPECT_EQ(scene.coupling.last_step().report().unconverged, 0);
}

TEST(Pulleys, HaveAnErrorEstimate) {
  BodiesOverAWheel scene;
  scene.coupling.estimate_errors(true);
  scene.tick(30);
  EXPECT_GT(scene.coupling.cord(scene.cord).error(), 0.0);
  EXPECT_LT(scene.coupling.cord(scene.cord).error(), 1e-3);
}

/// Bodies that stand on the cord beside a wheel, wind, and a wheel that moves.
TEST(Pulleys, RunOnAMovingBodyInTheWind) {
  ribbon::WeatherDef windy;
  windy.wind = {15.0, 0.0};
  const ribbon::Weather weather(windy);
  BodiesOverAWheel scene(10.0, 10.0);
  scene.coupling.remove(scene.cord);
  const ReevedCord reeved = ribbon::reeve({-0.25, 1.5}, {&scene.wheel, 1}, {0.25, 1.5}, 61);
  CordDef def;
  def.points = 61;
  def.length = reeved.length;
  def.positions = reeved.positions;
  def.drag_across = 1.2;
  const CordId cord = scene.coupling.add(Cord(def));
  b2Body* const crane = scene.add_body({0.0, 5.0}, 1.0, b2_kinematicBody);
  crane->SetLinearVelocity({0.0F, 0.2F});
  const PulleyId pulley = scene.coupling.add_pulley(cord, *crane, reeved.pulleys[0]);
  for (b2Body* const body : {scene.left, scene.right}) {
    scene.coupling.hold(*body, {.cord = cord, .arc = body == scene.left ? 0.0 : reeved.length});
  }
  scene.coupling.set_medium(&weather);
  scene.tick(120);
  EXPECT_EQ(scene.coupling.last_step().report().unconverged, 0);
  EXPECT_NEAR(scene.coupling.pulley(pulley).state().center.y, 5.4, 1e-3);
  for (const b2Body* const body : {scene.left, scene.right}) {
    EXPECT_NEAR(static_cast<double>(body->GetPosition().y), 1.9, 0.15);
  }
  EXPECT_NEAR(scene.coupling.pulley(pulley).state().tension_before / (10.0 * g), 1.0, 0.1);
}

TEST(Pulleys, RefuseWhatIsHeldOnAWheel) {
  BodiesOverAWheel scene;
  const PulleyDef wheel = scene.state().def;
  const auto arc = 0.5 * (wheel.before + wheel.after) * scene.coupling.cord(scene.cord).direct().rest_length(0);
  b2Body* const hand = scene.add_body({0.0, 5.25}, 1.0);
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.hold(*hand, {.cord = scene.cord, .arc = arc}); }),
                   "a grip is on a wheel of cord 0"));
  const CordId other = scene.coupling.add(Cord(hanging(3.0)));
  const ribbon::box2d::TieDef tie{scene.cord, wheel.before + 1, other, 3};
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.tie(tie); }), "a tie is on a wheel of cord 0"));
  scene.coupling.pulley(scene.pulley).remove();
  const auto grip = scene.coupling.hold(*hand, {.cord = scene.cord, .arc = arc});
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.add_pulley(scene.cord, *scene.wall, wheel); }),
                   "grip 3 is between points"));
  scene.coupling.grip(grip).release();
  scene.coupling.tie(tie);
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.add_pulley(scene.cord, *scene.wall, wheel); }),
                   "tie 1 is between points"));
  EXPECT_TRUE(pulleys_of(scene.coupling.cord(scene.cord).direct()).empty()) << "nothing was changed";
}

TEST(Pulleys, CannotBeDraggedWhereTheyAre) {
  BodiesOverAWheel scene;
  const PulleyDef wheel = scene.state().def;
  const ribbon::box2d::CordRef cord = scene.coupling.cord(scene.cord);
  ASSERT_GT(wheel.after - wheel.before, 2);
  for (int p = wheel.before + 1; p < wheel.after; ++p) {
    const std::string wanted = "point " + std::to_string(p) + " is on a wheel";
    EXPECT_TRUE(says(refusal<CallError>([&] { cord.drag(p, {0.0, 6.0}); }), wanted));
    EXPECT_TRUE(says(refusal<CallError>([&] { cord.pin(p, {0.0, 6.0}); }), wanted));
    EXPECT_EQ(cord.kind(p), ribbon::PointKind::free);
  }
  for (const int p : {wheel.before, wheel.after}) cord.drag(p, cord.positions()[static_cast<std::size_t>(p)]);
}

/// What nearest_point and nearest_place return can be held, wherever they are asked.
TEST(Pulleys, AreNotTheNearestPlace) {
  BodiesOverAWheel scene;
  b2Body* const hand = scene.add_body({0.0, 5.25}, 1.0);
  const PulleyDef wheel = scene.state().def;
  for (int k = 0; k < 64; ++k) {
    const double angle = 0.1 * k;
    const Vec2 at = wheel.center + 0.3 * Vec2{std::cos(angle), std::sin(angle)};
    const auto point = scene.coupling.nearest_point(at, 10.0);
    const auto place = scene.coupling.nearest_place(at, 10.0);
    ASSERT_TRUE(point && place);
    EXPECT_TRUE(point->point <= wheel.before || point->point >= wheel.after) << angle;
    EXPECT_LE(place->distance, point->distance);
    const double arc = scene.coupling.cord(scene.cord).arc(place->point, place->along);
    const auto grip = scene.coupling.hold(*hand, {.cord = scene.cord, .arc = arc});  // throws on a wheel
    scene.coupling.grip(grip).release();
  }
}

TEST(Pulleys, RefuseWhatCannotBe) {
  BodiesOverAWheel scene;
  const PulleyDef wheel = scene.state().def;
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.add_pulley(9, *scene.wall, wheel); }), "cord is 9"));
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.add_pulley(scene.cord, *scene.wall, wheel); }),
                   "are on another wheel"));
  const CordId thesis = scene.coupling.add(ribbon::ThesisCord({}));
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.add_pulley(thesis, *scene.wall, wheel); }), "thesis"));
  EXPECT_TRUE(
      says(refusal<DefinitionError>([&] { scene.coupling.pulley(1).set_motor(0.0, -1.0); }), "motor_torque is -1"));
  Cord reeved = test_support::Atwood{}.cord();
  EXPECT_EQ(refusal<CallError>([&] { scene.coupling.add(std::move(reeved)); }),
            "the cord has pulleys; accepted is one without, to which Coupling::add_pulley adds them");
  scene.coupling.gather(scene.world, dt);
  EXPECT_TRUE(says(refusal<CallError>([&] { scene.coupling.pulley(1).remove(); }), "between gather and apply"));
  scene.coupling.step();
  scene.coupling.apply();
  EXPECT_TRUE(scene.coupling.pulley(1).is_valid());
  EXPECT_TRUE(says(refusal_in_step<CallError>(scene, [&] { scene.coupling.pulley(1).remove(); }), "world is locked"));
  EXPECT_TRUE(scene.coupling.pulley(1).is_valid());
}

}  // namespace
}  // namespace engine
