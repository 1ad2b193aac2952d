#pragma once

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"

namespace engine {

/// Replaces the definition of a cord with that of a map object while it moves. Positions, velocities, grips and
/// attached masses stay. Throws MapError, without a change, if the object cannot be built or has another solver or
/// other columns or rows, which need a new scene.
void retune(ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, const MapObject& object);

}  // namespace engine
