#include "tests/support/shape_world.h"

#include <numbers>

namespace test_support {

using ribbon::Vec2;
using ribbon::box2d::to_float;

void ShapeWorld::tick() { coupling.tick(world, dt); }

void ShapeWorld::step_cords() { test_support::step_cords(coupling, world, dt); }

b2Body* ShapeWorld::add_body(Vec2 position, b2BodyType type) {
  b2BodyDef definition;
  definition.type = type;
  definition.position = to_float(position);
  definition.allowSleep = false;
  return world.CreateBody(&definition);
}

b2Body* ShapeWorld::add_ball(Vec2 position, double radius, double mass, double friction) {
  b2Body* body = add_body(position);
  add_shape(body, circle(radius), mass / (std::numbers::pi * radius * radius), friction);
  return body;
}

b2Fixture* add_shape(b2Body* body, const b2Shape& shape, double density, double friction, b2Filter filter) {
  b2FixtureDef definition;
  definition.shape = &shape;
  definition.density = static_cast<float>(density);
  definition.friction = static_cast<float>(friction);
  definition.filter = filter;
  return body->CreateFixture(&definition);
}

b2CircleShape circle(double radius, Vec2 middle) {
  b2CircleShape shape;
  shape.m_radius = static_cast<float>(radius);
  shape.m_p = to_float(middle);
  return shape;
}

b2PolygonShape box(double half_width, double half_height) {
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(half_width), static_cast<float>(half_height));
  return shape;
}

b2EdgeShape edge(Vec2 a, Vec2 b) {
  b2EdgeShape shape;
  shape.SetTwoSided(to_float(a), to_float(b));
  return shape;
}

b2Filter filter(std::uint16_t category, std::uint16_t mask, std::int16_t group) {
  b2Filter result;
  result.categoryBits = category;
  result.maskBits = mask;
  result.groupIndex = group;
  return result;
}

Vec2 position(const b2Body* body) { return ribbon::box2d::to_double(body->GetWorldCenter()); }

void step_cords(ribbon::box2d::Coupling& coupling, b2World& world, double dt) {
  coupling.gather(world, dt);
  coupling.step();
  coupling.apply();
}

}  // namespace test_support
