#pragma once

#include <cstddef>
#include <span>

#include "ribbon/elastic/stage.h"
#include "ribbon/medium.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/system/cord_parts.h"

namespace ribbon {

/// What a medium may do to a cord in a step.
struct MediumEffect {
  bool acts = false;     ///< something is there, and the cord declares a coefficient
  double delta_v = 0.0;  ///< m/s, about the largest change of a point's velocity
};
/// Returns it for a step of dt seconds under `gravity` [m/s²]. O(points), O(1) without a medium.
MediumEffect find_medium_effect(const CordParts& cord, const Surroundings& surroundings, double dt, Vec2 gravity);

/// Returns the medium at the point of a cord whose points are at x; see Medium::at.
MediumSample sample_at(const CordParts& cord, const Surroundings& surroundings, std::span<const Vec2> x,
                       std::size_t point, double time);

/// What a medium does to a point in a stage: the force at the predicted motion, and its decrease with a displacement
/// from there. It is linear in the displacement, and positive semidefinite.
struct MediumLoad {
  Vec2 force;                       ///< N
  Block resistance{0.0, 0.0, 0.0};  ///< N/m
};

/// The motion that a stage predicts for a cord.
struct PredictedMotion {
  std::span<const Vec2> x;  ///< m
  std::span<const Vec2> v;  ///< m/s
  double q;                 ///< s, see Stage
  double time;              ///< s, at the end of the stage, for the medium
  Vec2 gravity;             ///< m/s²
};
/// Returns the load of a point of a cord on which a medium acts.
MediumLoad medium_load(const CordParts& cord, const Surroundings& surroundings, const PredictedMotion& motion,
                       std::size_t point);

}  // namespace ribbon
