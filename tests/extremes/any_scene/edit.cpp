#include "tests/extremes/any_scene/edit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/pulley.h"
#include "tests/extremes/any_scene/geometry.h"
#include "tests/support/slot.h"

namespace any_scene {

using ribbon::CordDef;
using ribbon::Vec2;

namespace {

using test_support::slot;

/// Erases the parts that refer to a removed thing, and decrements the indices of the parts behind it.
template <typename Part>
void forget(std::vector<Part>& parts, int Part::*field, int gone) {
  parts.erase(std::remove_if(parts.begin(), parts.end(), [&](const Part& part) { return part.*field == gone; }),
              parts.end());
  for (Part& part : parts) part.*field -= part.*field > gone ? 1 : 0;
}

/// Moves the given columns to the front and removes all others.
void keep_columns(SceneCord& cord, int first, int count) {
  CordDef& def = cord.def;
  def.length = def.length * (count - 1) / (def.points - 1);
  const auto begin = def.positions.begin() + first * def.rows;
  def.positions = std::vector<Vec2>(begin, begin + count * def.rows);
  std::vector<int> pins;
  for (const int pin : def.pins) {
    const int column = pin / def.rows - first;
    if (column >= 0 && column < count) pins.push_back(pin - first * def.rows);
  }
  def.pins = pins;
  def.points = count;
}

/// Shifts holds and drives of a cord to its new columns, and removes those of columns that it no longer has.
void shift_drives(Scene& scene, int cord, int first, double link) {
  const CordDef& def = scene.cords[slot(cord)].def;
  for (Hold& hold : scene.holds) {
    if (hold.cord != cord) continue;
    hold.arc -= first * link;
    if (hold.climb_to >= 0.0) hold.climb_to = std::clamp(hold.climb_to - first * link, 0.0, def.length);
  }
  scene.holds.erase(
      std::remove_if(scene.holds.begin(), scene.holds.end(),
                     [&](const Hold& hold) { return hold.cord == cord && (hold.arc < 0.0 || hold.arc > def.length); }),
      scene.holds.end());
  for (Drag& drag : scene.drags) {
    if (drag.cord == cord) drag.point -= first * def.rows;
  }
  scene.drags.erase(std::remove_if(scene.drags.begin(), scene.drags.end(),
                                   [&](const Drag& drag) {
                                     return drag.cord == cord &&
                                            (drag.point < 0 || drag.point >= def.points * def.rows);
                                   }),
                    scene.drags.end());
  for (Wheel& wheel : scene.wheels) {
    if (wheel.cord != cord) continue;
    wheel.def.before -= first;
    wheel.def.after -= first;
  }
  std::erase_if(scene.wheels, [&](const Wheel& wheel) {
    return wheel.cord == cord && (wheel.def.before < 0 || wheel.def.after >= def.points);
  });
  forget(scene.reels, &Reel::cord, cord);
  for (Reel& reel : scene.reels) reel.cord += reel.cord >= cord ? 1 : 0;
}

/// Rounds to multiples of 1/parts.
void round_to(double& value, double parts) { value = std::round(value * parts) / parts; }
void round_to(Vec2& value, double parts) {
  round_to(value.x, parts);
  round_to(value.y, parts);
}
/// Rounds to as many significant digits as `parts` has.
void round_digits(double& value, double parts) {
  if (!(value > 0.0) || std::isinf(value)) return;
  double scale = 1.0;
  while (value * scale < 1.0) scale *= 10.0;
  double large = 1.0;
  while (value >= 10.0 * large) large *= 10.0;
  value = std::round(value * scale / large * parts) * large / (parts * scale);
}

/// Straightens the cord, in the direction of its first link.
void straighten(SceneCord& cord) {
  CordDef& def = cord.def;
  const auto middle = [&](int i) {
    return 0.5 * (def.positions[slot(i * def.rows)] + def.positions[slot((i + 1) * def.rows - 1)]);
  };
  const Vec2 along = (def.length / (def.points - 1) / length(middle(1) - middle(0))) * (middle(1) - middle(0));
  for (int i = 1; i < def.points; ++i) {
    for (int j = 0; j < def.rows; ++j) def.positions[slot(i * def.rows + j)] = def.positions[slot(j)] + i * along;
  }
}

}  // namespace

void remove_cord(Scene& scene, int cord) {
  scene.cords.erase(scene.cords.begin() + cord);
  forget(scene.holds, &Hold::cord, cord);
  forget(scene.wheels, &Wheel::cord, cord);
  forget(scene.drags, &Drag::cord, cord);
  forget(scene.reels, &Reel::cord, cord);
}

void remove_solid(Scene& scene, int solid) {
  scene.solids.erase(scene.solids.begin() + solid);
  forget(scene.holds, &Hold::solid, solid);
  forget(scene.wheels, &Wheel::solid, solid);
}

void cut_cord(Scene& scene, int cord, int columns, bool front) {
  SceneCord& cut = scene.cords[slot(cord)];
  if (cut.def.points - columns < 3) return;
  const double link = cut.def.length / (cut.def.points - 1);
  const int first = front ? columns : 0;
  keep_columns(cut, first, cut.def.points - columns);
  shift_drives(scene, cord, first, link);
}

void halve_points(Scene& scene, int cord) {
  CordDef& def = scene.cords[slot(cord)].def;
  if (def.points < 5 || def.points % 2 == 0) return;
  const bool is_driven =
      std::any_of(scene.drags.begin(), scene.drags.end(), [&](const Drag& drag) { return drag.cord == cord; });
  const bool is_reeved =
      std::any_of(scene.wheels.begin(), scene.wheels.end(), [&](const Wheel& wheel) { return wheel.cord == cord; });
  if (is_driven || is_reeved) return;
  std::vector<Vec2> positions;
  for (int i = 0; i < def.points; i += 2) {
    for (int j = 0; j < def.rows; ++j) positions.push_back(def.positions[slot(i * def.rows + j)]);
  }
  std::vector<int> pins;
  for (const int pin : def.pins) {
    if (pin / def.rows % 2 == 0) pins.push_back(pin / def.rows / 2 * def.rows + pin % def.rows);
  }
  def.points = def.points / 2 + 1;
  def.positions = positions;
  def.pins = pins;
  forget(scene.reels, &Reel::cord, cord);
  for (Reel& reel : scene.reels) reel.cord += reel.cord >= cord ? 1 : 0;
}

Vec2 place_of(const Scene& scene, const Hold& hold) {
  const CordDef& def = scene.cords[slot(hold.cord)].def;
  const double column = std::clamp(hold.arc / def.length * (def.points - 1), 0.0, def.points - 1.0);
  const int i = std::min(static_cast<int>(column), def.points - 2);
  const Vec2 a = def.positions[slot(i * def.rows + hold.row)];
  const Vec2 b = def.positions[slot((i + 1) * def.rows + hold.row)];
  return a + (column - i) * (b - a);
}

void hold_again(Scene& scene) {
  for (Hold& hold : scene.holds) {
    hold.local_anchor = pose_of(scene.solids[slot(hold.solid)]).to_local(place_of(scene, hold));
  }
}

void drop_misfits(Scene& scene) {
  std::erase_if(scene.wheels, [&scene](const Wheel& wheel) {
    try {
      ribbon::Cord cord(scene.cords[slot(wheel.cord)].def);
      add_pulley(cord, wheel.def);
      return false;
    } catch (const ribbon::DefinitionError&) {
      return true;
    } catch (const ribbon::CallError&) {
      return true;
    }
  });
}

std::span<const CordEdit> term_edits() {
  static const std::array<CordEdit, 20> edits = {
      straighten,
      [](SceneCord& cord) { cord.velocity = {}; },
      [](SceneCord& cord) { cord.def.self_contact = false; },
      [](SceneCord& cord) { cord.def.cord_contact = false; },
      [](SceneCord& cord) { cord.def.pins.clear(); },
      [](SceneCord& cord) { cord.def.friction = 0.0; },
      [](SceneCord& cord) { cord.def.restitution = 0.0; },
      [](SceneCord& cord) { cord.def.damping = 0.0; },
      [](SceneCord& cord) { cord.def.drag = 0.0; },
      [](SceneCord& cord) { cord.def.gravity_scale = 1.0; },
      [](SceneCord& cord) { cord.def.drag_across = cord.def.drag_along = cord.def.displaced_area = 0.0; },
      [](SceneCord& cord) { cord.other_softness = false; },
      [](SceneCord& cord) { cord.def.tension_only = false; },
      [](SceneCord& cord) { cord.def.allow_sleep = false; },
      [](SceneCord& cord) { cord.def.poisson_ratio = 0.0; },
      [](SceneCord& cord) { cord.def.area_stiffness = 0.0; },
      [](SceneCord& cord) {
        if (cord.def.rows < 3) cord.def.bending_stiffness = 0.0;
      },
      [](SceneCord& cord) {
        if (cord.def.rows == 1) cord.def.stretch_stiffness = std::numeric_limits<double>::infinity();
      },
      [](SceneCord& cord) { cord.def.mass_per_length = 1.0; },
      [](SceneCord& cord) {
        if (cord.def.rows == 1) cord.def.radius = 0.01;
      },
  };
  return edits;
}

std::span<const SolidEdit> solid_edits() {
  static const std::array<SolidEdit, 8> edits = {
      [](Solid& solid) {
        if (solid.shape == Shape::circle) solid.half.y = Solid{}.half.y;
      },
      [](Solid& solid) { solid.velocity = {}; },
      [](Solid& solid) { solid.angular_velocity = 0.0; },
      [](Solid& solid) { solid.friction = 0.0; },
      [](Solid& solid) { solid.belt_speed = 0.0; },
      [](Solid& solid) { solid.restitution = 0.0; },
      [](Solid& solid) { solid.motion = Motion::fixed; },
      [](Solid& solid) { solid.angle = 0.0; },
  };
  return edits;
}

std::span<const HoldEdit> hold_edits() {
  static const std::array<HoldEdit, 3> edits = {
      [](Hold& hold) { hold.climb_to = -1.0; },
      [](Hold& hold) { hold.strength = std::numeric_limits<double>::infinity(); },
      [](Hold& hold) { hold.lets_go = false; },
  };
  return edits;
}

std::span<const WheelEdit> wheel_edits() {
  static const std::array<WheelEdit, 4> edits = {
      [](Wheel& wheel) { wheel.def.motor_torque = wheel.def.motor_speed = 0.0; },
      [](Wheel& wheel) { wheel.def.inertia = 0.0; },
      [](Wheel& wheel) { wheel.def.friction = std::numeric_limits<double>::infinity(); },
      [](Wheel& wheel) { wheel.def.friction = 0.0; },
  };
  return edits;
}

void round_cord(SceneCord& cord, double parts) {
  CordDef& def = cord.def;
  round_to(cord.velocity, parts);
  for (Vec2& x : def.positions) round_to(x, 100.0 * parts);
  for (double* value : {&def.length, &def.width, &def.radius, &def.mass_per_length, &def.stretch_stiffness,
                        &def.bending_stiffness, &def.damping, &def.drag, &def.gravity_scale, &def.drag_across,
                        &def.drag_along, &def.displaced_area, &def.friction, &def.restitution}) {
    round_digits(*value, parts);
  }
}

void round_wheel(Wheel& wheel, double parts) {
  for (double* value : {&wheel.def.inertia, &wheel.def.friction, &wheel.def.motor_torque}) round_digits(*value, parts);
  round_to(wheel.def.motor_speed, parts);
}

void round_solid(Solid& solid, double parts) {
  round_to(solid.velocity, parts);
  round_to(solid.position, parts);
  for (double* value : {&solid.half.x, &solid.half.y, &solid.density, &solid.friction, &solid.restitution}) {
    round_digits(*value, parts);
  }
  round_to(solid.angle, parts);
  round_to(solid.angular_velocity, parts);
}

}  // namespace any_scene
