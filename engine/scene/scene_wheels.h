#pragma once

#include <vector>

#include "engine/scene/tiled_map.h"
#include "ribbon/cord_def.h"
#include "ribbon/pulley.h"

/// Reads the wheels of a map; private to the scene.
namespace engine {

/// A wheel that a rope of the map runs around.
struct WheelDefinition {
  const MapObject* object = nullptr;
  ribbon::PulleyDef pulley;
  double disc_radius = 0.0;  ///< m, of what fits in the groove under the cord
};

/// Returns the wheels that name the cord, in the order in which it runs around them, and lays the cord taut around
/// them: `def` gets its length and positions. The cord's polyline has a corner at each wheel and no other one between
/// its ends. engine/scene/scene.h describes the properties. Throws MapError for a shape, property or value that is not
/// accepted, and for a cord that cannot run around its wheels.
std::vector<WheelDefinition> reeve_around_wheels(const MapObject& cord, const TiledMap& map, ribbon::CordDef& def);

/// Returns whether a wheel names the cord.
bool has_wheels(const MapObject& cord, const TiledMap& map);

}  // namespace engine
