#pragma once

#include <array>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/constants.h"
#include "tests/support/shape_world.h"

namespace engine {

using ribbon::ThesisDef;
using ribbon::Vec2;

using constants::dt;

/// A cord of 4 m along +x, its middle line through `left`, 0.2 m wide, 1 kg.
inline ThesisDef cord_def(Vec2 left = {0.0, 0.0}) {
  ThesisDef def;
  def.w = 21;
  def.spacing = 0.2;
  def.point_mass = 1.0 / 42.0;
  def.spring_stiffness = 2e4;
  def.bar_damping = 20.0;
  def.positions = ribbon::lay_along(std::array{left, left + Vec2{1.0, 0.0}}, def.w, def.h, def.spacing);
  return def;
}

inline ThesisDef pinned_at_both_ends(Vec2 left = {0.0, 0.0}) {
  ThesisDef def = cord_def(left);
  def.pins = {0, 1, 40, 41};
  return def;
}

inline b2Body* add_circle(b2World& world, Vec2 center, double radius, b2BodyType type = b2_dynamicBody,
                          double density = 1.0, b2Filter filter = {}, bool sensor = false) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = ribbon::box2d::to_float(center);
  b2Body* body = world.CreateBody(&definition);
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(radius);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = static_cast<float>(density);
  fixture.filter = filter;
  fixture.isSensor = sensor;
  body->CreateFixture(&fixture);
  return body;
}

inline void tick(ribbon::box2d::Coupling& coupling, b2World& world) { coupling.tick(world, dt); }

inline double y_of(const b2Body* body) { return static_cast<double>(body->GetPosition().y); }

}  // namespace engine
