#pragma once

#include <box2d/b2_draw.h>

#include "ribbon/box2d/coupling.h"

namespace ribbon::box2d {

/// Draws the cords of a coupling. Call it after b2World::DebugDraw. It draws what the flags of `draw` ask for, in the
/// colours that Box2D uses:
///
/// - e_shapeBit: the links of ropes and the outlines of ribbons, coloured as bodies that are awake, asleep or disabled,
///   and their points: pinned ones green as static bodies, dragged ones blue as kinematic bodies;
/// - e_jointBit: grips, from the origin of the body to its anchor and on to the place on the cord; wheels of pulleys,
///   each with a spoke;
/// - e_aabbBit: the boxes in which the last gather searched for fixtures;
/// - e_pairBit: the contacts of the last step, with normals of 0.3 m, of cords of the direct solver.
///
/// Disabled cords have neither boxes nor contacts. It changes nothing and allocates nothing, and may be called between
/// ticks and between the parts of a tick. Grips of bodies that were destroyed are left out: unless trust_forget was
/// called with true, it searches the list of bodies for each grip.
void debug_draw(const Coupling& coupling, b2Draw& draw);

}  // namespace ribbon::box2d
