#pragma once

#include <box2d/box2d.h>

#include <array>
#include <cmath>
#include <functional>

#include "ribbon/box2d/world_snapshot.h"

namespace engine::snapshots {

using ribbon::box2d::WorldSnapshot;

constexpr float dt = 1.0F / 60.0F;
constexpr int back = 8;  // ticks

inline b2Body& add_box(b2World& world, b2Vec2 position, b2BodyType type = b2_dynamicBody, float half_width = 0.5F) {
  b2BodyDef def;
  def.type = type;
  def.position = position;
  b2PolygonShape box;
  box.SetAsBox(half_width, 0.5F);
  b2Body* body = world.CreateBody(&def);
  body->CreateFixture(&box, 1.0F);
  return *body;
}

inline b2Body& add_ball(b2World& world, b2Vec2 position, b2Vec2 velocity = b2Vec2_zero) {
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = position;
  def.linearVelocity = velocity;
  b2CircleShape circle;
  circle.m_radius = 0.4F;
  b2Body* body = world.CreateBody(&def);
  body->CreateFixture(&circle, 1.0F);
  return *body;
}

/// A world with a floor, whose upper side is at 0, and a snapshot of each tick.
struct SavedWorld {
  SavedWorld() { add_box(world, {0.0F, -0.5F}, b2_staticBody, 30.0F); }

  /// `act` is what the game does in the first of these ticks, after the snapshot.
  void tick(
      int times = 1, const std::function<void()>& act = [] {}) {
    for (int k = 0; k < times; ++k) {
      at(ticks++).save(world);
      if (k == 0) act();
      world.Step(dt, 8, 3);
    }
  }
  /// The snapshot before tick `number`, from 0. The last of them are stored.
  WorldSnapshot& at(int number) { return snapshots.at(static_cast<std::size_t>(number) % snapshots.size()); }
  void go_back() {
    ticks -= back;
    at(ticks).restore(world, ticks > 0 ? &at(ticks - 1) : nullptr);
  }

  b2World world{b2Vec2(0.0F, -9.81F)};
  int ticks = 0;
  std::array<WorldSnapshot, back + 2> snapshots;
};

inline void drop_boxes(SavedWorld& world, int count) {
  for (int k = 0; k < count; ++k) {
    const auto column = static_cast<float>(k % 6);
    const int row = k / 6;
    const float aside = 0.1F * std::sin(7.0F * static_cast<float>(k));
    const b2Vec2 place(1.1F * column + aside, 1.0F + 1.05F * static_cast<float>(row));
    k % 3 == 2 ? add_ball(world.world, place) : add_box(world.world, place);
  }
}

}  // namespace engine::snapshots
