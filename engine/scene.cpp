#include "engine/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <variant>

#include "engine/convert.h"
#include "engine/scene_cord.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr std::size_t most_objects = 2000;     // far more than a level needs, few enough to run whatever they are
constexpr std::int64_t most_points = 100'000;  // of all cords together: a few hundred megabytes at the most
constexpr double largest_velocity = 1000.0;    // m/s, of a body as a map may declare it

b2Vec2 gravity_of(const TiledMap& map) {
  return {0.0F, static_cast<float>(map.properties.number_or("gravity_y", -9.81, {-1000.0, 1000.0}))};
}

float single(double value) { return static_cast<float>(value); }

b2BodyType body_type(const MapObject& object) {
  const std::string type = object.properties.text_or("body", "dynamic", {"static", "kinematic", "dynamic"});
  if (type == "static") return b2_staticBody;
  return type == "kinematic" ? b2_kinematicBody : b2_dynamicBody;
}

/// True if every corner lies to the same side of every edge (which a star's do not), none is too near the next, and
/// they span an area: one that Box2D, in single precision, does not take for none.
bool is_convex(const std::vector<Vec2>& points) {
  double side = 0.0;
  double twice_area = 0.0;
  double longest = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 a = points[k];
    const Vec2 b = points[(k + 1) % points.size()];
    if (length(b - a) < 2.0 * static_cast<double>(b2_linearSlop)) return false;
    longest = std::max(longest, length(b - a));
    twice_area += cross(a - points[0], b - points[0]);
    for (const Vec2 c : points) {
      const double turn = cross(b - a, c - a);
      if (turn * side < 0.0) return false;
      if (turn != 0.0) side = turn;
    }
  }
  return std::abs(twice_area) > std::max(1e-3, 1e-5 * longest * longest);  // m²
}

/// A convex polygon of at most b2_maxPolygonVertices corners, about `origin`; false if it is none.
bool set_polygon(b2PolygonShape& shape, const std::vector<Vec2>& points, Vec2 origin) {
  if (points.size() > b2_maxPolygonVertices || !is_convex(points)) return false;
  std::vector<b2Vec2> corners;
  for (const Vec2 point : points) corners.push_back(to_float(point - origin));
  shape.Set(corners.data(), static_cast<int32>(corners.size()));
  return true;
}

/// Before any of them is laid out: few objects can ask for all the memory there is.
void check_points(const TiledMap& map) {
  std::int64_t points = 0;
  for (const MapObject& object : map.objects) {
    if (object.kind == "cord") points += points_of(object);
    if (points <= most_points) continue;
    throw object.error("the cords up to this one have " + std::to_string(points) +
                       " points, columns times rows; accepted are at most " + std::to_string(most_points));
  }
}

void hash_body(StateHash& hash, std::uint16_t index, const b2Body& body) {
  Hasher hasher;
  const b2Transform& transform = body.GetTransform();
  for (const float value : {transform.p.x, transform.p.y, transform.q.s, transform.q.c, body.GetAngle(),
                            body.GetLinearVelocity().x, body.GetLinearVelocity().y, body.GetAngularVelocity()}) {
    hasher.add(value);
  }
  hasher.add(static_cast<int>(body.IsAwake()));
  hash.add(Subsystem::body, index, hasher);
}

void hash_cord(StateHash& hash, std::uint16_t index, const Coupling& coupling) {
  Hasher hasher;
  if (coupling.solver(index) == Solver::direct) {
    add_to(hasher, coupling.direct_cord(index).save());
  } else {
    add_to(hasher, coupling.cord(index).save());
  }
  hash.add(Subsystem::cord, index, hasher);
}

}  // namespace

Scene::Scene(const TiledMap& map, const std::vector<std::string>& other_kinds, const b2Filter& cord_filter)
    : world_(gravity_of(map)) {
  map.properties.check_known_properties({"gravity_y", "pixels_per_metre"});
  if (map.objects.size() > most_objects) {
    throw MapError(map.file + ": the map has " + std::to_string(map.objects.size()) +
                   " objects; accepted are at most " + std::to_string(most_objects));
  }
  check_points(map);
  for (const MapObject& object : map.objects) {
    if (object.kind == "ground") {
      build_ground(object);
    } else if (object.kind == "circle") {
      build_circle(object);
    } else if (object.kind == "cord") {
      build_cord(object, cord_filter);
    } else if (std::find(other_kinds.begin(), other_kinds.end(), object.kind) == other_kinds.end()) {
      std::string accepted = "ground, circle, cord";
      for (const std::string& kind : other_kinds) accepted += ", " + kind;
      throw object.error("class is " + in_quotes(object.kind) + "; accepted is " + accepted);
    }
  }
}

void Scene::build_ground(const MapObject& object) {
  object.properties.check_known_properties({"friction"});
  b2BodyDef definition;
  definition.position = to_float(object.position);
  definition.angle = object.shape == MapShape::rectangle ? single(object.rotation) : 0.0F;
  b2PolygonShape shape;
  if (object.shape == MapShape::rectangle) {
    shape.SetAsBox(single(0.5 * object.size.x), single(0.5 * object.size.y));
  } else if (object.shape != MapShape::polygon) {
    throw object.error("the shape of a ground is " + std::string(shape_name(object.shape)) +
                       "; accepted is rectangle, polygon");
  } else if (!set_polygon(shape, object.points, object.position)) {
    throw object.error("the polygon of a ground has " + std::to_string(object.points.size()) +
                       " corners; accepted is a convex one of 3 to 8 corners, at least 1 cm apart, that is no sliver");
  }
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.friction = single(object.properties.number_or("friction", 0.6, {0.0, 10.0}));
  world_.CreateBody(&definition)->CreateFixture(&fixture);
}

void Scene::build_circle(const MapObject& object) {
  const Properties& p = object.properties;
  p.check_known_properties(
      {"body", "density", "friction", "restitution", "angular_damping", "velocity_x", "velocity_y", "spin"});
  if (object.shape != MapShape::ellipse || std::abs(object.size.x - object.size.y) > 1e-3 * object.size.x) {
    throw object.error("the shape of a circle is " + std::string(shape_name(object.shape)) + " of " +
                       number_in_words(object.size.x) + " by " + number_in_words(object.size.y) +
                       " m; accepted is an ellipse as wide as high");
  }
  b2BodyDef definition;
  definition.type = body_type(object);
  definition.position = to_float(object.position);
  definition.linearVelocity = {single(p.number_or("velocity_x", 0.0, {-largest_velocity, largest_velocity})),
                               single(p.number_or("velocity_y", 0.0, {-largest_velocity, largest_velocity}))};
  definition.angularVelocity = single(p.number_or("spin", 0.0, {-largest_velocity, largest_velocity}));
  definition.angularDamping = single(p.number_or("angular_damping", 0.0, {0.0, 100.0}));
  b2CircleShape shape;
  shape.m_radius = single(0.5 * object.size.x);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = single(p.number_or("density", 1.0, {1e-6, 1e6}));
  fixture.friction = single(p.number_or("friction", 0.6, {0.0, 10.0}));
  fixture.restitution = single(p.number_or("restitution", 0.0, {0.0, 1.0}));
  world_.CreateBody(&definition)->CreateFixture(&fixture);
}

void Scene::build_cord(const MapObject& object, const b2Filter& filter) {
  const CordDefinition definition = read_cord(object);
  try {
    if (const auto* direct = std::get_if<ribbon::CordDef>(&definition)) {
      coupling_.add(ribbon::Cord(*direct), filter);
    } else {
      coupling_.add(ribbon::ThesisCord(std::get<ribbon::ThesisDef>(definition)), filter);
    }
  } catch (const ribbon::DefinitionError& error) {
    throw object.error(error.what());
  }
}

void Scene::tick(double dt) {
  coupling_.gather(world_, dt);
  coupling_.step();
  coupling_.apply();
  world_.Step(single(dt), velocity_iterations, position_iterations);
}

void Scene::add_to(StateHash& hash) const {
  for (CordIndex c = 0; c < coupling_.size(); ++c) hash_cord(hash, static_cast<std::uint16_t>(c), coupling_);
  // Box2D lists the newest body first.
  int index = world_.GetBodyCount();
  for (const b2Body* body = world_.GetBodyList(); body != nullptr; body = body->GetNext()) {
    hash_body(hash, static_cast<std::uint16_t>(--index), *body);
  }
}

}  // namespace engine
