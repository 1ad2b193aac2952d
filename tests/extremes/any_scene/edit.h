#pragma once

#include <span>

#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

// Edits that make a scene smaller. Each one leaves a valid scene: it also removes references to what it removes.

void remove_cord(Scene& scene, int cord);
void remove_solid(Scene& scene, int solid);
/// Removes columns and their holds, wheels and drives from an end of a cord. Does nothing if fewer than three would
/// remain.
void cut_cord(Scene& scene, int cord, int columns, bool front);
/// Removes every other column of a cord with an odd number of columns and no wheels.
void halve_points(Scene& scene, int cord);

/// Returns the place of a hold on its cord at the start, m.
ribbon::Vec2 place_of(const Scene& scene, const Hold& hold);
/// Moves all holding solids to the cords that they hold.
void hold_again(Scene& scene);
/// Removes the wheels whose cord no longer lies around them.
void drop_misfits(Scene& scene);

using CordEdit = void (*)(SceneCord& cord);
using SolidEdit = void (*)(Solid& solid);
using HoldEdit = void (*)(Hold& hold);
using WheelEdit = void (*)(Wheel& wheel);
/// Returns the edits that each switch off one term.
std::span<const CordEdit> term_edits();
std::span<const SolidEdit> solid_edits();
std::span<const HoldEdit> hold_edits();
std::span<const WheelEdit> wheel_edits();

/// Rounds lengths to multiples of 1/parts, and masses and stiffnesses to as many significant digits.
void round_cord(SceneCord& cord, double parts);
void round_solid(Solid& solid, double parts);
void round_wheel(Wheel& wheel, double parts);

}  // namespace any_scene
