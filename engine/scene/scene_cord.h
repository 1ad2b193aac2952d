#pragma once

#include <cstdint>
#include <variant>

#include "engine/scene/tiled_map.h"
#include "ribbon/cord_def.h"
#include "ribbon/thesis/thesis_def.h"

/// Reads one cord of a map; private to the scene.
namespace engine {

/// The definition for the thesis's solver or the direct solver.
using CordDefinition = std::variant<ribbon::ThesisDef, ribbon::CordDef>;

/// Returns the number of points of a cord, columns × rows. Throws MapError if columns, rows or solver are not accepted.
std::int64_t points_of(const MapObject& object);

/// Returns whether the cord collides with all fixtures, whatever the cord filter.
bool is_solid(const MapObject& object);

/// Reads the definition of a cord; engine/scene/scene.h describes the properties. Throws MapError for a shape, property
/// or value that is not accepted. The constructor of the cord checks combinations of values.
CordDefinition read_cord(const MapObject& object);

}  // namespace engine
