#pragma once

#include "ribbon/vec2.h"

namespace ribbon {

class Cord;

/// What a medium is at a place and time. All zero is empty space.
struct MediumSample {
  Vec2 velocity;         ///< m/s, within ±1e6 in each component
  double density = 0.0;  ///< kg/m³, 0 … 1e6
  /// kg/m⁴, gradient of the density. It steadies what floats where the density changes steeply. Zero is accepted.
  Vec2 density_gradient{};
};

/// Interface of what flows around cords, such as wind and water: a function of place and time. It acts on cords that
/// declare CordDef::drag_across, drag_along or displaced_area, and not on bodies. Cords do not act on it.
class Medium {
 public:
  virtual ~Medium() = default;

  /// Returns the medium at `place` [m] at `time` [s], for a piece of cord that reaches from `half_height` [m, above 0]
  /// below that place to as much above it. If a surface is within these limits, return the mean of what is below and
  /// above, so that the force has no jump there. A sample out of range counts as empty space. The result must depend on
  /// the arguments only: then a step that is repeated has the same bits. It is called several times per point and step,
  /// and with DirectSolver::use from several threads at once. It must not throw.
  virtual MediumSample at(Vec2 place, double half_height, double time) const = 0;
};

/// Returns how much the medium may change the velocity of a cord in the step of dt seconds that begins at `time` [s],
/// under `gravity` [m/s²]; m/s, about: 0 if it does not act on the cord. O(points).
double medium_delta_v(const Cord& cord, const Medium& medium, double time, double dt, Vec2 gravity);

}  // namespace ribbon
