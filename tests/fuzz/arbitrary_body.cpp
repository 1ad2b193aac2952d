#include "tests/fuzz/arbitrary_body.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fuzz {
namespace {

constexpr double max_coordinate = 1e6;  // m, m/s: beyond this Box2D itself loses collisions

float single(double value) { return static_cast<float>(value); }

float finite_float(Bytes& bytes, double low, double high) {
  const double value = bytes.number(low, high);
  return std::isfinite(value) ? single(std::clamp(value, -max_coordinate, max_coordinate)) : 0.0F;
}

b2Vec2 finite_vector(Bytes& bytes, double low, double high) {
  const float x = finite_float(bytes, low, high);
  return {x, finite_float(bytes, low, high)};
}

void add_fixture(b2Body& body, Bytes& bytes) {
  b2FixtureDef def;
  def.density = std::abs(finite_float(bytes, 0.0, 100.0));
  def.friction = single(bytes.number(0.0, 1.0));
  def.restitution = single(bytes.number(0.0, 1.0));
  def.isSensor = bytes.below(16) == 0;
  const float size = std::max(0.01F, std::abs(finite_float(bytes, 0.05, 0.5)));
  b2CircleShape circle;
  b2PolygonShape box;
  b2EdgeShape edge;
  b2ChainShape chain;
  const std::array<b2Vec2, 4> corners = {b2Vec2{-size, 0.0F}, {0.0F, size}, {size, 0.0F}, {0.0F, -size}};
  switch (bytes.below(5)) {
    case 0:
    case 1:
      circle.m_radius = size;
      circle.m_p = {0.004F * static_cast<float>(bytes.below(250)) - 0.5F, 0.0F};
      def.shape = &circle;
      break;
    case 2:
      box.SetAsBox(size, 0.5F * size);
      def.shape = &box;
      break;
    case 3:
      edge.SetTwoSided({-size, 0.0F}, {size, 0.1F});
      def.shape = &edge;
      break;
    default: chain.CreateLoop(corners.data(), static_cast<int32>(corners.size())); def.shape = &chain;
  }
  body.CreateFixture(&def);
}

}  // namespace

b2Body& add_arbitrary_body(b2World& world, Bytes& bytes) {
  constexpr std::array types = {b2_dynamicBody, b2_dynamicBody, b2_kinematicBody, b2_staticBody};
  b2BodyDef def;
  def.type = types[bytes.byte() % types.size()];
  def.position = finite_vector(bytes, -2.0, 2.0);
  def.angle = finite_float(bytes, -3.0, 3.0);
  if (bytes.boolean()) def.linearVelocity = finite_vector(bytes, -10.0, 10.0);
  if (bytes.boolean()) def.angularVelocity = finite_float(bytes, -10.0, 10.0);
  if (bytes.below(4) == 0) def.linearDamping = std::abs(finite_float(bytes, 0.0, 1.0));
  if (bytes.below(4) == 0) def.gravityScale = single(bytes.number(-1.0, 2.0));
  def.fixedRotation = bytes.below(4) == 0;
  def.bullet = bytes.below(8) == 0;
  b2Body& body = *world.CreateBody(&def);
  for (int k = bytes.below(3); k >= 0; --k) add_fixture(body, bytes);
  return body;
}

void disturb(b2Body& body, Bytes& bytes) {
  switch (bytes.below(7)) {
    case 0: body.SetTransform(finite_vector(bytes, -2.0, 2.0), finite_float(bytes, -3.0, 3.0)); break;
    case 1: body.SetLinearVelocity(finite_vector(bytes, -10.0, 10.0)); break;
    case 2: body.SetAngularVelocity(finite_float(bytes, -10.0, 10.0)); break;
    case 3: body.SetEnabled(bytes.boolean()); break;
    case 4: body.SetType(bytes.boolean() ? b2_dynamicBody : b2_kinematicBody); break;
    case 5: body.ApplyLinearImpulseToCenter(finite_vector(bytes, -10.0, 10.0), true); break;
    default: {
      b2MassData mass;
      mass.mass = std::abs(finite_float(bytes, 0.01, 100.0));
      mass.center.SetZero();
      mass.I = std::abs(finite_float(bytes, 0.0, 10.0));
      body.SetMassData(&mass);
    }
  }
}

b2Vec2 arbitrary_anchor(Bytes& bytes) {
  const float x = single(bytes.number(-1.0, 1.0));
  return {x, single(bytes.number(-1.0, 1.0))};
}

}  // namespace fuzz
