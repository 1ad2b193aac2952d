#include "engine/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "engine/scene/scene_bodies.h"
#include "engine/scene/scene_cord.h"
#include "engine/scene/scene_weather.h"
#include "engine/scene/scene_wheels.h"
#include "ribbon/box2d/convert.h"
#include "ribbon/rest_shape.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr std::size_t max_objects = 2000;     // far more than a level needs, few enough to run any of them
constexpr std::int64_t max_points = 100'000;  // of all cords together: a few hundred megabytes at most
constexpr double max_anchor_distance = 0.25;  // m, from an anchor to the cord point that it pins
constexpr double max_tie_distance = 0.25;     // m, from a tie to the points that it ties
constexpr double max_load_distance = 0.5;     // m, from the rim of a load to the end of the cord that it hangs from

b2Vec2 gravity_of(const TiledMap& map) {
  return {0.0F, static_cast<float>(map.properties.number_or("gravity_y", -9.81, {-1000.0, 1000.0}))};
}

bool is_sticky(const MapObject& body) { return body.properties.boolean_or("sticky", false); }

bool is_cord(const MapObject& object) { return object.kind == "cord" || object.kind == "ribbon"; }

/// Limits the points of all cords before any is built: a few objects can define more than fits in memory.
void check_points(const TiledMap& map) {
  std::int64_t points = 0;
  for (const MapObject& object : map.objects) {
    if (is_cord(object)) points += points_of(object);
    if (points <= max_points) continue;
    throw object.error("the cords up to this one have " + std::to_string(points) +
                       " points, columns times rows; accepted are at most " + std::to_string(max_points));
  }
}

void check_map(const TiledMap& map, const std::vector<std::string>& other_properties) {
  map.properties.check_known_properties(
      {"gravity_y", "pixels_per_metre", "wind_x", "wind_y", "air_density", "gusts", "gust_time", "gust_length",
       "water_level", "water_density", "current_x", "current_y"},
      other_properties);
  if (map.objects.size() > max_objects) {
    throw MapError(map.file + ": the map has " + std::to_string(map.objects.size()) +
                   " objects; accepted are at most " + std::to_string(max_objects));
  }
  check_points(map);
}

void hash_body(ribbon::box2d::StateHash& hash, std::uint16_t index, const b2Body& body) {
  ribbon::box2d::Hasher hasher;
  const b2Transform& transform = body.GetTransform();
  for (const float value : {transform.p.x, transform.p.y, transform.q.s, transform.q.c, body.GetAngle(),
                            body.GetLinearVelocity().x, body.GetLinearVelocity().y, body.GetAngularVelocity()}) {
    hasher.add(value);
  }
  hasher.add(static_cast<int>(body.IsAwake()));
  hash.add(ribbon::box2d::Subsystem::body, index, hasher);
}

}  // namespace

Scene::Scene(const TiledMap& map, const std::vector<std::string>& other_kinds, const b2Filter& cord_filter,
             const std::vector<std::string>& other_properties)
    : world_(gravity_of(map)) {
  check_map(map, other_properties);
  if (const std::optional<ribbon::WeatherDef> weather = weather_of(map)) {
    weather_.emplace(*weather);
    coupling_.set_medium(&*weather_);
  }
  std::vector<WheelDefinition> wheels;
  for (const MapObject& object : map.objects) {
    if (is_cord(object)) {
      build_cord(object, map, cord_filter, wheels);
    } else {
      build(object, map, other_kinds);
    }
  }
  for (const WheelDefinition& wheel : wheels) hang_wheel(wheel, map);
  for (const MapObject& object : map.objects) {  // these refer to cords
    if (object.kind == "anchor") fix_anchor(object, map);
    if ((object.kind == "load" || object.kind == "circle") && object.properties.has("cord")) hang_load(object, map);
    if (object.kind == "tie") tie_cords(object, map);
    if (object.kind == "wheel") (void)named_cord(object, map);  // refuses what is no cord
  }
}

void Scene::build(const MapObject& object, const TiledMap& map, const std::vector<std::string>& other_kinds) {
  if (object.kind == "ground") {
    bodies_.push_back({&build_ground(object, world_), BodyKind::ground, object.id, is_sticky(object)});
  } else if (object.kind == "circle") {
    bodies_.push_back({&build_circle(object, world_), BodyKind::circle, object.id, is_sticky(object)});
    if (object.properties.integer_or("path", 0) != 0) rides_.add(*bodies_.back().body, object, map);
  } else if (object.kind == "load") {
    bodies_.push_back({&build_load(object, world_), BodyKind::load, object.id, is_sticky(object)});
  } else if (object.kind == "path") {
    check_path(object);
  } else if (object.kind != "anchor" && object.kind != "tie" && object.kind != "wheel" &&
             std::find(other_kinds.begin(), other_kinds.end(), object.kind) == other_kinds.end()) {
    std::string accepted = "ground, circle, cord, ribbon, anchor, load, path, tie, wheel";
    for (const std::string& kind : other_kinds) accepted += ", " + kind;
    throw object.error("class is " + in_quotes(object.kind) + "; accepted is " + accepted);
  }
}

void Scene::build_cord(const MapObject& object, const TiledMap& map, const b2Filter& filter,
                       std::vector<WheelDefinition>& wheels) {
  CordDefinition definition = read_cord(object);
  const b2Filter wanted = is_solid(object) ? b2Filter{} : filter;
  ribbon::box2d::CordId cord = 0;
  try {
    if (auto* direct = std::get_if<ribbon::CordDef>(&definition)) {
      const std::vector<WheelDefinition> own = reeve_around_wheels(object, map, *direct);
      if (object.properties.boolean_or("at_rest", false)) {
        if (!own.empty())
          throw object.error("property \"at_rest\" is of a cord without wheels; accepted is one or the other");
        ribbon::lay_at_rest(*direct, ribbon::box2d::to_double(world_.GetGravity()));
      }
      wheels.insert(wheels.end(), own.begin(), own.end());
      cord = coupling_.add(ribbon::Cord(*direct), wanted);
    } else if (has_wheels(object, map)) {
      throw object.error("is of the thesis's solver and has a wheel; accepted is a rope of the direct solver");
    } else {
      cord = coupling_.add(ribbon::ThesisCord(std::get<ribbon::ThesisDef>(definition)), wanted);
    }
  } catch (const ribbon::DefinitionError& error) {
    throw object.error(error.what());
  }
  coupling_.cord(cord).set_user_data(static_cast<std::uintptr_t>(object.id));
  cord_objects_.push_back(object.id);
}

/// Lays the cord on its wheel, which the body that it names carries, or a static disc within the groove: a load that is
/// hoisted to the wheel stops there.
void Scene::hang_wheel(const WheelDefinition& wheel, const TiledMap& map) {
  const MapObject& object = *wheel.object;
  b2Body* body = nullptr;
  if (object.properties.integer_or("body", 0) != 0) {
    body = &named_body(object, map);
  } else {
    b2BodyDef wall;
    wall.position = ribbon::box2d::to_float(object.position);
    body = world_.CreateBody(&wall);
    if (wheel.disc_radius > 0.0) {
      b2CircleShape disc;
      disc.m_radius = static_cast<float>(wheel.disc_radius);
      body->CreateFixture(&disc, 0.0F);
    }
  }
  try {
    wheels_.push_back({coupling_.add_pulley(named_cord(object, map), *body, wheel.pulley), object.id});
  } catch (const std::logic_error& error) {
    throw object.error(error.what());
  }
}

/// Returns the body of the object whose id is the property "body".
b2Body& Scene::named_body(const MapObject& object, const TiledMap& map) const {
  const std::int64_t id = object.properties.integer("body");
  const auto made = std::find_if(bodies_.begin(), bodies_.end(), [id](const SceneBody& b) { return b.object == id; });
  if (made != bodies_.end()) return *made->body;
  const MapObject* other = map.find(static_cast<int>(id));
  throw object.error(
      "property \"body\" is " + std::to_string(id) + ", " +
      (other == nullptr ? "and there is no such object" : "an object of class " + in_quotes(other->kind)) +
      "; accepted is the id of a ground, circle or load");
}

/// Returns the cord whose id is a property of the object.
ribbon::box2d::CordId Scene::named_cord(const MapObject& object, const TiledMap& map, const char* property) const {
  const std::int64_t id = object.properties.integer(property);
  const auto found = std::find(cord_objects_.begin(), cord_objects_.end(), id);
  if (found != cord_objects_.end()) return static_cast<ribbon::box2d::CordId>(found - cord_objects_.begin());
  const MapObject* other = map.find(static_cast<int>(id));
  throw object.error(
      "property \"" + std::string(property) + "\" is " + std::to_string(id) + ", " +
      (other == nullptr ? "and there is no such object" : "an object of class " + in_quotes(other->kind)) +
      "; accepted is the id of a cord or ribbon");
}

/// Pins the cord point nearest to the anchor, of the cord that it names or of any cord, or lets a body hold it.
void Scene::fix_anchor(const MapObject& object, const TiledMap& map) {
  object.properties.check_known_properties({"cord", "body"});
  if (object.shape != MapShape::point) {
    throw object.error("the shape of an anchor is " + std::string(shape_name(object.shape)) + "; accepted is point");
  }
  std::optional<ribbon::box2d::CordPoint> nearest = coupling_.nearest_point(object.position, max_anchor_distance);
  if (object.properties.has("cord"))
    nearest = nearest_of(named_cord(object, map), object.position, max_anchor_distance);
  if (!nearest) {
    throw object.error("is further from its cord than an anchor reaches; accepted is one within " +
                       number_in_words(max_anchor_distance) + " m of a cord's point");
  }
  try {
    if (object.properties.integer_or("body", 0) == 0)
      return coupling_.cord(nearest->cord).pin(nearest->point, object.position);
    b2Body& body = named_body(object, map);
    coupling_.hold(nearest->cord, nearest->point, body, body.GetLocalPoint(ribbon::box2d::to_float(object.position)));
  } catch (const ribbon::CallError& error) {
    throw object.error(error.what());
  }
}

std::optional<ribbon::box2d::CordPoint> Scene::nearest_of(ribbon::box2d::CordId cord, Vec2 position,
                                                          double max_distance) const {
  std::optional<ribbon::box2d::CordPoint> nearest;
  const auto x = coupling_.cord(cord).positions();
  for (std::size_t p = 0; p < x.size(); ++p) {
    const double distance = length(x[p] - position);
    if (distance <= (nearest ? nearest->distance : max_distance)) nearest = {cord, static_cast<int>(p), distance};
  }
  return nearest;
}

/// Attaches the load or circle to the nearer end of its cord.
void Scene::hang_load(const MapObject& object, const TiledMap& map) {
  const ribbon::box2d::CordId cord = named_cord(object, map);
  const auto x = coupling_.cord(cord).positions();
  const bool first = length(x.front() - object.position) < length(x.back() - object.position);
  const Vec2 end = first ? x.front() : x.back();
  if (length(end - object.position) > 0.5 * length(object.size) + max_load_distance) {
    throw object.error("is " + number_in_words(length(end - object.position)) +
                       " m from the end of its cord; accepted is one whose rim is within " +
                       number_in_words(max_load_distance) + " m of it");
  }
  const auto made = std::find_if(bodies_.begin(), bodies_.end(),
                                 [&object](const SceneBody& body) { return body.object == object.id; });
  const b2Vec2 anchor = made->body->GetLocalPoint(ribbon::box2d::to_float(end));
  coupling_.hold(cord, first ? 0 : static_cast<int>(x.size()) - 1, *made->body, anchor);
}

/// Ties the nearest points of two cords.
void Scene::tie_cords(const MapObject& object, const TiledMap& map) {
  object.properties.check_known_properties({"cord", "other_cord", "breaking_force"});
  if (object.shape != MapShape::point) {
    throw object.error("the shape of a tie is " + std::string(shape_name(object.shape)) + "; accepted is point");
  }
  const ribbon::box2d::CordPoint first = end_of_tie(object, map, "cord", {});
  const ribbon::box2d::CordPoint other = end_of_tie(object, map, "other_cord", first.cord);
  ribbon::box2d::TieDef def{first.cord, first.point, other.cord, other.point};
  const double breaking_force = object.properties.number_or("breaking_force", 0.0, {0.0, 1e12});
  if (breaking_force > 0.0) def.breaking_force = breaking_force;
  try {
    coupling_.tie(def);
  } catch (const ribbon::CallError& error) {
    throw object.error(error.what());
  }
}

/// Returns the nearest point of the cord that a property names, or of any cord but one.
ribbon::box2d::CordPoint Scene::end_of_tie(const MapObject& object, const TiledMap& map, const char* property,
                                           std::optional<ribbon::box2d::CordId> except) const {
  std::optional<ribbon::box2d::CordPoint> nearest;
  const auto look_at = [&](ribbon::box2d::CordId cord) {
    const auto found = nearest_of(cord, object.position, nearest ? nearest->distance : max_tie_distance);
    if (found && (!nearest || found->distance < nearest->distance)) nearest = found;
  };
  if (object.properties.has(property)) {
    look_at(named_cord(object, map, property));
  } else {
    for (const ribbon::box2d::CordId cord : coupling_.cords()) {
      if (cord != except && coupling_.cord(cord).solver() == ribbon::box2d::Solver::direct) look_at(cord);
    }
  }
  if (nearest) return *nearest;
  throw object.error("is further from a cord than a tie reaches; accepted is one within " +
                     number_in_words(max_tie_distance) + " m of points of two cords");
}

int Scene::cord_object(ribbon::box2d::CordId cord) const {
  const ribbon::box2d::CordView made = coupling_.cord(cord);
  return made.is_valid() ? static_cast<int>(made.user_data()) : 0;
}

void Scene::tick(double dt) {
  if (!rides_.empty()) rides_.lead(dt);
  coupling_.tick(world_, dt, velocity_iterations, position_iterations);
}

void Scene::add_cord_to(ribbon::box2d::StateHash& hash, ribbon::box2d::CordId cord) {
  ribbon::box2d::Hasher hasher;
  if (coupling_.cord(cord).solver() == ribbon::box2d::Solver::direct) {
    coupling_.cord(cord).direct().save(hashed_);
    ribbon::box2d::add_to(hasher, hashed_);
  } else {
    coupling_.cord(cord).thesis().save(hashed_thesis_);
    ribbon::box2d::add_to(hasher, hashed_thesis_);
  }
  hash.add(ribbon::box2d::Subsystem::cord, static_cast<std::uint16_t>(cord), hasher);
}

void Scene::add_to(ribbon::box2d::StateHash& hash) {
  for (const ribbon::box2d::CordId c : coupling_.cords()) add_cord_to(hash, c);
  // Box2D lists the newest body first.
  int index = world_.GetBodyCount();
  for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    hash_body(hash, static_cast<std::uint16_t>(--index), *body);
  }
}

}  // namespace engine
