#include "tests/extremes/any_scene/wild.h"

#include <algorithm>

#include "tests/support/slot.h"

namespace any_scene {

using ribbon::CordDef;
using ribbon::Vec2;

namespace {

using test_support::slot;

constexpr int calm_ticks = 120;

int some_cord(Dice& dice, const Scene& scene) {
  return random_integer(dice, 0, static_cast<int>(scene.cords.size()) - 1);
}

Vec2 some_vector(Dice& dice, double least, double most) {
  const double size = log_uniform(dice, least, most);
  return size * direction(dice);
}

/// Adds solids that overlap cords.
void overlap(Dice& dice, Scene& scene) {
  for (int k = random_integer(dice, 1, 3); k > 0; --k) {
    const CordDef& def = scene.cords[slot(some_cord(dice, scene))].def;
    Solid solid;
    solid.motion = dice.coin() ? Motion::dynamic : Motion::fixed;
    solid.shape = dice.coin() ? Shape::circle : Shape::box;
    solid.half = {dice(0.1, 0.4), dice(0.1, 0.4)};
    solid.angle = solid.shape == Shape::box ? dice(-1.5, 1.5) : 0.0;
    solid.density = log_uniform(dice, 1.0, 1000.0);
    solid.position = def.positions[slot(random_integer(dice, 0, def.points * def.rows - 1))];
    solid.position += some_vector(dice, 0.01, 0.5);
    scene.solids.push_back(solid);
  }
}

Solid kinematic(Dice& dice, Vec2 position) {
  Solid solid;
  solid.motion = Motion::kinematic;
  solid.shape = dice.coin() ? Shape::circle : Shape::box;
  solid.half = {dice(0.1, 0.6), dice(0.1, 0.6)};
  solid.friction = dice();
  solid.position = position;
  solid.velocity = some_vector(dice, 0.1, 10.0);
  if (dice.coin()) solid.angular_velocity = dice(-10.0, 10.0);
  return solid;
}

/// Adds a kinematic solid that moves towards a cord.
void sweep(Dice& dice, Scene& scene) {
  const CordDef& def = scene.cords[slot(some_cord(dice, scene))].def;
  const Vec2 target = def.positions[slot(random_integer(dice, 0, def.points * def.rows - 1))];
  const Vec2 from = some_vector(dice, 0.5, 3.0);
  Solid solid = kinematic(dice, target + from);
  solid.velocity = (-length(solid.velocity) / length(from)) * from;
  scene.solids.push_back(solid);
}

/// Adds a kinematic body that holds a cord and moves, even if the cord is pinned.
void pull(Dice& dice, Scene& scene) {
  const int cord = some_cord(dice, scene);
  CordDef& def = scene.cords[slot(cord)].def;
  if (dice.coin() && def.pins.empty()) def.pins.push_back(0);
  const int column = random_integer(dice, 1, def.points - 1);
  Hold hold;
  hold.solid = static_cast<int>(scene.solids.size());
  hold.cord = cord;
  hold.arc = def.length * column / (def.points - 1);
  scene.solids.push_back(kinematic(dice, def.positions[slot(column * def.rows)]));
  scene.holds.push_back(hold);
}

void drag(Dice& dice, Scene& scene) {
  Drag drag;
  drag.cord = some_cord(dice, scene);
  const CordDef& def = scene.cords[slot(drag.cord)].def;
  drag.point = random_integer(dice, 0, def.points * def.rows - 1);
  if (std::find(def.pins.begin(), def.pins.end(), drag.point) != def.pins.end()) return;
  drag.from_tick = random_integer(dice, 0, 60);
  drag.speed = log_uniform(dice, 0.5, 30.0);
  for (int k = random_integer(dice, 1, 5); k > 0; --k) {
    const double x = dice(-6.0, 6.0);
    drag.path.push_back({x, dice(-3.0, 6.0)});
  }
  scene.drags.push_back(drag);
}

void reel(Dice& dice, Scene& scene) {
  Reel reel;
  reel.cord = some_cord(dice, scene);
  const CordDef& def = scene.cords[slot(reel.cord)].def;
  reel.first = random_integer(dice, 0, def.points - 2);
  reel.last = random_integer(dice, reel.first + 1, def.points - 1);
  reel.from_tick = random_integer(dice, 0, 60);
  reel.length = def.length * (reel.last - reel.first) / (def.points - 1) * log_uniform(dice, 0.1, 4.0);
  reel.speed = log_uniform(dice, 0.1, 10.0);
  scene.reels.push_back(reel);
}

void climb(Dice& dice, Scene& scene) {
  for (Hold& hold : scene.holds) {
    hold.climb_to = dice() * scene.cords[slot(hold.cord)].def.length;
    hold.climb_speed = log_uniform(dice, 0.1, 5.0);
  }
}

void hurl(Dice& dice, Scene& scene) {
  for (SceneCord& cord : scene.cords) {
    if (dice.coin()) cord.velocity = some_vector(dice, 1.0, 100.0);
  }
  for (Solid& solid : scene.solids) {
    if (solid.motion != Motion::dynamic || dice.coin()) continue;
    solid.velocity = some_vector(dice, 1.0, 100.0);
    solid.angular_velocity = dice(-30.0, 30.0);
  }
}

}  // namespace

void make_wild(Dice& dice, Scene& scene) {
  scene.calm_ticks = calm_ticks;
  for (int k = random_integer(dice, 1, 3); k > 0; --k) {
    switch (random_integer(dice, 0, 6)) {
      case 0: overlap(dice, scene); break;
      case 1: sweep(dice, scene); break;
      case 2: pull(dice, scene); break;
      case 3: drag(dice, scene); break;
      case 4: reel(dice, scene); break;
      case 5: climb(dice, scene); break;
      default: hurl(dice, scene);
    }
  }
}

}  // namespace any_scene
