#pragma once

#include <cstdint>
#include <variant>

#include "engine/scene/tiled_map.h"
#include "ribbon/cord_def.h"
#include "ribbon/thesis/thesis_def.h"

/// One cord of a map. Part of the scene; included by its sources only.
namespace engine {

/// By the solver that moves it.
using CordDefinition = std::variant<ribbon::ThesisDef, ribbon::CordDef>;

/// How many points a cord has, as its object says. Throws MapError where read_cord does for these numbers.
std::int64_t points_of(const MapObject& object);

/// Whether it meets fixtures that other cords of its game do not.
bool is_solid(const MapObject& object);

/// What a cord is made of, as its object says (engine/scene/scene.h has the properties). Throws MapError for a shape,
/// property or value that it cannot have; which values go together is left to the definition's own check.
CordDefinition read_cord(const MapObject& object);

}  // namespace engine
