#pragma once

#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "ribbon/box2d/contact_listener.h"
#include "tests/engine/coupling/grip_world.h"

namespace engine {

using ribbon::box2d::ContactListener;
using ribbon::box2d::CordId;
using ribbon::box2d::SensorEvent;
using ribbon::box2d::Surface;

/// An event, without its number.
using Seen = std::tuple<CordId, bool, const b2Fixture*>;

/// Collects what it is told.
struct Hears : ContactListener {
  bool pre_solve(CordId /*cord*/, const b2Fixture& fixture, Surface& /*surface*/) override {
    EXPECT_FALSE(fixture.IsSensor());
    return true;
  }
  bool should_meet_sensor(CordId cord, const b2Fixture& /*sensor*/) override {
    ++asked;
    return cord != refused;
  }
  void sensor_event(const SensorEvent& event) override { heard.emplace_back(event.cord, event.begins, event.fixture); }
  CordId refused = -1;
  int asked = 0;
  std::vector<Seen> heard;
};

/// A world whose events are collected tick by tick.
struct SensorWorld : GripWorld {
  b2Fixture* add_sensor(Vec2 position, const b2Shape& shape, b2BodyType type = b2_staticBody, b2Filter filter = {}) {
    b2BodyDef def;
    def.type = type;
    def.gravityScale = 0.0F;
    def.position = ribbon::box2d::to_float(position);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.isSensor = true;
    fixture.filter = filter;
    fixture.density = density;
    return world.CreateBody(&def)->CreateFixture(&fixture);
  }
  b2Fixture* add_box(Vec2 position, float half, b2BodyType type = b2_staticBody, b2Filter filter = {}) {
    b2PolygonShape box;
    box.SetAsBox(half, half);
    return add_sensor(position, box, type, filter);
  }
  CordId add_rope(double x, double y, Vec2 velocity = {}, bool sleeps = false) {
    CordDef def;
    def.points = 11;
    def.length = 1.0;
    def.radius = 0.02;
    def.allow_sleep = sleeps;
    if (sleeps) def.pins = {0, 10};
    if (sleeps) def.drag = 5.0;
    def.positions = test_support::equally_spaced(def.points, {x - 0.5, y}, {0.1, 0.0});
    Cord cord(def);
    for (int p = 0; p < cord.size(); ++p) {
      if (!sleeps) cord.set_velocity(p, velocity);
    }
    return coupling.add(std::move(cord));
  }
  /// Runs ticks and returns their events.
  std::vector<Seen> run(int ticks) {
    std::vector<Seen> seen;
    for (int k = 0; k < ticks; ++k) {
      tick();
      for (const SensorEvent& event : coupling.last_step().sensor_events()) {
        seen.emplace_back(event.cord, event.begins, event.fixture);
        EXPECT_EQ(event.number != 0, event.fixture != nullptr);
        EXPECT_EQ(coupling.fixture(event.number), event.fixture);
      }
    }
    return seen;
  }
  float density = 1.0F;
};

}  // namespace engine
