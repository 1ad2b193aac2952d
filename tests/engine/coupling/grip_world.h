#pragma once

#include <box2d/box2d.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>

#include "ribbon/box2d/convert.h"
#include "ribbon/box2d/coupling.h"
#include "tests/support/constants.h"
#include "tests/support/points.h"
#include "tests/support/refusal.h"

namespace engine {

using ribbon::Cord;
using ribbon::CordDef;
using ribbon::Vec2;

using constants::dt;
using constants::g;

/// A Box2D world with cords, and bodies of 0.2 m radius that hold cords and touch nothing.
struct GripWorld {
  void tick(int times = 1) {
    for (int k = 0; k < times; ++k) coupling.tick(world, dt);
  }
  b2Body* add_body(Vec2 position, double mass, b2BodyType type = b2_dynamicBody) {
    b2BodyDef definition;
    definition.type = type;
    definition.position = ribbon::box2d::to_float(position);
    definition.allowSleep = false;
    b2Body* body = world.CreateBody(&definition);
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = static_cast<float>(mass / (std::numbers::pi * 0.04));
    fixture.filter.maskBits = 0;  // it collides with nothing
    body->CreateFixture(&fixture);
    return body;
  }
  /// Returns the position at `arc` [m] from the start of a cord of equal links.
  Vec2 place(ribbon::box2d::CordId cord, double arc) const {
    const Cord& direct = coupling.cord(cord).direct();
    const double link = direct.rest_length(0);
    const auto i = static_cast<std::size_t>(std::min(arc / link, direct.def().points - 2.0));
    const double share = arc / link - static_cast<double>(i);
    return direct.positions()[i] + share * (direct.positions()[i + 1] - direct.positions()[i]);
  }

  b2World world{b2Vec2(0.0F, -static_cast<float>(g))};
  ribbon::box2d::Coupling coupling;
};

/// Returns the state without the estimates of errors, which not every run has.
inline ribbon::box2d::CouplingState state_without_errors(const GripWorld& scene) {
  ribbon::box2d::CouplingState state = scene.coupling.save(scene.world);
  for (ribbon::box2d::CouplingState::Cord& cord : state.cords) cord.error = 0.0;
  return state;
}

/// Returns the message of the `Error` that a call throws inside the step of a world, when two balls far away meet.
template <typename Error, typename Call>
std::string refusal_in_step(GripWorld& scene, const Call& call) {
  struct Listener : b2ContactListener {
    explicit Listener(const Call& to_try) : call(to_try) {}
    void BeginContact(b2Contact* /*contact*/) override { message = test_support::refusal<Error>(call); }
    const Call& call;
    std::string message = "no step";
  } listener(call);
  scene.world.SetContactListener(&listener);
  for (const float y : {0.0F, 0.3F}) {
    b2BodyDef def;
    def.type = b2_dynamicBody;
    def.position.Set(20.0F, y);
    b2CircleShape circle;
    circle.m_radius = 0.2F;
    scene.world.CreateBody(&def)->CreateFixture(&circle, 1.0F);
  }
  scene.tick(2);
  scene.world.SetContactListener(nullptr);
  return listener.message;
}

/// A cord of 10 m that hangs straight down from (x, 0).
inline CordDef hanging(double x = 0.0) {
  CordDef def;
  def.pins = {0};
  def.positions = test_support::equally_spaced(def.points, {x, 0.0}, {0.0, -0.2});
  return def;
}

/// A cord of 2 m, level and fixed at both ends.
inline CordDef taut() {
  CordDef def;
  def.points = 21;
  def.length = 2.0;
  def.pins = {0, 20};
  return def;
}

/// Destroys a body without telling the coupling, and has Box2D make another at the same address.
inline b2Body* recreate(GripWorld& scene, b2Body* body, Vec2 position, double mass) {
  scene.world.DestroyBody(body);
  b2Body* next = scene.add_body(position, mass);
  EXPECT_EQ(next, body) << "Box2D likes to use the same address again";
  return next;
}

}  // namespace engine
