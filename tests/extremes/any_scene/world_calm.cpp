#include <algorithm>

#include "tests/extremes/any_scene/world.h"
#include "tests/support/slot.h"

namespace any_scene {
namespace {

constexpr double pay_out_speed = 10.0;  // m/s

using test_support::slot;

}  // namespace

void World::calm_down() {
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    const auto grip = coupling_.grip(grips_[k]);
    if (!grip.is_valid()) continue;
    if (scene_.solids[slot(scene_.holds[k].solid)].motion == Motion::kinematic) {
      grip.release();
    } else if (scene_.holds[k].climb_to >= 0.0) {
      grip.climb(grip.state().arc, scene_.holds[k].climb_speed);
    }
  }
  for (b2Body* body : bodies_) {
    if (body->GetType() != b2_kinematicBody) continue;
    body->SetLinearVelocity({0.0F, 0.0F});
    body->SetAngularVelocity(0.0F);
  }
  for (auto& [belt, speed] : belts_.speeds) speed = 0.0;
  for (const ribbon::box2d::PulleyId id : pulleys_) {
    if (coupling_.pulley(id).is_valid()) coupling_.pulley(id).set_motor(0.0, 0.0);
  }
  for (const Drag& drag : scene_.drags) {
    if (!coupling_.cord(drag.cord).is_valid()) continue;
    if (coupling_.cord(drag.cord).kind(drag.point) == ribbon::PointKind::operated)
      coupling_.cord(drag.cord).free(drag.point);
  }
  for (const Reel& reel : scene_.reels) {
    if (!coupling_.cord(reel.cord).is_valid()) continue;
    ribbon::Cord& cord = coupling_.cord(reel.cord).direct();
    double now = 0.0;
    for (int link = reel.first; link < reel.last; ++link) now += cord.rest_length(link);
    const ribbon::CordDef& def = scene_.cords[slot(reel.cord)].def;
    const double before = def.length * (reel.last - reel.first) / (def.points - 1);
    cord.reel(reel.first, reel.last, std::max(now, before), pay_out_speed);
  }
}

}  // namespace any_scene
