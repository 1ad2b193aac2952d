#pragma once

#include "tests/extremes/any_scene/placement.h"

namespace any_scene {

/// Adds a rope around one to three wheels: on walls, or one of them on a block that hangs in the rope. Each end is
/// pinned or carries a load. Nothing overlaps. Returns false if it finds no place.
bool add_reeved_rope(Dice& dice, Scene& scene);

/// Returns whether the cord runs around a wheel.
bool is_reeved(const Scene& scene, int cord);

/// Gives some scenes one cut or one tie.
void add_a_cut_or_a_knot(Dice& dice, Scene& scene);
/// Gives some wheels motors.
void add_motors(Dice& dice, Scene& scene);
/// Removes what holds a cord on a wheel: that is refused.
void clear_wheels(Scene& scene);

}  // namespace any_scene
