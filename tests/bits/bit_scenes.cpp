#include "tests/bits/bit_scenes.h"

#include <array>
#include <utility>
#include <vector>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/geometry/rotation.h"

namespace bits {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;
using ribbon::box2d::Coupling;
using ribbon::box2d::to_float;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// --- bodies ----------------------------------------------------------------------------------------------------------

b2Body& add_body(BitWorld& scene, const b2Shape& shape, Vec2 position, b2BodyType type, float restitution = 0.1F) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = to_float(position);
  definition.angularDamping = 0.1F;
  b2Body* body = scene.world.CreateBody(&definition);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 20.0F;
  fixture.friction = 0.4F;
  fixture.restitution = restitution;
  body->CreateFixture(&fixture);
  return *body;
}

b2Body& add_circle(BitWorld& scene, Vec2 position, double radius, b2BodyType type = b2_dynamicBody) {
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(radius);
  return add_body(scene, circle, position, type);
}

b2Body& add_box(BitWorld& scene, Vec2 position, float half_width, float half_height, b2BodyType type = b2_dynamicBody) {
  b2PolygonShape box;
  box.SetAsBox(half_width, half_height);
  return add_body(scene, box, position, type);
}

/// Adds a body that only holds cords.
b2Body& add_holder(BitWorld& scene, Vec2 position, double radius) {
  b2Body& body = add_circle(scene, position, radius);
  b2Filter none;
  none.maskBits = 0;
  body.GetFixtureList()->SetFilterData(none);
  return body;
}

// --- cords -----------------------------------------------------------------------------------------------------------

/// A cord of `points` columns on a straight line from `from` with the distance `step`, and `rows` rows across.
CordDef line(Vec2 from, Vec2 step, int points, int rows = 1, double width = 0.0) {
  CordDef def;
  def.points = points;
  def.rows = rows;
  def.length = length(step) * (points - 1);
  def.width = width;
  const Vec2 across = rows > 1 ? (width / ((rows - 1) * length(step))) * perp(step) : Vec2{};
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < rows; ++j) def.positions.push_back(from + static_cast<double>(i) * step + j * across);
  }
  return def;
}

/// E = 0.2 MPa, ν = 0.2, 5 cm thick.
CordDef strip(Vec2 from, Vec2 step, int points, int rows, double width) {
  CordDef def = line(from, step, points, rows, width);
  ribbon::solid(2e5, 0.2, 0.05, width).apply_to(def);
  return def;
}

// --- scenes ----------------------------------------------------------------------------------------------------------

/// Bars only, eliminated point by point: inextensible, elastic and damped, light and heavy loads, a reel, a dragged
/// point.
void build_ropes(BitWorld& scene) {
  CordDef stiff = line({0.0, 0.0}, {0.2, 0.0}, 31);
  stiff.pins = {0};
  CordDef elastic = line({0.0, 5.0}, {0.16, 0.12}, 31);
  elastic.pins = {0};
  elastic.stretch_stiffness = 1e5;
  elastic.damping = 0.002;
  elastic.drag = 0.1;
  for (const CordDef& def : {stiff, elastic}) {
    Cord cord(def);
    cord.attach_mass(30, 70.0);
    scene.coupling.add(std::move(cord));
  }
}

void drive_ropes(BitWorld& scene, int tick) {
  if (tick == 20) scene.coupling.cord(0).direct().reel(5, 25, 2.0, 1.5);
  if (tick == 60) scene.coupling.cord(1).direct().set_load(15, {30.0, 10.0});
  if (tick >= 80 && tick < 100) scene.coupling.cord(1).drag(10, {1.0 + 0.01 * tick, 4.0});
  if (tick == 100) scene.coupling.cord(1).free(10);
  if (tick == 110) scene.coupling.cord(0).free(0);
}

/// Bending and links that only pull, as a band; the presets beside each other.
void build_terms(BitWorld& scene) {
  CordDef bending = line({0.0, 0.0}, {0.1, 0.0}, 31);
  bending.bending_stiffness = 0.5;
  bending.pins = {0, 1};
  bending.accuracy = Accuracy::accurate();
  CordDef slack = line({0.0, 2.0}, {0.1, 0.0}, 21);
  slack.tension_only = true;
  slack.stretch_stiffness = 1e6;
  slack.pins = {0, 20};
  for (std::size_t p = 1; p < 20; ++p) slack.positions[p] = {0.08 * static_cast<double>(p), 2.0};
  slack.positions[20] = {1.6, 2.0};
  CordDef plain = line({0.0, 4.0}, {0.1, 0.0}, 21);
  plain.accuracy = Accuracy::fast();
  plain.pins = {10};
  for (const CordDef& def : {bending, slack, plain}) scene.coupling.add(Cord(def));
}

/// Ribbons of cells, with a spine and without, crushed at the start so that cells turn back; and one of bars.
void build_ribbons(BitWorld& scene) {
  CordDef crushed = strip({0.0, 0.0}, {0.1, 0.0}, 12, 3, 0.2);
  crushed.area_stiffness = 1.0;
  crushed.bending_stiffness *= 0.5;
  crushed.pins = {0};
  for (int p = 0; p < 36; ++p) crushed.positions[at(p)] = {0.05 * ((7 * p) % 11), 0.05 * ((5 * p) % 13)};
  CordDef narrow = strip({0.0, 4.0}, {0.1, 0.0}, 21, 2, 0.1);
  narrow.pins = {0, 1};
  narrow.damping = 0.01;
  CordDef bars = line({4.0, 4.0}, {0.1, 0.0}, 15, 3, 0.2);
  bars.elements = ribbon::Elements::bars;
  bars.stretch_stiffness = 1e4;
  bars.pins = {0, 1, 2};
  for (const CordDef& def : {crushed, narrow, bars}) scene.coupling.add(Cord(def));
  scene.coupling.cord(1).direct().attach_mass(41, 2.0);
}

/// Balls, a box and a cord's own end on a bridge, posts and ground below it, friction and restitution.
void build_contacts(BitWorld& scene) {
  CordDef bridge = line({0.0, 0.0}, {0.1, 0.0}, 41);
  bridge.radius = 0.02;
  bridge.friction = 0.5;
  bridge.restitution = 0.2;
  bridge.pins = {0, 40};
  for (std::size_t p = 0; p <= 40; ++p) {
    const double x = 0.1 * static_cast<double>(p) - 2.0;
    bridge.positions[p] = {x, 0.05 * x * x};  // its links are too long, and contract in the first tick
  }
  scene.coupling.add(Cord(bridge));
  CordDef falling = line({-1.5, 1.5}, {0.1, 0.02}, 31);
  falling.friction = 0.3;
  falling.bending_stiffness = 0.02;
  scene.coupling.add(Cord(falling));
  for (int k = 0; k < 4; ++k) add_circle(scene, {-1.2 + 0.7 * k, 0.8 + 0.3 * k}, 0.12 + 0.03 * k);
  add_box(scene, {0.4, 2.4}, 0.15F, 0.1F).SetAngularVelocity(1.0F);
  add_circle(scene, {-0.5, -0.9}, 0.2, b2_staticBody);
  add_box(scene, {0.0, -2.0}, 4.0F, 0.2F, b2_staticBody);
  b2EdgeShape edge;
  edge.SetTwoSided({-3.0F, -1.8F}, {-1.5F, -1.2F});
  add_body(scene, edge, {}, b2_staticBody);
  add_circle(scene, {0.9, -1.2}, 0.15, b2_kinematicBody).SetLinearVelocity({-0.3F, 0.1F});
}

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

void drive_grips(BitWorld& scene, int tick) {
  b2Body& swinger = body(scene.world, 0);
  if (tick < 60) swinger.ApplyLinearImpulseToCenter({0.5F, 0.0F}, true);
  if (tick == 70) scene.coupling.grip(1).move_anchor({0.05F, 0.2F});
  if (tick == 100) scene.coupling.body(swinger).release();
  if (tick == 120) move_to_cord(scene, 2, 1, 25);
}

/// A rope that falls into a pile on itself, ribbons on one another and a ball that joins them.
void build_self_contact(BitWorld& scene) {
  CordDef pile = line({0.0, 0.1}, {0.01, 0.06}, 21);
  pile.self_contact = true;
  pile.cord_contact = true;
  pile.radius = 0.02;
  pile.friction = 0.3;
  scene.coupling.add(Cord(pile));
  for (int k = 0; k < 2; ++k) {
    CordDef ribbon = strip({-0.4, 1.6 + 0.2 * k}, {0.06, 0.012 * (2 * k - 1)}, 13, 2, 0.03);
    ribbon.area_stiffness = 1.0;
    ribbon.self_contact = k == 0;
    ribbon.cord_contact = true;
    ribbon.radius = 0.01;
    ribbon.friction = 0.2;
    ribbon.accuracy = k == 1 ? Accuracy::fast() : Accuracy::balanced();
    scene.coupling.add(Cord(ribbon));
  }
  add_circle(scene, {0.0, 2.2}, 0.15);
  add_box(scene, {0.0, -0.2}, 2.0F, 0.2F, b2_staticBody);
  add_box(scene, {-0.7, 0.5}, 0.1F, 0.8F, b2_staticBody);
  add_box(scene, {0.9, 0.5}, 0.1F, 0.8F, b2_staticBody);
}

/// The thesis's method with all its features, beside a cord of the direct solver: circles, a holder of each cord, and a
/// dragged point.
void build_thesis(BitWorld& scene) {
  for (int k = 0; k < 2; ++k) {
    ribbon::ThesisDef def;
    def.w = 14;
    def.h = 2 + k;
    def.self_collision = true;
    def.area_stiffness = 0.2;
    def.substeps = 8;
    for (int i = 0; i < def.w; ++i) {
      for (int j = 0; j < def.h; ++j) {
        def.positions.push_back({1.5 * k + def.spacing * i, def.spacing * (j - (i % 3 == 0 ? 0.1 : 0.0))});
      }
    }
    def.pins = {0, 1};
    scene.coupling.add(ribbon::ThesisCord(def));
  }
  CordDef direct = line({0.0, -0.8}, {0.1, 0.0}, 21);
  direct.pins = {0, 20};
  scene.coupling.add(Cord(direct));
  for (int k = 0; k < 5; ++k) add_circle(scene, {0.1 + 0.4 * k, 0.4 + 0.1 * k}, 0.06 + 0.01 * k);
  add_circle(scene, {0.4, -0.4}, 0.1, b2_staticBody);
  scene.coupling.hold(1, 39, add_holder(scene, {2.2, 0.0}, 0.1), {0.0F, 0.0F});
  scene.coupling.hold(2, 10, add_holder(scene, {1.0, -0.9}, 0.1), {0.0F, 0.1F});
}

void drive_thesis(BitWorld& scene, int tick) {
  if (tick >= 40 && tick < 80) scene.coupling.cord(0).drag(27, {0.7 - 0.005 * tick, -0.2});
  if (tick == 80) scene.coupling.cord(0).free(27);
  if (tick == 90) scene.coupling.cord(1).free(0);
}

/// Motions that a step cannot resolve: a point that is yanked, one that is dragged beyond the cord's length, a whip, a
/// load that is added and removed, cords that start with penetration. They need guards, searches, fallbacks, halvings.
void build_rough(BitWorld& scene) {
  CordDef yanked = line({0.0, 0.0}, {0.1, 0.0}, 21);
  CordDef elastic = line({0.0, 1.0}, {0.1, 0.0}, 21);
  elastic.stretch_stiffness = 200.0;
  elastic.bending_stiffness = 0.01;
  CordDef ribbon = strip({0.0, 2.0}, {0.1, 0.0}, 12, 3, 0.2);
  ribbon.area_stiffness = 1.0;
  ribbon.pins = {0};
  for (const CordDef& def : {yanked, elastic, ribbon}) scene.coupling.add(Cord(def));
  add_circle(scene, {1.02, -0.1}, 0.12, b2_staticBody);
  add_circle(scene, {0.5, 1.0}, 0.1);  // starts on the cord
}

void drive_rough(BitWorld& scene, int tick) {
  Coupling& coupling = scene.coupling;
  const double back_and_forth = tick % 8 < 4 ? 1.0 : -1.0;
  if (tick < 60) coupling.cord(0).drag(0, {1.2 * back_and_forth, 0.4 * (tick % 5)});
  if (tick == 30) coupling.cord(0).drag(20, {9.0, 0.0});
  if (tick == 40) coupling.cord(0).free(20);
  if (tick == 60) coupling.cord(0).free(0);
  if (tick % 20 == 5) coupling.cord(1).direct().attach_mass(20, tick % 40 == 5 ? 1e4 : 0.0);
  if (tick < 40) coupling.cord(1).drag(0, {0.0, 1.0 + 0.5 * back_and_forth});
  if (tick % 30 == 10) coupling.cord(2).direct().set_velocity(35, {60.0 * back_and_forth, 80.0});
}

/// A lamp on a rope and a ball in a hammock fall asleep and are woken: by an impact, a reel, a removed hammock.
void build_asleep(BitWorld& scene) {
  CordDef rope = line({0.0, 0.0}, {0.0, -0.1}, 21);
  rope.pins = {0};
  rope.stretch_stiffness = 1e4;
  CordDef hammock = line({2.0, 0.0}, {0.095, 0.0}, 21);
  hammock.length = 2.0;
  hammock.pins = {0, 20};
  hammock.bending_stiffness = 0.05;
  hammock.stretch_stiffness = 1e4;
  hammock.friction = 0.5;
  hammock.cord_contact = true;
  for (CordDef* def : {&rope, &hammock}) {
    def->radius = 0.02;
    def->damping = 0.1;
    def->drag = 4.0;
    def->allow_sleep = true;
    scene.coupling.add(Cord(*def));
  }
  scene.coupling.hold(0, 20, add_holder(scene, {0.0, -2.1}, 0.1), {0.0F, 0.1F});
  add_circle(scene, {2.95, 0.15}, 0.1).SetAngularDamping(5.0F);
}

void drive_asleep(BitWorld& scene, int tick) {
  if (tick == 150) body(scene.world, 0).ApplyLinearImpulseToCenter({0.2F, 0.0F}, true);
  if (tick == 170) scene.coupling.cord(1).set_enabled(false);
  if (tick == 175) scene.coupling.cord(1).set_enabled(true);
  if (tick == 190) scene.coupling.cord(0).direct().reel(0, 20, 1.5, 1.0);
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

constexpr std::array<BitScene, 14> scenes = {{
    {"ropes", build_ropes, drive_ropes, 180, 0x2313949e21ff234e},
    {"terms", build_terms, nullptr, 180, 0xa84ca44769a0bde1},
    {"ribbons", build_ribbons, nullptr, 180, 0xa39e4165796867ab},
    {"contacts", build_contacts, nullptr, 150, 0x47de701ab44ac2ee},
    {"grips", build_grips, drive_grips, 180, 0x93df58580d9e85ed},
    {"self_contact", build_self_contact, nullptr, 80, 0xdff90a10bddb5cb3},
    {"thesis", build_thesis, drive_thesis, 180, 0xcbffe2fca1a6f43d},
    {"rough", build_rough, drive_rough, 120, 0x8c54bd8b178fcf40},
    {"asleep", build_asleep, drive_asleep, 220, 0x92f1a7f546f39269},
    {"ties", build_ties, drive_ties, 120, 0x2edbc8fa88533871},
    {"cuts", build_cuts, drive_cuts, 100, 0x49714b874bd5ea9f},
    {"listener", build_listener, nullptr, 180, 0x175560bdcdb73aef},
    {"pulleys", build_pulleys, drive_pulleys, 120, 0x717ed5c667e562b0},
    {"wind", build_wind, drive_wind, 150, 0xf09d88afaacb4248},
}};

}  // namespace

void PrintTo(const BitScene& scene, std::ostream* out) { *out << scene.name; }

std::span<const BitScene> bit_scenes() { return scenes; }

b2Body& body(b2World& world, int n) {
  b2Body* found = world.GetBodyList();  // the newest
  for (int k = world.GetBodyCount() - 1; k > n; --k) found = found->GetNext();
  return *found;
}

void tick(const BitScene& scene, BitWorld& world, int number) {
  if (scene.drive != nullptr) scene.drive(world, number);
  world.coupling.tick(world.world, dt);
}

std::uint64_t hash_of(const Coupling& coupling, const b2World& world) {
  ribbon::box2d::Hasher hasher;
  add_to(hasher, coupling.save(world));
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    const b2Transform& transform = body->GetTransform();
    for (const float value : {transform.p.x, transform.p.y, transform.q.s, transform.q.c, body->GetAngle(),
                              body->GetLinearVelocity().x, body->GetLinearVelocity().y, body->GetAngularVelocity()}) {
      hasher.add(value);
    }
    hasher.add(body->IsAwake());
    hasher.add(coupling.body(*body).velocity());
  }
  return hasher.value();
}

std::uint64_t hash_of_run(const BitScene& scene) {
  BitWorld world;
  scene.build(world);
  ribbon::box2d::Hasher all;
  for (int k = 0; k < scene.ticks; ++k) {
    tick(scene, world, k);
    all.add(hash_of(world.coupling, world.world));
  }
  return all.value();
}

}  // namespace bits
