#include "game/simulation/level_rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string>

#include "game/simulation/tick_rate.h"
#include "ribbon/geometry/rotation.h"

namespace game {
namespace {

using engine::MapObject;
using engine::MapShape;
using ribbon::Vec2;

constexpr engine::NumberRange burning_seconds{0.05, 600.0};
constexpr engine::NumberRange accepted_x{-1e6, 1e6};
constexpr double default_burning = 1.0;  // s
constexpr double default_chase = 3.0;    // m/s

void check_shape(const MapObject& object, std::initializer_list<MapShape> accepted) {
  if (std::find(accepted.begin(), accepted.end(), object.shape) != accepted.end()) return;
  std::string names;
  for (const MapShape shape : accepted) names += (names.empty() ? "" : ", ") + std::string(engine::shape_name(shape));
  const std::string what = object.kind == "spikes" ? "spikes" : "a " + object.kind;
  throw object.error("the shape of " + what + " is " + std::string(engine::shape_name(object.shape)) +
                     "; accepted is " + names);
}

/// Returns the rectangle of an object that is not rotated.
Area upright_area(const MapObject& object) {
  if (object.rotation == 0.0) return {object.position, object.size};
  throw object.error("is rotated; accepted is the rotation 0");
}

/// Checks that a property names an object of one of these classes. Returns its id, or 0 without the property.
int id_of(const MapObject& object, const engine::TiledMap& map, const char* property, engine::Choices kinds) {
  const std::int64_t id = object.properties.integer_or(property, 0);
  if (id == 0) return 0;
  const MapObject* const other = map.find(static_cast<int>(id));
  const bool exists = other != nullptr && other->id == id;
  if (exists && std::find(kinds.begin(), kinds.end(), other->kind) != kinds.end()) return other->id;
  throw object.error("property " + engine::in_quotes(property) + " is " + std::to_string(id) + ", " +
                     (exists ? "an object of class " + engine::in_quotes(other->kind) : "and there is no such object") +
                     "; accepted is the id of one of class " + engine::list_in_words(kinds));
}

Blade read_blade(const MapObject& object, const engine::TiledMap& map) {
  check_shape(object, {MapShape::polyline, MapShape::rectangle});
  object.properties.check_known_properties({"body"});
  Blade blade{object.points, id_of(object, map, "body", {"ground", "circle", "load"})};
  if (object.shape == MapShape::polyline) return blade;
  const Vec2 along = ribbon::rotation(object.rotation);
  for (const Vec2 corner : {Vec2{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}}) {
    blade.edge.push_back(object.position + corner.x * object.size.x * along + corner.y * object.size.y * perp(along));
  }
  return blade;
}

Fire read_fire(const MapObject& object) {
  check_shape(object, {MapShape::rectangle});
  object.properties.check_known_properties({"seconds"});
  const double seconds = object.properties.number_or("seconds", default_burning, burning_seconds);
  return {upright_area(object), static_cast<int>(std::ceil(seconds * ticks_per_second))};
}

Chaser read_chaser(const MapObject& object, const engine::TiledMap& map) {
  check_shape(object, {MapShape::ellipse, MapShape::rectangle});
  object.properties.check_known_properties({"path", "speed", "from_x", "cord"});
  const bool round = object.shape == MapShape::ellipse;
  if (round && std::abs(object.size.x - object.size.y) > 1e-3 * object.size.x) {
    throw object.error("the ellipse of a chaser is " + engine::number_in_words(object.size.x) + " by " +
                       engine::number_in_words(object.size.y) + " m; accepted is one as wide as high");
  }
  const Area area = upright_area(object);
  engine::Track track = engine::track_of(object, map);
  const double start = track.nearest(object.position);
  std::optional<double> from_x;
  if (object.properties.has("from_x")) from_x = object.properties.number("from_x", accepted_x);
  return {std::move(track),
          start,
          object.properties.number_or("speed", default_chase, engine::track_speed),
          area,
          round,
          from_x,
          id_of(object, map, "cord", {"cord", "ribbon"})};
}

}  // namespace

LevelRules read_rules(const engine::TiledMap& map) {
  LevelRules rules;
  rules.knife = map.properties.boolean_or("knife", false);
  for (const MapObject& object : map.objects) {
    if (object.kind == "blade") rules.blades.push_back(read_blade(object, map));
    if (object.kind == "fire") rules.fires.push_back(read_fire(object));
    if (object.kind == "chaser") rules.chasers.push_back(read_chaser(object, map));
    if (object.kind == "circle" && object.properties.integer_or("path", 0) != 0) {
      rules.rails.push_back(engine::track_of(object, map));
    }
    if (object.kind == "spikes") {
      check_shape(object, {MapShape::rectangle});
      object.properties.check_known_properties({});
      rules.spikes.push_back(upright_area(object));
    }
    if (object.kind == "coin") {
      check_shape(object, {MapShape::point});
      object.properties.check_known_properties({});
      rules.coins.push_back(object.position);
    }
  }
  return rules;
}

}  // namespace game
