#include "tests/extremes/any_scene/generate.h"

#include <algorithm>
#include <cmath>

#include "tests/extremes/any_scene/placement.h"
#include "tests/extremes/any_scene/reeving.h"
#include "tests/extremes/any_scene/wild.h"

namespace any_scene {

using ribbon::CordDef;
using ribbon::Vec2;

namespace {

constexpr Vec2 cords_low{-5.0, 0.0};  // m, range of the cords' first points
constexpr Vec2 cords_high{5.0, 6.0};
constexpr Vec2 scenery_low{-6.0, -3.0};
constexpr Vec2 scenery_high{6.0, 2.0};
constexpr Vec2 bodies_low{-6.0, -2.5};
constexpr Vec2 bodies_high{6.0, 7.0};
constexpr double ground = -4.0;  // m
constexpr Vec2 pit_low{-2.2, -3.0};
constexpr Vec2 pit_high{1.6, 7.0};

/// What a family prescribes; all else is random.
struct Recipe {
  int min_cords = 1;
  int max_cords = 1;
  bool ribbons = false;
  bool self_contact = false;
  bool cord_contact = false;
  int min_bodies = 0;
  int max_bodies = 3;
  int holders = 0;
  bool between = false;
  bool slips = false;
};

Recipe recipe_of(Family family, Dice& dice) {
  switch (family) {
    case Family::rope_falls: return {};
    case Family::rope_self: return {1, 1, false, true};
    case Family::ropes_mutual: return {3, 3, false, false, true};
    case Family::ropes_both: return {3, 3, false, true, true};
    case Family::hold_points: return {1, 1, false, false, false, 5, 5, 2};
    case Family::hold_between: return {1, 1, false, false, false, 5, 5, 2, true};
    case Family::grips_slip: return {1, 1, false, false, false, 2, 5, 2, true, true};
    case Family::ribbon_falls: return {1, 1, true};
    case Family::ribbons_both: return {1, 3, true, true, true};
    case Family::heap: return {8, 16, false, true, true, 0, 4};
    case Family::heap_held: return {8, 16, false, true, true, 3, 6, 3, dice.coin(), dice.coin()};
    case Family::tied:
      return {2, 5, false, dice.coin(), dice.coin(), 0, 8, random_integer(dice, 0, 3), dice.coin(), chance(dice, 0.3)};
    case Family::reeved:
      return {0, 2, false, false, false, 0, 6, random_integer(dice, 0, 2), dice.coin(), chance(dice, 0.3)};
    default: break;
  }
  return {1, 4, false, dice.coin(), dice.coin(), 0, 8, random_integer(dice, 0, 3), dice.coin(), chance(dice, 0.3)};
}

void set_ribbon(Dice& dice, CordDef& def, bool may_be_bars) {
  def.rows = random_integer(dice, 2, 4);
  def.points = random_integer(dice, 9, 31);
  const double link = def.length / (def.points - 1);
  const double across = link * dice(0.3, 1.0);
  def.width = across * (def.rows - 1);
  def.radius = std::min(def.radius, 0.45 * across);
  // Lower bound: the speed of sound exceeds the speed of fall, 55 m/s.
  def.stretch_stiffness = log_uniform(dice, std::max(1e3, 3e3 * def.mass_per_length), 1e6);
  def.bending_stiffness = 0.0;
  def.tension_only = false;
  if (may_be_bars && chance(dice, 0.15)) {
    def.elements = ribbon::Elements::bars;
    return;
  }
  const double solid = def.stretch_stiffness * def.width * def.width / 12.0;
  const double most = std::min(10.0, solid);
  if (def.rows > 2 || dice.coin()) def.bending_stiffness = log_uniform(dice, std::min(1e-2, 0.1 * most), most);
  if (dice.coin()) def.poisson_ratio = dice(0.0, 0.4);
  if (dice.coin() || !may_be_bars) def.area_stiffness = 1.0;  // against inversion
}

CordDef some_cord(Dice& dice, const Recipe& recipe, bool mixed) {
  CordDef def;
  def.points = random_integer(dice, 9, 61);
  def.length = dice(2.0, 8.0);
  const double link = def.length / (def.points - 1);
  def.radius = dice(0.01, std::min(0.06, 0.45 * link));
  def.mass_per_length = log_uniform(dice, 0.03, 10.0);
  if (dice.coin()) def.stretch_stiffness = log_uniform(dice, 316.0, 1e6);
  if (dice.coin()) def.bending_stiffness = log_uniform(dice, 1e-2, 10.0);
  def.tension_only = chance(dice, 0.2);
  if (dice.coin()) def.friction = dice();
  if (chance(dice, 0.25)) def.restitution = dice(0.1, 0.9);
  if (chance(dice, 0.3)) def.damping = log_uniform(dice, 1e-3, 0.1);
  if (chance(dice, 0.2)) def.drag = dice(0.1, 2.0);
  def.self_contact = mixed ? dice.coin() : recipe.self_contact;
  def.cord_contact = mixed ? chance(dice, 0.7) : recipe.cord_contact;
  def.allow_sleep = mixed && chance(dice, 0.2);
  if (recipe.ribbons || (mixed && chance(dice, 0.25))) set_ribbon(dice, def, mixed);
  if (chance(dice, 0.4)) {
    for (int j = 0; j < def.rows; ++j) def.pins.push_back(j);
    const bool both = chance(dice, 0.4);
    for (int j = 0; both && j < def.rows; ++j) def.pins.push_back((def.points - 1) * def.rows + j);
  }
  return def;
}

CordDef cord_of_heap(Dice& dice) {
  CordDef def;
  def.points = random_integer(dice, 9, 31);
  def.length = dice(0.8, 2.0);
  const double link = def.length / (def.points - 1);
  def.radius = std::min(0.02, dice(0.2, 0.45) * link);
  def.mass_per_length = log_uniform(dice, 0.03, 3.0);
  if (dice.coin()) def.stretch_stiffness = log_uniform(dice, 1e3, 1e6);
  if (dice.coin()) def.bending_stiffness = log_uniform(dice, 1e-3, 1.0);
  def.friction = dice();
  def.self_contact = def.cord_contact = true;
  if (chance(dice, 0.4)) set_ribbon(dice, def, false);
  return def;
}

/// Adds a ground and two walls.
void add_pit(Dice& dice, Scene& scene) {
  const double friction = dice();
  for (const Vec2 side : {Vec2{-3.0, 0.0}, Vec2{0.0, -1.0}, Vec2{3.0, 0.0}}) {
    Solid solid;
    solid.shape = Shape::box;
    solid.half = side.x == 0.0 ? Vec2{4.0, 0.5} : Vec2{0.5, 12.0};
    solid.position = {side.x, side.x == 0.0 ? ground - 0.5 : ground + 12.0};
    solid.friction = friction;
    scene.solids.push_back(solid);
  }
}

Solid some_solid(Dice& dice, Motion motion) {
  Solid solid;
  solid.motion = motion;
  solid.shape = dice.coin() ? Shape::circle : Shape::box;
  solid.half = {dice(0.1, 0.6), dice(0.1, 0.6)};
  if (solid.shape == Shape::box) solid.angle = dice(-1.5, 1.5);
  if (motion == Motion::dynamic) solid.density = log_uniform(dice, 1.0, 1000.0);
  solid.friction = dice();
  if (chance(dice, 0.2)) solid.restitution = dice(0.1, 0.8);
  return solid;
}

Solid some_ground(Dice& dice) {
  Solid solid;
  solid.shape = dice.coin() ? Shape::edge : Shape::box;
  solid.half = {40.0, solid.shape == Shape::box ? 0.5 : 0.0};
  solid.position = {0.0, ground - solid.half.y};
  solid.friction = dice();
  return solid;
}

/// Moves the last bodies, none before the solid `first`, to cords and lets them hold these.
void add_holders(Dice& dice, const Recipe& recipe, int first, Scene& scene) {
  Placer placer(scene);
  std::vector<int> free;
  for (int k = first; k < static_cast<int>(scene.solids.size()); ++k) {
    if (scene.solids[static_cast<std::size_t>(k)].motion == Motion::dynamic) free.push_back(k);
  }
  for (int held = 0; held < recipe.holders && !free.empty(); ++held) {
    for (int k = 0; k < 60; ++k) {
      const int cord = random_integer(dice, 0, static_cast<int>(scene.cords.size()) - 1);
      const CordDef& def = scene.cords[static_cast<std::size_t>(cord)].def;
      double column = random_integer(dice, 0, def.points - 1);
      if (recipe.between) column = dice(0.0, def.points - 1.0);
      Hold hold;
      if (recipe.slips) hold.strength = log_uniform(dice, 1.0, 300.0);
      hold.lets_go = recipe.slips && chance(dice, 0.2);
      if (is_reeved(scene, cord)) continue;  // it has its loads
      if (!placer.place_holder(dice, free.back(), cord, column * def.length / (def.points - 1), hold)) continue;
      scene.holds.push_back(hold);
      free.pop_back();
      break;
    }
  }
}

void add_scenery(Dice& dice, Placer& placer, Scene& scene) {
  if (chance(dice, 0.7)) scene.solids.push_back(some_ground(dice));
  for (int k = random_integer(dice, 1, 6); k > 0; --k) {
    placer.add_solid(dice, some_solid(dice, Motion::fixed), scenery_low, scenery_high);
  }
}

/// Varies what was added to the library later. It has dice of its own, so all else of a scene stays as it was.
void vary_cords(Dice dice, Scene& scene) {
  for (SceneCord& cord : scene.cords) {
    if (chance(dice, 0.25)) cord.def.gravity_scale = dice(-1.0, 3.0);
    cord.other_softness = chance(dice, 0.15);
  }
}

/// Every tenth tick a cord is cut, or a link of it breaks. Some ropes break above a force of their own.
void add_cuts(Dice& dice, Scene& scene) {
  for (SceneCord& cord : scene.cords) {
    if (cord.def.rows == 1 && dice.coin()) cord.def.breaking_force = log_uniform(dice, 3.0, 3e3);
  }
  for (int tick = 9; tick < scene.ticks; tick += 10) {
    const double cord = 0.999 * dice();
    scene.cuts.push_back({tick, cord, dice(0.01, 0.99), dice.coin()});
  }
}

/// Ribbons are cut along rows too, and some break above a force of their own.
void vary_cuts(Dice dice, Scene& scene) {
  for (SceneCord& cord : scene.cords) {
    if (cord.def.rows > 1 && dice.coin()) cord.def.breaking_force = log_uniform(dice, 3.0, 3e3);
  }
  for (Cut& cut : scene.cuts) cut.along = dice.coin();
}

/// Two ties in every tenth tick, one at the start, and every fifth of them is an untying.
void add_knots(Dice& dice, Scene& scene) {
  for (int tick = 0; tick < scene.ticks; tick += 10) {
    for (int k = 0; k < 2; ++k) {
      const double cord = 0.999 * dice();
      scene.knots.push_back({tick, cord, 0.999 * dice(), tick > 0 && chance(dice, 0.2)});
    }
  }
}

/// Belts of 0.1 to 30 m/s in both directions.
void add_belts(Dice& dice, Scene& scene) {
  for (Solid& solid : scene.solids) {
    const double speed = log_uniform(dice, 0.1, 30.0);
    const bool runs = dice.coin();
    if (runs) solid.belt_speed = dice.coin() ? speed : -speed;
  }
}

void fill_pit(Dice& dice, const Recipe& recipe, Placer& placer) {
  for (int k = random_integer(dice, recipe.min_cords, recipe.max_cords); k > 0; --k) {
    placer.add_cord(dice, cord_of_heap(dice), pit_low, pit_high);
  }
  for (int k = random_integer(dice, recipe.min_bodies, recipe.max_bodies); k > 0; --k) {
    placer.add_solid(dice, some_solid(dice, Motion::dynamic), pit_low, pit_high);
  }
}

void add_cords_and_bodies(Dice& dice, const Recipe& recipe, bool mixed, Placer& placer) {
  for (int k = random_integer(dice, recipe.min_cords, recipe.max_cords); k > 0; --k) {
    const CordDef def = some_cord(dice, recipe, mixed);
    // If a hundred tries find no free place, search higher up.
    if (!placer.add_cord(dice, def, cords_low, cords_high)) placer.add_cord(dice, def, {-5.0, 9.0}, {5.0, 30.0});
  }
  for (int k = random_integer(dice, recipe.min_bodies, recipe.max_bodies); k > 0; --k) {
    placer.add_solid(dice, some_solid(dice, Motion::dynamic), bodies_low, bodies_high);
  }
}

}  // namespace

std::string_view name(Family family) {
  constexpr std::string_view names[] = {"rope_falls",   "rope_self",    "ropes_mutual", "ropes_both",
                                        "hold_points",  "hold_between", "grips_slip",   "ribbon_falls",
                                        "ribbons_both", "mixed",        "heap",         "heap_held",
                                        "cut",          "tied",         "belts",        "reeved"};
  return names[static_cast<std::size_t>(family)];
}

std::string_view name(Difficulty difficulty) { return difficulty == Difficulty::gentle ? "gentle" : "wild"; }

Scene generate(const SceneId& which) {
  Dice dice(which.seed * 32U + static_cast<unsigned>(which.family) * 2U + static_cast<unsigned>(which.difficulty) +
            12345U);
  const bool mixed = which.family == Family::mixed || which.family == Family::cut || which.family == Family::tied ||
                     which.family == Family::belts || which.family == Family::reeved;
  const Recipe recipe = recipe_of(which.family, dice);
  Scene scene;
  scene.preset = which.preset.value_or(static_cast<Preset>(which.seed % 3));
  scene.sleeping = mixed && dice.coin();
  Placer placer(scene);
  if (which.family == Family::reeved) {
    for (int k = random_integer(dice, 1, 2); k > 0; --k) add_reeved_rope(dice, scene);
  }
  const int reeved = static_cast<int>(scene.solids.size());
  const bool heap = which.family == Family::heap || which.family == Family::heap_held;
  if (heap) {
    add_pit(dice, scene);
  } else {
    add_scenery(dice, placer, scene);
  }
  if (heap) {
    fill_pit(dice, recipe, placer);
  } else {
    add_cords_and_bodies(dice, recipe, mixed, placer);
  }
  add_holders(dice, recipe, reeved, scene);
  if (mixed) vary_cords(Dice(which.seed), scene);
  if (which.difficulty == Difficulty::wild) make_wild(dice, scene);
  if (which.family == Family::cut || which.family == Family::tied) {
    add_cuts(dice, scene);
    vary_cuts(Dice(which.seed), scene);
  }
  if (which.family == Family::tied) add_knots(dice, scene);
  if (which.family == Family::belts) add_belts(dice, scene);
  if (which.family == Family::reeved) add_a_cut_or_a_knot(dice, scene);
  if (which.family == Family::reeved && which.difficulty == Difficulty::wild) {
    add_motors(dice, scene);
    clear_wheels(scene);
  }
  return scene;
}

}  // namespace any_scene
