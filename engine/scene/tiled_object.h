#pragma once

#include <string>

#include "engine/files/json_object.h"
#include "engine/scene/tiled_map.h"
#include "engine/scene/tiled_properties.h"
#include "ribbon/vec2.h"

/// Reads one object of a Tiled map; private to the loader.
namespace engine {

/// Converts pixels of the map, y down, to metres of the world, y up. The only place of this conversion.
struct TiledFrame {
  double height_px = 0.0;
  double pixels_per_metre = 64.0;

  /// Returns the point at offset `local_px` (y up, already rotated) from a map point (y down).
  ribbon::Vec2 to_world(ribbon::Vec2 map_px, ribbon::Vec2 local_px = {}) const {
    return {(map_px.x + local_px.x) / pixels_per_metre, (height_px - map_px.y + local_px.y) / pixels_per_metre};
  }
};

/// Pixels: far beyond any map, far below where doubles cannot resolve a pixel.
inline constexpr NumberRange tiled_coordinate{-1e7, 1e7};

/// Reads the custom properties of a map or object. Throws a JsonError.
Properties parse_properties(const JsonObject& owner);

/// Reads an object and sets its location in messages to its id and name. Throws a JsonError.
MapObject parse_object(JsonObject& object, const std::string& file, ribbon::Vec2 offset_px, const TiledFrame& frame);

}  // namespace engine
