#pragma once

#include <box2d/box2d.h>

#include "engine/scene/tiled_map.h"

/// Builds the bodies of a map; private to the scene. engine/scene/scene.h describes the objects. All functions throw
/// MapError for a shape, property or value that is not accepted.
namespace engine {

b2Body& build_ground(const MapObject& object, b2World& world);
b2Body& build_circle(const MapObject& object, b2World& world);
b2Body& build_load(const MapObject& object, b2World& world);

}  // namespace engine
