#pragma once

#include <box2d/box2d.h>

#include <cstddef>

#include "ribbon/box2d/convert.h"
#include "ribbon/cord_def.h"
#include "ribbon/vec2.h"
#include "tests/bits/bit_scenes.h"

// What the scenes of bits consist of: bodies and cords.

namespace bits {

using ribbon::CordDef;
using ribbon::Vec2;

inline std::size_t at(int i) { return static_cast<std::size_t>(i); }

inline b2Body& add_body(BitWorld& scene, const b2Shape& shape, Vec2 position, b2BodyType type,
                        float restitution = 0.1F) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = ribbon::box2d::to_float(position);
  definition.angularDamping = 0.1F;
  b2Body* body = scene.world.CreateBody(&definition);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 20.0F;
  fixture.friction = 0.4F;
  fixture.restitution = restitution;
  body->CreateFixture(&fixture);
  return *body;
}

inline b2Body& add_circle(BitWorld& scene, Vec2 position, double radius, b2BodyType type = b2_dynamicBody) {
  b2CircleShape circle;
  circle.m_radius = static_cast<float>(radius);
  return add_body(scene, circle, position, type);
}

inline b2Body& add_box(BitWorld& scene, Vec2 position, float half_width, float half_height,
                       b2BodyType type = b2_dynamicBody) {
  b2PolygonShape box;
  box.SetAsBox(half_width, half_height);
  return add_body(scene, box, position, type);
}

/// Adds a body that only holds cords.
inline b2Body& add_holder(BitWorld& scene, Vec2 position, double radius) {
  b2Body& body = add_circle(scene, position, radius);
  b2Filter none;
  none.maskBits = 0;
  body.GetFixtureList()->SetFilterData(none);
  return body;
}

/// A cord of `points` columns on a straight line from `from` with the distance `step`, and `rows` rows across.
inline CordDef line(Vec2 from, Vec2 step, int points, int rows = 1, double width = 0.0) {
  CordDef def;
  def.points = points;
  def.rows = rows;
  def.length = length(step) * (points - 1);
  def.width = width;
  const Vec2 across = rows > 1 ? (width / ((rows - 1) * length(step))) * perp(step) : Vec2{};
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < rows; ++j) def.positions.push_back(from + static_cast<double>(i) * step + j * across);
  }
  return def;
}

/// E = 0.2 MPa, ν = 0.2, 5 cm thick.
inline CordDef strip(Vec2 from, Vec2 step, int points, int rows, double width) {
  CordDef def = line(from, step, points, rows, width);
  ribbon::solid(2e5, 0.2, 0.05, width).apply_to(def);
  return def;
}

}  // namespace bits
