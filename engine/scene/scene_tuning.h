#pragma once

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"

namespace engine {

/// Has a cord be made of what the object of a map says now, where it is and as it moves: places, velocities, who holds
/// it and what is attached stay, all else is as if it had been added so. Throws MapError, and changes nothing, for an
/// object that cannot be built, and for one of another solver or of other columns or rows: these need a new scene.
void retune(ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, const MapObject& object);

}  // namespace engine
