#include <utility>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/geometry/rotation.h"
#include "tests/bits/bit_bodies.h"
#include "tests/bits/bit_builders.h"

// Cords that are held, tied, cut, blown at and laid around wheels.

namespace bits {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::box2d::Coupling;

/// Moves a grip to a point of another cord. Only a changed state can do that: a body that takes hold gets a new grip.
void move_to_cord(BitWorld& scene, ribbon::box2d::GripId grip, ribbon::box2d::CordId cord, int point) {
  Coupling::State state = scene.coupling.save(scene.world);
  for (Coupling::State::Grip& held : state.grips) {
    if (held.memory.id != grip) continue;
    held.memory.cord = cord;
    held.memory.point = point;
    held.memory.along = 0.0;
    held.memory.local_anchor = held.memory.next_anchor = {0.0F, 0.0F};
  }
  scene.coupling.restore(state, scene.world);
}

/// Makes a belt of all that stands still, and lets no second rope into the sensors.
struct Rules : ribbon::box2d::ContactListener {
  bool pre_solve(ribbon::box2d::CordId /*cord*/, const b2Fixture& fixture, ribbon::box2d::Surface& surface) override {
    if (fixture.GetBody()->GetType() == b2_staticBody) surface.tangent_speed = 1.5;
    return true;
  }
  bool wants_impulses() const override { return true; }
  bool should_meet_sensor(ribbon::box2d::CordId cord, const b2Fixture& /*sensor*/) override { return cord != 1; }
};
Rules rules;  // without a state

}  // namespace

/// Bodies that hold: single ones, between two points, with several grips, on two cords, climbing, slipping, torn off
/// and released; on ropes and a ribbon, one of them over a post.
void build_grips(BitWorld& scene) {
  CordDef rope = line({0.0, 0.0}, {0.0, -0.2}, 26);
  rope.pins = {0};
  CordDef other = line({2.0, 0.0}, {0.0, -0.2}, 26);
  other.pins = {0};
  other.bending_stiffness = 0.1;
  CordDef sail = strip({5.0, 0.0}, {0.1, 0.0}, 15, 2, 0.1);
  for (const CordDef& def : {rope, other, sail}) scene.coupling.add(Cord(def));
  Coupling& coupling = scene.coupling;
  coupling.hold(0, 25, add_holder(scene, {0.0, -5.1}, 0.3), {0.0F, 0.1F});
  b2Body& between = add_holder(scene, {1.0, -3.0}, 0.2);
  coupling.hold(between, {.cord = 0, .arc = 3.03, .local_anchor = {-0.9F, 0.0F}});
  coupling.hold(between, {.cord = 1, .arc = 2.51, .local_anchor = {0.9F, 0.0F}});
  b2Body& climber = add_holder(scene, {2.0, -4.4}, 0.25);
  coupling.grip(coupling.hold(climber, {.cord = 1, .arc = 4.33})).climb(3.4, 0.8);
  coupling.hold(add_holder(scene, {2.1, -1.0}, 0.1), {.cord = 1, .arc = 1.0, .strength = 3.0});
  b2Body& left = add_holder(scene, {5.0, 0.0}, 0.1);
  b2Body& right = add_holder(scene, {6.4, 0.1}, 0.1);
  coupling.hold(left, {.cord = 2, .arc = 0.0});
  coupling.hold(left, {.cord = 2, .arc = 0.1, .row = 1, .local_anchor = {0.1F, 0.1F}});
  coupling.hold(right, {.cord = 2, .arc = 1.35, .row = 1});
  coupling.hold(add_holder(scene, {5.7, 0.3}, 0.2), {.cord = 2, .arc = 0.7, .strength = 60.0, .lets_go = true});
  add_circle(scene, {5.6, -1.0}, 0.3, b2_staticBody);
}

void drive_grips(BitWorld& scene, int tick) {
  b2Body& swinger = body(scene.world, 0);
  if (tick < 60) swinger.ApplyLinearImpulseToCenter({0.5F, 0.0F}, true);
  if (tick == 70) scene.coupling.grip(1).move_anchor({0.05F, 0.2F});
  if (tick == 100) scene.coupling.body(swinger).release();
  if (tick == 120) move_to_cord(scene, 2, 1, 25);
}

/// A net of 5 × 5 ropes catches a ball, and other ropes are tied while apart, untied, and torn from each other.
void build_ties(BitWorld& scene) {
  constexpr int n = 5;
  for (int k = 0; k < 2 * n; ++k) {
    CordDef rope = k < n ? line({0.0, -0.3 * k}, {0.15, 0.0}, 9) : line({0.3 * (k - n), 0.0}, {0.0, -0.15}, 9);
    rope.radius = 0.02;
    rope.friction = 0.4;
    rope.cord_contact = true;
    if (k == 0) rope.pins = {0, 8};
    scene.coupling.add(Cord(rope));
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) scene.coupling.tie({i, 2 * j, n + j, 2 * i});
  }
  add_circle(scene, {0.5, 0.5}, 0.2);
  CordDef left = line({3.0, 0.0}, {0.0, -0.1}, 16);
  left.pins = {0};
  left.bending_stiffness = 0.01;
  CordDef right = line({3.6, 0.0}, {0.0, -0.1}, 16);
  right.pins = {0};
  right.stretch_stiffness = 1e4;
  for (const CordDef& def : {left, right}) scene.coupling.add(Cord(def));
  scene.coupling.tie({10, 15, 11, 15});
  scene.coupling.hold(11, 8, add_holder(scene, {3.6, -0.8}, 2.0), {0.0F, 0.0F});
}

void drive_ties(BitWorld& scene, int tick) {
  if (tick < 30) scene.coupling.cord(0).drag(8, {1.2 - 0.01 * tick, 0.0});
  if (tick == 60) scene.coupling.tie(26).untie();
  if (tick == 80) scene.coupling.tie({10, 15, 11, 10, 12.0});
}

/// Ropes and ribbons of all elements, with weak links, that are cut across, along rows and by a blade.
void build_cuts(BitWorld& scene) {
  CordDef rope = line({0.0, 0.0}, {0.0, -0.1}, 21);
  rope.pins = {0};
  rope.radius = 0.02;
  rope.self_contact = true;
  scene.coupling.add(Cord(rope));
  scene.coupling.hold(0, 20, add_holder(scene, {0.0, -2.0}, 0.2), {0.0F, 0.0F});
  CordDef solid = strip({0.5, 0.0}, {0.0, -0.1}, 16, 5, 0.4);
  CordDef soft = strip({1.5, 0.0}, {0.0, -0.1}, 16, 4, 0.3);
  soft.bending_stiffness *= 0.05;
  soft.damping = 0.01;
  soft.self_contact = true;
  CordDef bars = line({2.5, 0.0}, {0.0, -0.1}, 16, 3, 0.2);
  bars.elements = ribbon::Elements::bars;
  bars.stretch_stiffness = 2e3;
  bars.breaking_force = 50.0;
  for (CordDef* def : {&solid, &soft, &bars}) {
    for (int j = 0; j < def->rows; ++j) def->pins.push_back(j);
    def->radius = 0.01;
    def->friction = 0.3;
    def->cord_contact = true;
    scene.coupling.add(Cord(*def));
  }
  scene.coupling.hold(1, 15 * 5 + 4, add_holder(scene, {0.9, -1.5}, 0.2), {0.0F, 0.0F});
  scene.coupling.hold(2, 15 * 4, add_holder(scene, {1.5, -1.5}, 0.2), {0.0F, 0.0F});
  scene.coupling.hold(3, 15 * 3 + 1, add_holder(scene, {2.6, -1.5}, 0.3), {0.0F, 0.0F});
  scene.coupling.tie({0, 10, 1, 7 * 5});
  add_box(scene, {1.0, -3.0}, 4.0F, 0.2F, b2_staticBody);
}

void drive_cuts(BitWorld& scene, int tick) {
  const auto cut = [&](ribbon::box2d::CordId id, auto&& how) {
    if (scene.coupling.cord(id).is_valid()) how(scene.coupling.cord(id));
  };
  if (tick == 10) cut(1, [](auto cord) { cord.cut_along(2); });
  if (tick == 20) cut(2, [](auto cord) { cord.cut_along(1); });
  if (tick == 30) scene.world.SetGravity({0.0F, -40.0F});
  if (tick == 32) scene.world.SetGravity({0.0F, -9.81F});
  if (tick == 40) scene.coupling.cut({-1.0, -1.0}, {4.0, -1.3});
  if (tick == 60) cut(0, [](auto cord) { cord.cut(0.5); });
}

/// Belts carry ropes, with a ball on one of them, through sensors that stand and move.
void build_listener(BitWorld& scene) {
  scene.coupling.listen(&rules);
  add_box(scene, {0.0, -0.5}, 4.0F, 0.5F, b2_staticBody);
  add_circle(scene, {5.5, -1.5}, 0.8, b2_staticBody);
  for (int k = 0; k < 3; ++k) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.radius = 0.03;
    def.friction = 0.5;
    if (k == 2) def.accuracy = Accuracy::fast();
    for (int i = 0; i < def.points; ++i) def.positions.push_back({-3.0 + 1.5 * k + 0.1 * i, 0.3 + 0.02 * i});
    scene.coupling.add(Cord(def));
  }
  add_circle(scene, {-2.6, 0.8}, 0.2);
  add_box(scene, {1.0, 0.2}, 0.3F, 0.3F, b2_staticBody).GetFixtureList()->SetSensor(true);
  b2Body& moving = add_circle(scene, {3.0, 0.2}, 0.4, b2_kinematicBody);
  moving.GetFixtureList()->SetSensor(true);
  moving.SetLinearVelocity({-1.0F, 0.0F});
}

/// Cords in gusts above a river: held, tied, floating, and against a ball.
void build_wind(BitWorld& scene) {
  ribbon::WeatherDef weather;
  weather.wind = {9.0, 0.7};
  weather.gusts = 0.6;
  weather.water_level = -1.0;
  weather.current = {-0.8, 0.0};
  scene.weather.emplace(weather);
  scene.coupling.set_medium(&*scene.weather);
  const auto feeling = [](CordDef def) {
    def.drag_across = 1.2;
    def.drag_along = 0.02;
    def.displaced_area = 3e-4;
    return def;
  };
  CordDef flag = feeling(line({0.0, 0.0}, {0.0, -0.1}, 16));
  flag.pins = {0};
  CordDef loaded = feeling(line({1.0, 0.0}, {0.1, 0.0}, 16));
  loaded.pins = {0};
  loaded.bending_stiffness = 0.01;
  CordDef floating = feeling(line({-2.0, -0.6}, {0.1, 0.0}, 16));
  floating.mass_per_length = 0.15;
  floating.accuracy = Accuracy::fast();
  CordDef sail = feeling(line({4.0, 0.5}, {0.0, -0.1}, 11, 3, 0.2));
  sail.stretch_stiffness = 1e4;
  sail.bending_stiffness = 1.0;
  sail.pins = {0, 1, 2};
  for (const CordDef& def : {flag, loaded, floating, sail}) scene.coupling.add(Cord(def));
  scene.coupling.hold(1, 15, add_holder(scene, {2.5, 0.0}, 0.1), {0.0F, 0.0F});
  add_circle(scene, {0.3, -0.8}, 0.2, b2_staticBody);
}

void drive_wind(BitWorld& scene, int tick) {
  if (tick == 30) scene.coupling.tie({0, 10, 1, 5});
  if (tick == 70) scene.coupling.set_medium(nullptr);
  if (tick == 80) scene.coupling.set_medium(&*scene.weather);
}

/// Cords over wheels: one that slips and one that a motor turns, and a block that a cord carries.
void build_pulleys(BitWorld& scene) {
  b2Body& wall = add_box(scene, {0.0, 4.0}, 0.1F, 0.1F, b2_staticBody);
  const auto lay = [](Vec2 first, const std::vector<ribbon::PulleyDef>& wheels, Vec2 last) {
    const ribbon::ReevedCord reeved = ribbon::reeve(first, wheels, last, 61);
    CordDef def;
    def.points = 61;
    def.length = reeved.length;
    def.positions = reeved.positions;
    def.mass_per_length = 0.02;
    return std::pair(reeved, def);
  };
  for (const double x : {0.0, 2.0}) {
    ribbon::PulleyDef wheel{.center = {x, 3.0}, .radius = 0.3, .counterclockwise = false, .turns = 1, .inertia = 0.2};
    if (x == 0.0) wheel.friction = 0.1;
    if (x == 2.0) wheel.motor_torque = 9.0;
    auto [reeved, def] = lay({x - 0.3, 0.0}, {wheel}, {x + 0.3, 0.5});
    if (x == 0.0) def.accuracy = Accuracy::fast();
    const ribbon::box2d::CordId cord = scene.coupling.add(Cord(def));
    scene.coupling.add_pulley(cord, wall, reeved.pulleys[0]);
    scene.coupling.hold(cord, 0, add_holder(scene, {x - 0.3, 0.0}, 0.1), {0.0F, 0.0F});
    scene.coupling.hold(cord, 60, add_holder(scene, {x + 0.3, 0.5}, 0.2), {0.0F, 0.0F});
  }
  const std::vector<ribbon::PulleyDef> wheels{{.center = {4.0, 3.0}, .radius = 0.2, .counterclockwise = false},
                                              {.center = {4.5, 0.5}, .radius = 0.3, .inertia = 0.01}};
  auto [reeved, def] = lay({3.8, 1.0}, wheels, {4.8, 2.8});
  def.pins = {60};
  def.stretch_stiffness = 1e4;
  def.damping = 0.01;
  const ribbon::box2d::CordId cord = scene.coupling.add(Cord(def));
  b2Body& block = add_holder(scene, {4.5, 0.5}, 0.25);
  scene.coupling.add_pulley(cord, wall, reeved.pulleys[0]);
  scene.coupling.add_pulley(cord, block, reeved.pulleys[1]);
  scene.coupling.hold(cord, 0, add_holder(scene, {3.8, 1.0}, 0.2), {0.0F, 0.0F});
}

void drive_pulleys(BitWorld& scene, int tick) {
  if (tick == 30) scene.coupling.pulley(2).set_motor(3.0, 40.0);
  if (tick == 80) scene.coupling.cord(0).cut(1.0);
  if (tick == 90) scene.coupling.pulley(1).remove();
}

}  // namespace bits
