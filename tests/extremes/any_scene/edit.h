#pragma once

#include <span>

#include "tests/extremes/any_scene/scene.h"

namespace any_scene {

// Ways to make a scene smaller. Each leaves a scene that is whole: what refers to what is gone, goes.

void remove_cord(Scene& scene, int cord);
void remove_solid(Scene& scene, int solid);
/// Takes columns off a cord's end or front, with what holds or drives these. Nothing if fewer than three were left.
void cut_cord(Scene& scene, int cord, int columns, bool front);
/// Leaves out every other column, of an odd number of them.
void halve_points(Scene& scene, int cord);

/// m, the place of a hold on its cord at the start.
ribbon::Vec2 place_of(const Scene& scene, const Hold& hold);
/// Puts all hands where the cords are.
void hold_again(Scene& scene);

using CordEdit = void (*)(SceneCord& cord);
using SolidEdit = void (*)(Solid& solid);
using HoldEdit = void (*)(Hold& hold);
/// Each takes one term away.
std::span<const CordEdit> term_edits();
std::span<const SolidEdit> solid_edits();
std::span<const HoldEdit> hold_edits();

/// Rounds all numbers to multiples of 1/parts, of those with a scale (masses, stiffnesses) to as many digits.
void round_cord(SceneCord& cord, double parts);
void round_solid(Solid& solid, double parts);

}  // namespace any_scene
