#include "tests/bits/bit_scenes.h"

#include <array>

#include "ribbon/box2d/state_hash.h"
#include "tests/bits/bit_builders.h"

namespace bits {
namespace {

using ribbon::box2d::Coupling;

constexpr std::array<BitScene, 14> scenes = {{
    {"ropes", build_ropes, drive_ropes, 180, 0x2313949e21ff234e},
    {"terms", build_terms, nullptr, 180, 0x1f093ee30310663a},
    {"ribbons", build_ribbons, nullptr, 180, 0xa39e4165796867ab},
    {"contacts", build_contacts, nullptr, 150, 0x71371f61cc7e85ac},
    {"grips", build_grips, drive_grips, 180, 0x93df58580d9e85ed},
    {"self_contact", build_self_contact, nullptr, 80, 0xf6d037c3e9595530},
    {"thesis", build_thesis, drive_thesis, 180, 0x96f7c81413124845},
    {"rough", build_rough, drive_rough, 120, 0xeece0e020e628143},
    {"asleep", build_asleep, drive_asleep, 220, 0x989154d14ca91a9a},
    {"ties", build_ties, drive_ties, 120, 0x6771478563cb70aa},
    {"cuts", build_cuts, drive_cuts, 100, 0x49714b874bd5ea9f},
    {"listener", build_listener, nullptr, 180, 0x9b8f3c3635d7e4a6},
    {"pulleys", build_pulleys, drive_pulleys, 120, 0x717ed5c667e562b0},
    {"wind", build_wind, drive_wind, 150, 0xf09d88afaacb4248},
}};

}  // namespace

void PrintTo(const BitScene& scene, std::ostream* out) { *out << scene.name; }

std::span<const BitScene> bit_scenes() { return scenes; }

b2Body& body(b2World& world, int n) {
  b2Body* found = world.GetBodyList();  // the newest
  for (int k = world.GetBodyCount() - 1; k > n; --k) found = found->GetNext();
  return *found;
}

void tick(const BitScene& scene, BitWorld& world, int number) {
  if (scene.drive != nullptr) scene.drive(world, number);
  world.coupling.tick(world.world, dt);
}

std::uint64_t hash_of(const Coupling& coupling, const b2World& world) {
  ribbon::box2d::Hasher hasher;
  add_to(hasher, coupling.save(world));
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    const b2Transform& transform = body->GetTransform();
    for (const float value : {transform.p.x, transform.p.y, transform.q.s, transform.q.c, body->GetAngle(),
                              body->GetLinearVelocity().x, body->GetLinearVelocity().y, body->GetAngularVelocity()}) {
      hasher.add(value);
    }
    hasher.add(body->IsAwake());
    hasher.add(coupling.body(*body).velocity());
  }
  return hasher.value();
}

std::uint64_t hash_of_run(const BitScene& scene) {
  BitWorld world;
  scene.build(world);
  ribbon::box2d::Hasher all;
  for (int k = 0; k < scene.ticks; ++k) {
    tick(scene, world, k);
    all.add(hash_of(world.coupling, world.world));
  }
  return all.value();
}

}  // namespace bits
