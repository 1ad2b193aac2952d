#pragma once

#include <vector>

#include "engine/scene/scene.h"
#include "ribbon/vec2.h"

namespace game {

/// The positions after a tick, for interpolated drawing.
struct Snapshot {
  struct Body {
    ribbon::Vec2 position;  ///< m
    double angle = 0.0;     ///< rad
  };
  struct Wheel {
    ribbon::Vec2 center;  ///< m
    double radius = 0.0;  ///< m, of the groove; 0 for a wheel that is gone
    double angle = 0.0;   ///< rad
  };
  std::vector<std::vector<ribbon::Vec2>> cords;  ///< m, by id of the cord and point; empty for one that is gone
  std::vector<Body> bodies;                      ///< in the order of creation
  std::vector<Wheel> wheels;                     ///< as engine::Scene::wheels
};

/// Interpolates linearly; `alpha` is 0 … 1 for `from` … `to`, which must be of the same world.
Snapshot interpolate(const Snapshot& from, const Snapshot& to, double alpha);

/// Overwrites the snapshot with the positions of now; without a scene it has no wheels.
/// @{
void take_snapshot(Snapshot& snapshot, const engine::Scene& scene);
void take_snapshot(Snapshot& snapshot, const b2World& world, const ribbon::box2d::Coupling& coupling);
/// @}

}  // namespace game
