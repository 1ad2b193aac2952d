#include "game/simulation/snapshot.h"

#include <cstddef>

#include "game/simulation/index.h"
#include "ribbon/box2d/convert.h"

namespace game {
namespace {

using ribbon::Vec2;
using ribbon::box2d::to_double;

}  // namespace

Snapshot interpolate(const Snapshot& from, const Snapshot& to, double alpha) {
  Snapshot between = to;
  for (std::size_t c = 0; c < to.cords.size(); ++c) {
    if (c >= from.cords.size() || from.cords[c].size() != to.cords[c].size())
      continue;  // a piece that has just been cut
    for (std::size_t p = 0; p < to.cords[c].size(); ++p) {
      between.cords[c][p] = from.cords[c][p] + alpha * (to.cords[c][p] - from.cords[c][p]);
    }
  }
  for (std::size_t b = 0; b < to.bodies.size(); ++b) {
    between.bodies[b].position = from.bodies[b].position + alpha * (to.bodies[b].position - from.bodies[b].position);
    between.bodies[b].angle = from.bodies[b].angle + alpha * (to.bodies[b].angle - from.bodies[b].angle);
  }
  for (std::size_t w = 0; w < to.wheels.size(); ++w) {
    between.wheels[w].center = from.wheels[w].center + alpha * (to.wheels[w].center - from.wheels[w].center);
    between.wheels[w].angle = from.wheels[w].angle + alpha * (to.wheels[w].angle - from.wheels[w].angle);
  }
  return between;
}

void take_snapshot(Snapshot& snapshot, const b2World& world, const ribbon::box2d::Coupling& coupling) {
  const auto ids = coupling.cords();
  snapshot.cords.resize(ids.empty() ? 0 : at(ids.back()) + 1);
  for (std::vector<Vec2>& cord : snapshot.cords) cord.clear();
  for (const ribbon::box2d::CordId id : ids) {
    const auto positions = coupling.cord(id).positions();
    snapshot.cords[at(id)].assign(positions.begin(), positions.end());
  }
  auto index = static_cast<std::size_t>(world.GetBodyCount());
  snapshot.bodies.resize(index);
  for (const b2Body* body = world.GetBodyList(); body != nullptr; body = body->GetNext()) {
    snapshot.bodies[--index] = {to_double(body->GetPosition()), static_cast<double>(body->GetAngle())};
  }
  snapshot.wheels.clear();
}

void take_snapshot(Snapshot& snapshot, const engine::Scene& scene) {
  take_snapshot(snapshot, scene.world(), scene.coupling());
  for (const engine::SceneWheel& wheel : scene.wheels()) {
    const ribbon::box2d::PulleyView pulley = scene.coupling().pulley(wheel.pulley);
    snapshot.wheels.emplace_back();
    if (!pulley.is_valid()) continue;
    const ribbon::box2d::PulleyState state = pulley.state();
    snapshot.wheels.back() = {state.center, state.def.radius, state.angle};
  }
}

}  // namespace game
