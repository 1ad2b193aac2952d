#pragma once

#include "ribbon/box2d/coupling_parts.h"

namespace ribbon::box2d {

/// Gives each cord the supports of the bodies that hold it, carry its wheels or may touch it. Where Box2D pressed
/// another dynamic body on one of these in the last world.Step, that body supports it too, and so do its own supports.
void gather_supports(CouplingParts& parts);

}  // namespace ribbon::box2d
