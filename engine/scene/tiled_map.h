#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/tiled_properties.h"
#include "ribbon/vec2.h"

/// Levels from the Tiled editor (versions 1.8 to 1.10, orthogonal, finite, saved as JSON, .tmj) as plain data.
///
/// Tiled's pixels, y down, are converted to metres, y up, with the origin at the bottom left corner of the map:
/// x = x_px / ppm, y = (map_height_px − y_px) / ppm, where ppm is the map's property `pixels_per_metre` (default 64).
namespace engine {

enum class MapShape { point, rectangle, ellipse, polygon, polyline };
/// "point", "rectangle", …
std::string_view shape_name(MapShape shape);

/// One object of the map, in metres and radians of the world.
struct MapObject {
  int id = 0;  ///< Tiled's id, 1 or more, unique in the map.
  std::string name;
  std::string kind;  ///< Tiled's "class" (called "type" up to 1.8 and again in 1.10); may be empty.
  MapShape shape = MapShape::point;
  ribbon::Vec2 position;             ///< Centre of a rectangle or ellipse; the object's point for other shapes.
  ribbon::Vec2 size;                 ///< Full width and height of a rectangle or ellipse, both positive; otherwise 0.
  double rotation = 0.0;             ///< Counter-clockwise, −π … π. Already applied to position and points.
  std::vector<ribbon::Vec2> points;  ///< Of a polygon (3 or more) or polyline (2 or more), in file order; else empty.
  Properties properties;

  /// Returns an error to throw: file, id and name of the object, then the sentence.
  MapError error(std::string_view sentence) const { return properties.error(sentence); }
};

struct MapColour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const MapColour&) const = default;
};

struct TiledMap {
  std::string file;                ///< Path for messages.
  std::uint64_t content_hash = 0;  ///< hash_bytes() of the file.
  ribbon::Vec2 size;               ///< Metres.
  double pixels_per_metre = 64.0;
  std::optional<MapColour> background;
  Properties properties;  ///< Of the map itself, including `pixels_per_metre`.
  /// The objects of all object layers, including hidden and nested ones, in file order, with layer offsets applied.
  std::vector<MapObject> objects;

  /// Returns the object with that id, or null.
  const MapObject* find(int id) const;
};

/// Loads a map of at most 4 MiB. Throws a MapError if it cannot be read, is not a map, or has unsupported parts:
/// visible tile and image layers (hidden ones are skipped), tile, text and template objects, rectangles and ellipses
/// without extent, class properties, coordinates beyond ±10⁷ px, or group layers more than 16 deep.
TiledMap load_tiled_map(const std::string& path);
/// Reads the text of a map; messages use `file` as the path. Throws like load_tiled_map.
TiledMap parse_tiled_map(std::string_view text, const std::string& file);

}  // namespace engine
