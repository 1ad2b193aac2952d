#pragma once

#include "ribbon/box2d/coupling_parts.h"

// Coupling::step, solver by solver.

namespace ribbon::box2d {

/// Advances the cords of the thesis's solver.
void step_thesis(CouplingParts& parts);
/// Advances the cords of the direct solver. Returns whether one of them may be asleep.
bool step_direct(CouplingParts& parts);

}  // namespace ribbon::box2d
