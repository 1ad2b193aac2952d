// Prints a hash of all bits of a ribbon and a rope in a Box2D world, one second after a ball starts to fall on them.
#include <box2d/box2d.h>

#include <cstdio>

#include "ribbon/box2d/coupling.h"
#include "ribbon/box2d/state_hash.h"
#include "ribbon/layout.h"

int main() {
  b2World world({0.0F, -9.75F});
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = {0.5F, 0.5F};
  b2Body* ball = world.CreateBody(&def);
  b2CircleShape circle;
  circle.m_radius = 0.25F;
  ball->CreateFixture(&circle, 4.0F);

  ribbon::box2d::Coupling cords;
  ribbon::CordDef rope;
  rope.points = 21;
  rope.bending_stiffness = 0.01;
  rope.pins = {0, 20};
  lay_along(rope, {{-1.0, 0.0}, {0.25, -0.5}, {2.0, 0.0}});
  cords.add(ribbon::Cord(rope));
  ribbon::CordDef cloth;
  cloth.points = 17;
  cloth.rows = 3;
  cloth.pins = {0, 1, 2, 48, 49, 50};
  lay_along(cloth, {{-1.0, -1.0}, {2.0, -1.0}});
  ribbon::solid(1e5, 0.25, 0.01, cloth.width).apply_to(cloth);
  cords.add(ribbon::Cord(cloth));
  for (int tick = 0; tick < 60; ++tick) {
    cords.tick(world, 1.0 / 64.0);
  }
  ribbon::box2d::Hasher hasher;
  add_to(hasher, cords.save(world));
  std::printf("%s\n", ribbon::box2d::to_hex(hasher.value()).c_str());
}
