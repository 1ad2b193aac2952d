#include "tests/extremes/any_scene/reeving.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ribbon/definition.h"

namespace any_scene {

using ribbon::CordDef;
using ribbon::PulleyDef;
using ribbon::Vec2;

namespace {

constexpr int reeving_tries = 300;

/// The wheels and the ends of a rope that runs up on the left of a wheel on a wall, and down on the left of a block.
struct Layout {
  std::vector<PulleyDef> wheels;
  int block = -1;  // index of the wheel that hangs in the rope; −1 if none does
  Vec2 first;      // m
  Vec2 last;
  bool first_pinned = false;
  bool last_pinned = false;
};

/// Rounds to a number that Box2D holds exactly, so that the rope has its length at the start.
Vec2 rounded(Vec2 v) { return {std::round(v.x * 1024.0) / 1024.0, std::round(v.y * 1024.0) / 1024.0}; }

PulleyDef some_wheel(Dice& dice, Vec2 center, double radius, bool block) {
  PulleyDef wheel;
  wheel.center = rounded(center);
  wheel.radius = radius;
  wheel.counterclockwise = block;
  const double mass = log_uniform(dice, 0.05, 5.0);
  if (dice.coin()) wheel.inertia = 0.5 * mass * radius * radius;
  if (chance(dice, 0.6)) wheel.friction = dice(0.0, 0.4);
  if (chance(dice, 0.1)) wheel.turns = random_integer(dice, 1, 2);
  if (chance(dice, 0.15)) wheel.motor_torque = log_uniform(dice, 0.5, 50.0);  // a brake
  return wheel;
}

Layout some_layout(Dice& dice) {
  Layout layout;
  const int wheels = random_integer(dice, 1, 3);
  if (dice.coin()) layout.block = wheels / 2;
  const double top = dice(3.5, 7.0);
  double x = dice(-5.0, 3.0);
  double radius = dice(0.12, 0.4);
  for (int k = 0; k < wheels; ++k) {
    const bool hangs = k == layout.block;
    const double y = hangs ? top - dice(1.5, 3.0) : top + dice(-0.4, 0.4);
    layout.wheels.push_back(some_wheel(dice, {x, y}, radius, hangs));
    const double next = dice(0.12, 0.4);
    const bool next_to_block = hangs || k + 1 == layout.block;
    x += radius + next + (next_to_block ? dice(0.0, 0.4) : dice(0.3, 1.5));
    radius = next;
  }
  const auto end = [&](int k, double side) {
    const PulleyDef& wheel = layout.wheels[static_cast<std::size_t>(k)];
    const double y = k == layout.block ? top + dice(-0.5, 0.5) : wheel.center.y - dice(0.8, 2.5);
    return Vec2{wheel.center.x + side * (wheel.radius + dice(0.0, 0.4)), y};
  };
  layout.first = end(0, -1.0);
  layout.last = end(wheels - 1, 1.0);
  // A rope that is pinned at both ends and has no block is too taut for its weight.
  const bool may_be_pinned = chance(dice, 0.2);
  layout.last_pinned = layout.block == wheels - 1 || may_be_pinned;
  layout.first_pinned = layout.block == 0;
  return layout;
}

CordDef some_rope(Dice& dice, const Layout& layout) {
  double smallest = layout.wheels[0].radius;
  for (const PulleyDef& wheel : layout.wheels) smallest = std::min(smallest, wheel.radius);
  CordDef def;
  def.radius = dice(0.01, 0.03);
  const double link = std::max(dice(0.25, 0.6) * smallest, def.radius / 0.45);
  const double length = ribbon::reeve(layout.first, layout.wheels, layout.last, 1000).length;
  def.points = std::clamp(static_cast<int>(length / link) + 1, 12, 250);
  def.mass_per_length = log_uniform(dice, 0.02, 0.5);
  if (dice.coin()) def.stretch_stiffness = log_uniform(dice, 1e4, 1e6);
  def.tension_only = chance(dice, 0.4);
  if (dice.coin()) def.friction = dice();
  if (chance(dice, 0.3)) def.damping = log_uniform(dice, 1e-3, 0.1);
  if (chance(dice, 0.2)) def.drag = dice(0.1, 2.0);
  def.self_contact = dice.coin();
  def.cord_contact = chance(dice, 0.7);
  if (layout.first_pinned) def.pins.push_back(0);
  if (layout.last_pinned) def.pins.push_back(def.points - 1);
  return def;
}

/// Returns a dynamic solid of a mass [kg].
Solid weight(Shape shape, Vec2 half, double mass) {
  Solid solid;
  solid.motion = Motion::dynamic;
  solid.shape = shape;
  solid.half = half;
  solid.density = mass / (shape == Shape::circle ? std::numbers::pi * half.x * half.x : 4.0 * half.x * half.y);
  return solid;
}

Solid some_load(Dice& dice, double mass) {
  const Shape shape = dice.coin() ? Shape::circle : Shape::box;
  const double x = dice(0.08, 0.2);
  Solid load = weight(shape, {x, dice(0.08, 0.2)}, mass);
  load.friction = dice();
  return load;
}

/// Adds what carries a wheel: a circle within its groove, half of them as large as the groove lets them be. That of a
/// block hangs a little below the axle or not.
bool add_carrier(Dice& dice, Scene& scene, const Layout& layout, std::size_t k, double mass) {
  const PulleyDef& wheel = layout.wheels[k];
  const double room = wheel.radius - scene.cords.back().def.radius;
  const double half = std::min(0.98, dice(0.3, 1.66)) * room;
  Solid solid;
  if (static_cast<int>(k) == layout.block) {
    solid = weight(Shape::circle, {half, half}, mass);
    if (dice.coin()) solid.position.y = -dice(0.0, std::max(0.0, 0.8 * room - half));
  } else {
    solid.half = {half, half};
  }
  solid.friction = dice();
  solid.position = rounded(wheel.center + solid.position);
  if (!Placer(scene).is_clear(solid)) return false;
  scene.wheels.push_back({static_cast<int>(scene.cords.size()) - 1, static_cast<int>(scene.solids.size()), wheel});
  scene.solids.push_back(solid);
  return true;
}

/// Adds a rope in a layout to a scene. Returns false if there is no room.
bool add_rope(Dice& dice, Layout& layout, Scene& scene) {
  CordDef def = some_rope(dice, layout);
  ribbon::ReevedCord reeved = ribbon::reeve(layout.first, layout.wheels, layout.last, def.points);
  layout.wheels = reeved.pulleys;
  def.length = reeved.length;
  def.positions = reeved.positions;
  if (!Placer(scene).is_clear(def, def.positions)) return false;
  scene.cords.push_back({def, {}});
  const double load = log_uniform(dice, 1.0, 10.0);  // kg
  for (std::size_t k = 0; k < layout.wheels.size(); ++k) {
    if (!add_carrier(dice, scene, layout, k, 2.0 * load * dice(0.6, 1.6))) return false;
  }
  const int cord = static_cast<int>(scene.cords.size()) - 1;
  if (!layout.first_pinned && !Placer(scene).add_load(some_load(dice, load), cord, false)) return false;
  return layout.last_pinned || Placer(scene).add_load(some_load(dice, load * dice(0.6, 1.6)), cord, true);
}

}  // namespace

bool add_reeved_rope(Dice& dice, Scene& scene) {
  for (int k = 0; k < reeving_tries; ++k) {
    Scene with_rope = scene;
    Layout layout = some_layout(dice);
    try {
      if (!add_rope(dice, layout, with_rope)) continue;
    } catch (const ribbon::DefinitionError&) {  // wheels overlap, or two are too near for the points
      continue;
    }
    scene = with_rope;
    return true;
  }
  return false;
}

void add_motors(Dice& dice, Scene& scene) {
  for (Wheel& wheel : scene.wheels) {
    const double speed = dice(-10.0, 10.0);
    const double torque = log_uniform(dice, 1.0, 300.0);
    if (chance(dice, 0.7)) continue;
    wheel.def.motor_speed = speed;
    wheel.def.motor_torque = torque;
  }
}

bool is_reeved(const Scene& scene, int cord) {
  return std::any_of(scene.wheels.begin(), scene.wheels.end(),
                     [cord](const Wheel& wheel) { return wheel.cord == cord; });
}

void add_a_cut_or_a_knot(Dice& dice, Scene& scene) {
  if (chance(dice, 0.1)) {
    const double cord = 0.999 * dice();
    scene.cuts.push_back({random_integer(dice, 20, 200), cord, dice(0.01, 0.99), dice.coin()});
  }
  if (chance(dice, 0.1)) {
    const double cord = 0.999 * dice();
    scene.knots.push_back({random_integer(dice, 0, 200), cord, 0.999 * dice()});
  }
}

void clear_wheels(Scene& scene) {
  std::erase_if(scene.holds, [&scene](const Hold& hold) {
    const CordDef& def = scene.cords[static_cast<std::size_t>(hold.cord)].def;
    return is_on_wheel(scene, hold.cord, hold.arc / def.length * (def.points - 1));
  });
}

}  // namespace any_scene
