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
/// Returns about the largest change of a point's velocity by a medium in a step of dt seconds, m/s. O(points), O(1)
/// without a medium.
double max_medium_delta_v(const CordParts& cord, const Surroundings& surroundings, double dt, Vec2 gravity);

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
