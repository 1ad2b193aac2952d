#pragma once

#include <vector>

#include "ribbon/cord_forces.h"
#include "ribbon/island/step_context.h"

namespace ribbon {

/// Restitution after a substep: contacts that were hit open at their share of the speed with which they were hit. The
/// impulse for that is one linear solve with the mass of everything involved. The rates at which links change length
/// stay. It also takes the velocity from what a push (RigidBody::pushed) took along.
class Restitution {
 public:
  void resize(std::size_t slots) { velocities_.resize(slots); }
  /// Changes the velocities, by less if the energy has risen since `before`. Returns false if nothing was hit.
  bool apply(const StepContext& context, const CordEnergy& before, double dt);

 private:
  bool loses_energy(const IslandState& state) const;

  std::vector<Vec2> velocities_;  // before restitution
};

}  // namespace ribbon
