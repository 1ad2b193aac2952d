#include <utility>

#include "ribbon/box2d/convert.h"
#include "ribbon/geometry/rotation.h"
#include "tests/bits/bit_bodies.h"
#include "tests/bits/bit_builders.h"

// Cords alone, with contacts and asleep.

namespace bits {
namespace {

using ribbon::Accuracy;
using ribbon::Cord;
using ribbon::box2d::Coupling;

}  // namespace

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

}  // namespace bits
