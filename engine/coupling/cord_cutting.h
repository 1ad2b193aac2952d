#pragma once

#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/cut.h"

namespace ribbon::box2d {

/// Cuts an enabled cord of the direct solver: its pieces take its place, and what holds or touches it goes to its side.
/// Adds the event to the cut log. Throws CallError if the cord cannot be cut.
CutEvent cut_cord(CouplingParts& parts, CordId id, const CutPlace& where);

/// Cuts every enabled cord of the direct solver where its middle line crosses the segment from a to b [m].
void cut_along(CouplingParts& parts, Vec2 a, Vec2 b);

/// Cuts each cord at the link that is overloaded most, if one is.
void break_overloaded(CouplingParts& parts);

}  // namespace ribbon::box2d
