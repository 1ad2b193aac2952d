#pragma once

#include "engine/scene/tiled_map.h"
#include "ribbon/box2d/coupling.h"

namespace engine {

/// Replaces the definition of a cord with that of a map object while it moves. Positions, velocities, grips and
/// attached masses stay. Throws MapError, without a change, if the object cannot be built or has another solver or
/// other columns or rows, which need a new scene.
void retune(ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord, const MapObject& object);

/// Gives a cord, also one of a coupling, another definition with the same columns and rows while it moves: what it has,
/// as above, stays. Throws ribbon::DefinitionError, without a change, if the definition is not accepted.
/// @{
void retune(ribbon::Cord& cord, ribbon::CordDef def);
void retune(ribbon::ThesisCord& cord, const ribbon::ThesisDef& def);
/// @}

}  // namespace engine
