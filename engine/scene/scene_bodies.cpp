#include "engine/scene/scene_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/scene/scene_paths.h"
#include "ribbon/box2d/convert.h"

namespace engine {
namespace {

using ribbon::Vec2;

constexpr double max_velocity = 1000.0;  // m/s or rad/s, the largest initial velocity that a map may set

float single(double value) { return static_cast<float>(value); }

/// The scale of gravity: below 0 a body rises.
constexpr NumberRange accepted_gravity_scale{-100.0, 100.0};

b2BodyType body_type(const MapObject& object) {
  const bool rides = object.properties.integer_or("path", 0) != 0;
  const std::string type =
      object.properties.text_or("body", rides ? "kinematic" : "dynamic", {"static", "kinematic", "dynamic"});
  for (const char* const name : {"velocity_x", "velocity_y"}) {
    if (rides && object.properties.number_or(name, 0.0) != 0.0)
      throw object.error("has \"path\" and " + in_quotes(name) + "; accepted is one or the other");
  }
  if (rides && type != "kinematic")
    throw object.error("property \"body\" is " + in_quotes(type) +
                       " of a circle with \"path\"; accepted is \"kinematic\"");
  if (type == "static") return b2_staticBody;
  return type == "kinematic" ? b2_kinematicBody : b2_dynamicBody;
}

/// True if all corners are on the same side of each edge (which excludes stars), neighbours are far enough apart, and
/// the area is large enough for Box2D's single precision.
bool is_convex(const std::vector<Vec2>& points) {
  double side = 0.0;
  double twice_area = 0.0;
  double max_edge = 0.0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec2 a = points[k];
    const Vec2 b = points[(k + 1) % points.size()];
    if (length(b - a) < 2.0 * static_cast<double>(b2_linearSlop)) return false;
    max_edge = std::max(max_edge, length(b - a));
    twice_area += cross(a - points[0], b - points[0]);
    for (const Vec2 c : points) {
      const double turn = cross(b - a, c - a);
      if (turn * side < 0.0) return false;
      if (turn != 0.0) side = turn;
    }
  }
  return std::abs(twice_area) > std::max(1e-3, 1e-5 * max_edge * max_edge);  // m²
}

/// Sets the shape to a polygon relative to `origin`. Returns false if the polygon is not convex or has more than
/// b2_maxPolygonVertices corners.
bool set_polygon(b2PolygonShape& shape, const std::vector<Vec2>& points, Vec2 origin) {
  if (points.size() > b2_maxPolygonVertices || !is_convex(points)) return false;
  std::vector<b2Vec2> corners;
  for (const Vec2 point : points) corners.push_back(ribbon::box2d::to_float(point - origin));
  shape.Set(corners.data(), static_cast<int32>(corners.size()));
  return true;
}

bool is_round(const MapObject& object) {
  return object.shape == MapShape::ellipse && std::abs(object.size.x - object.size.y) <= 1e-3 * object.size.x;
}

std::string size_in_words(const MapObject& object) {
  return std::string(shape_name(object.shape)) + " of " + number_in_words(object.size.x) + " by " +
         number_in_words(object.size.y) + " m";
}

}  // namespace

b2Body& build_ground(const MapObject& object, b2World& world) {
  object.properties.check_known_properties({"friction", "sticky"});
  b2BodyDef definition;
  definition.position = ribbon::box2d::to_float(object.position);
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
  b2Body& body = *world.CreateBody(&definition);
  body.CreateFixture(&fixture);
  return body;
}

b2Body& build_circle(const MapObject& object, b2World& world) {
  const Properties& p = object.properties;
  p.check_known_properties({"body", "density", "friction", "restitution", "angular_damping", "velocity_x", "velocity_y",
                            "spin", "gravity_scale", "cord", "path", "speed", "sticky"});
  if (!is_round(object)) {
    throw object.error("the shape of a circle is " + size_in_words(object) +
                       "; accepted is an ellipse as wide as high");
  }
  b2BodyDef definition;
  definition.type = body_type(object);
  definition.position = ribbon::box2d::to_float(object.position);
  definition.linearVelocity = {single(p.number_or("velocity_x", 0.0, {-max_velocity, max_velocity})),
                               single(p.number_or("velocity_y", 0.0, {-max_velocity, max_velocity}))};
  definition.angularVelocity = single(p.number_or("spin", 0.0, {-max_velocity, max_velocity}));
  definition.angularDamping = single(p.number_or("angular_damping", 0.0, {0.0, 100.0}));
  definition.gravityScale = single(p.number_or("gravity_scale", 1.0, accepted_gravity_scale));
  p.number_or("speed", default_track_speed, track_speed);  // also without a path
  b2CircleShape shape;
  shape.m_radius = single(0.5 * object.size.x);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = single(p.number_or("density", 1.0, {1e-6, 1e6}));
  fixture.friction = single(p.number_or("friction", 0.6, {0.0, 10.0}));
  fixture.restitution = single(p.number_or("restitution", 0.0, {0.0, 1.0}));
  b2Body& body = *world.CreateBody(&definition);
  body.CreateFixture(&fixture);
  return body;
}

b2Body& build_load(const MapObject& object, b2World& world) {
  const Properties& p = object.properties;
  p.check_known_properties({"mass", "cord", "friction", "restitution", "angular_damping", "gravity_scale", "sticky"});
  if (object.shape != MapShape::rectangle && !is_round(object)) {
    throw object.error("the shape of a load is " + size_in_words(object) +
                       "; accepted is rectangle, or an ellipse as wide as high");
  }
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  definition.position = ribbon::box2d::to_float(object.position);
  definition.angle = single(object.rotation);
  definition.angularDamping = single(p.number_or("angular_damping", 0.0, {0.0, 100.0}));
  definition.gravityScale = single(p.number_or("gravity_scale", 1.0, accepted_gravity_scale));
  b2CircleShape disc;
  disc.m_radius = single(0.5 * object.size.x);
  b2PolygonShape box;
  box.SetAsBox(single(0.5 * object.size.x), single(0.5 * object.size.y));
  const bool is_disc = object.shape == MapShape::ellipse;
  const double area = is_disc ? 0.25 * std::numbers::pi * object.size.x * object.size.x : object.size.x * object.size.y;
  b2FixtureDef fixture;
  fixture.shape = is_disc ? static_cast<const b2Shape*>(&disc) : &box;
  fixture.density = single(p.number("mass", {1e-3, 1e6}) / area);
  fixture.friction = single(p.number_or("friction", 0.6, {0.0, 10.0}));
  fixture.restitution = single(p.number_or("restitution", 0.0, {0.0, 1.0}));
  b2Body& body = *world.CreateBody(&definition);
  body.CreateFixture(&fixture);
  return body;
}

}  // namespace engine
