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
    {"ribbons", build_ribbons, nullptr, 180, 0x52e54ab7661cc2f6},
    {"contacts", build_contacts, nullptr, 150, 0x9e5f509e45353bf7},
    {"grips", build_grips, drive_grips, 180, 0x2618f57b13e70fd7},
    {"self_contact", build_self_contact, nullptr, 80, 0xf8290d85e2ffc407},
    {"thesis", build_thesis, drive_thesis, 180, 0x73170f821532aa5a},
    {"rough", build_rough, drive_rough, 120, 0x69913dd1557736c8},
    {"asleep", build_asleep, drive_asleep, 220, 0x92f1a7f546f39269},
    {"ties", build_ties, drive_ties, 120, 0xfb79683c45caa0ed},
    {"cuts", build_cuts, drive_cuts, 100, 0x49714b874bd5ea9f},
    {"listener", build_listener, nullptr, 180, 0x2553b4b42438f346},
    {"pulleys", build_pulleys, drive_pulleys, 120, 0xd1dbf78c03730422},
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
