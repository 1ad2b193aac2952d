#pragma once

#include <box2d/box2d.h>

#include "engine/scene/tiled_map.h"

/// The bodies of a map. Part of the scene; included by its sources only. Each of these makes the body of an object as
/// engine/scene/scene.h says, and throws MapError for a shape, property or value that it cannot have.
namespace engine {

b2Body& build_ground(const MapObject& object, b2World& world);
b2Body& build_circle(const MapObject& object, b2World& world);
b2Body& build_load(const MapObject& object, b2World& world);

}  // namespace engine
