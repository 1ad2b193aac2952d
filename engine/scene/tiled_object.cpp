#include "engine/scene/tiled_object.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/files/ranges.h"
#include "ribbon/geometry/rotation.h"

namespace engine {
namespace {

using nlohmann::json;

constexpr NumberRange accepted_degrees{-1e6, 1e6};
constexpr NumberRange accepted_extent{0.01, 1e7};  // pixels

/// A counter-clockwise rotation.
struct Rotation {
  double angle = 0.0;
  double cos = 1.0;
  double sin = 0.0;

  ribbon::Vec2 operator()(ribbon::Vec2 v) const { return {cos * v.x - sin * v.y, sin * v.x + cos * v.y}; }
};

/// Converts Tiled's clockwise degrees.
Rotation rotation_of(double clockwise_degrees) {
  const double degrees = 0.0 - std::remainder(clockwise_degrees, 360.0);
  const double angle = degrees * (std::numbers::pi / 180.0);
  // Quarter turns are exact: cos(π/2) is not 0 in floating point.
  if (degrees == 0.0) return {angle, 1.0, 0.0};
  if (std::abs(degrees) == 90.0) return {angle, 0.0, std::copysign(1.0, degrees)};
  if (std::abs(degrees) == 180.0) return {angle, -1.0, 0.0};
  // Not std::cos and std::sin: their last bit depends on the C library, which would break replays.
  const ribbon::Vec2 cos_sin = ribbon::rotation(angle);
  return {angle, cos_sin.x, cos_sin.y};
}

Properties::Value property_value(const JsonObject& property) {
  const std::string type = property.text_or("type", "string");
  if (type == "bool") {
    if (!property.has("value")) property.fail("\"value\" is missing, accepted is true or false");
    return property.boolean_or("value", false);
  }
  if (type == "int" || type == "object") return property.integer("value");
  if (type == "float") return property.number("value");
  if (type == "string" || type == "color" || type == "file") return property.text("value");
  property.refuse("type", "one of string, int, float, bool, color, file, object");
}

MapShape shape_of(const JsonObject& object) {
  for (const char* key : {"gid", "text", "template", "capsule"}) {
    if (!object.has(key)) continue;
    object.fail("has " + in_quotes(key) + ": accepted are point, rectangle, ellipse, polygon and polyline objects");
  }
  std::vector<MapShape> found;
  if (object.boolean_or("point", false)) found.push_back(MapShape::point);
  if (object.boolean_or("ellipse", false)) found.push_back(MapShape::ellipse);
  if (object.has("polygon")) found.push_back(MapShape::polygon);
  if (object.has("polyline")) found.push_back(MapShape::polyline);
  if (found.size() > 1) {
    object.fail("is both " + std::string(shape_name(found[0])) + " and " + std::string(shape_name(found[1])) +
                ", accepted is one shape");
  }
  return found.empty() ? MapShape::rectangle : found.front();
}

/// Reads the corners in pixels relative to the object's position, y up, not rotated.
std::vector<ribbon::Vec2> parse_points(const JsonObject& object, const char* key, std::size_t min_count) {
  std::vector<ribbon::Vec2> points;
  for (const json& value : object.array(key)) {
    const JsonObject point(value, object.where() + ": " + key + " point " + std::to_string(points.size() + 1));
    points.push_back({point.number("x", tiled_coordinate), -point.number("y", tiled_coordinate)});
  }
  if (points.size() < min_count) {
    object.fail(std::string(key) + " has " + std::to_string(points.size()) + " points, accepted are " +
                std::to_string(min_count) + " or more");
  }
  return points;
}

}  // namespace

std::string_view shape_name(MapShape shape) {
  switch (shape) {
    case MapShape::point: return "point";
    case MapShape::rectangle: return "rectangle";
    case MapShape::ellipse: return "ellipse";
    case MapShape::polygon: return "polygon";
    case MapShape::polyline: return "polyline";
  }
  return "?";
}

Properties parse_properties(const JsonObject& owner) {
  Properties properties(owner.where());
  if (!owner.has("properties")) return properties;
  std::size_t number = 0;
  for (const json& value : owner.array("properties")) {
    JsonObject property(value, owner.where() + ": property number " + std::to_string(++number));
    const std::string name = property.text("name");
    property.rename(owner.where() + ": property " + in_quotes(name));
    if (!properties.insert(name, property_value(property))) property.fail("is there twice");
  }
  return properties;
}

MapObject parse_object(JsonObject& object, const std::string& file, ribbon::Vec2 offset_px, const TiledFrame& frame) {
  MapObject result;
  result.id = static_cast<int>(object.integer("id", {1, std::numeric_limits<int>::max()}));
  object.rename(file + ": object " + std::to_string(result.id));
  result.name = object.text_or("name", "");
  if (!result.name.empty()) object.rename(object.where() + " " + in_quotes(result.name));
  // The field is "type" up to Tiled 1.8, "class" in 1.9, and "type" again from 1.10.
  result.kind = object.text_or("class", "");
  if (result.kind.empty()) result.kind = object.text_or("type", "");
  result.shape = shape_of(object);
  result.properties = parse_properties(object);

  const ribbon::Vec2 pivot_px =
      offset_px + ribbon::Vec2{object.number("x", tiled_coordinate), object.number("y", tiled_coordinate)};
  const Rotation rotated = rotation_of(object.number_or("rotation", 0.0, accepted_degrees));
  result.rotation = rotated.angle;
  result.position = frame.to_world(pivot_px);
  if (result.shape == MapShape::rectangle || result.shape == MapShape::ellipse) {
    // Tiled's position is the top left corner, which is also the centre of rotation.
    const ribbon::Vec2 size_px{object.number("width", accepted_extent), object.number("height", accepted_extent)};
    result.size = {size_px.x / frame.pixels_per_metre, size_px.y / frame.pixels_per_metre};
    result.position = frame.to_world(pivot_px, rotated({size_px.x / 2.0, -size_px.y / 2.0}));
  }
  std::vector<ribbon::Vec2> points_px;
  if (result.shape == MapShape::polygon) points_px = parse_points(object, "polygon", 3);
  if (result.shape == MapShape::polyline) points_px = parse_points(object, "polyline", 2);
  for (const ribbon::Vec2 point_px : points_px) result.points.push_back(frame.to_world(pivot_px, rotated(point_px)));
  return result;
}

}  // namespace engine
