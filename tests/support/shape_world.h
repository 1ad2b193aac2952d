#pragma once

#include <box2d/box2d.h>

#include <cstdint>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "ribbon/vec2.h"
#include "tests/support/constants.h"

namespace test_support {

/// A Box2D world of 60 ticks per second with cords, and with bodies of any shape that do not sleep.
struct ShapeWorld {
  explicit ShapeWorld(ribbon::Vec2 gravity = {0.0, -9.81}) : world(ribbon::box2d::to_float(gravity)) {}

  static constexpr double dt = constants::dt;  // s

  void tick();
  void tick(int times) {
    for (int k = 0; k < times; ++k) tick();
  }
  b2Body* add_body(ribbon::Vec2 position, b2BodyType type = b2_dynamicBody);
  /// Adds a ball of this mass [kg].
  b2Body* add_ball(ribbon::Vec2 position, double radius, double mass, double friction = 0.5);
  /// All of a tick but world.Step: gather, step and apply.
  void step_cords();
  const ribbon::Cord& cord() const { return coupling.cord(0).direct(); }

  b2World world;
  ribbon::box2d::Coupling coupling{};
};

b2Fixture* add_shape(b2Body* body, const b2Shape& shape, double density, double friction, b2Filter filter = {});

b2CircleShape circle(double radius, ribbon::Vec2 middle = {});
b2PolygonShape box(double half_width, double half_height);
b2EdgeShape edge(ribbon::Vec2 a, ribbon::Vec2 b);

b2Filter filter(std::uint16_t category, std::uint16_t mask, std::int16_t group = 0);

/// Returns the position of the centre of mass, m.
ribbon::Vec2 position(const b2Body* body);

/// All of a tick but world.Step: gather, step and apply.
void step_cords(ribbon::box2d::Coupling& coupling, b2World& world, double dt);

}  // namespace test_support
