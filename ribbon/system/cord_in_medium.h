#pragma once

#include <cstddef>
#include <span>

#include "ribbon/elastic/stage.h"
#include "ribbon/medium.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {

/// Returns whether something is around a point of a cord that declares a coefficient. O(1) if it is around the first.
bool is_in_medium(const CordParts& cord, const Surroundings& surroundings);
/// How a medium may move a cord in a step, about.
struct MediumPush {
  double delta_v = 0.0;         ///< m/s, largest change of a point's velocity
  double relative_speed = 0.0;  ///< m/s, highest one of a point
  double impulse = 0.0;         ///< N·s, sum of those on all points
};
/// Returns it for a step of dt seconds under `gravity` [m/s²]. O(points), O(1) without a medium.
MediumPush max_medium_push(const CordParts& cord, const Surroundings& surroundings, double dt, Vec2 gravity);

/// The motion that a stage predicts for a cord.
struct PredictedMotion {
  std::span<const Vec2> x;  ///< m
  std::span<const Vec2> v;  ///< m/s
  double q;                 ///< s, see Stage
  double time;              ///< s, at the end of the stage, for the medium
  Vec2 gravity;             ///< m/s²
};
/// Writes what a medium does to each point of a cord on which it acts: the force at the predicted motion [N], and its
/// decrease with a displacement from there [N/m], which is positive semidefinite.
void find_medium_loads(const CordParts& cord, const Surroundings& surroundings, const PredictedMotion& motion,
                       std::span<Vec2> forces, std::span<Block> resistances);

}  // namespace ribbon
