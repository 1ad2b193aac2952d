#pragma once

#include <string>

#include "engine/files/json_object.h"
#include "engine/scene/tiled_map.h"
#include "engine/scene/tiled_properties.h"
#include "ribbon/vec2.h"

/// One object of a Tiled map. Part of the loader; included by its sources only.
namespace engine {

/// From the map's pixels, y down, to the world's metres, y up: the one place where that is done.
struct TiledFrame {
  double height_px = 0.0;
  double pixels_per_metre = 64.0;

  /// The point at `local_px` (y up, already turned) from a map point (y down).
  ribbon::Vec2 to_world(ribbon::Vec2 map_px, ribbon::Vec2 local_px = {}) const {
    return {(map_px.x + local_px.x) / pixels_per_metre, (height_px - map_px.y + local_px.y) / pixels_per_metre};
  }
};

/// Pixels. Far beyond any map, far below where doubles lose the pixel.
inline constexpr NumberRange tiled_coordinate{-1e7, 1e7};

/// The custom properties of a map or object. Throws a JsonError.
Properties parse_properties(const JsonObject& owner);

/// Renames `object` in messages as soon as its id and name are known. Throws a JsonError.
MapObject parse_object(JsonObject& object, const std::string& file, ribbon::Vec2 offset_px, const TiledFrame& frame);

}  // namespace engine
