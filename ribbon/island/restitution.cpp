#include "ribbon/island/restitution.h"
#include "ribbon/cord_forces.h"

namespace ribbon {
namespace {

constexpr double reduction = 0.8;  // of the impulse, until the energy has not risen
constexpr double min_share = 0.1;  // of the impulse: one that has to be less is left out

}  // namespace

bool Restitution::apply(const StepContext& context, const CordEnergy& before, double dt) {
  IslandState& state = context.state;
  const ImpactVelocities velocities{state.start.velocities, state.velocities, state.pushes};
  if (!context.contacts.begin_restitution(state.positions, velocities, dt)) return false;
  const std::vector<Vec2>* change = context.stages.find_restitution(state, context.contacts, dt);
  context.contacts.end_restitution(state.positions, change);
  if (change == nullptr) return false;
  velocities_ = state.velocities;
  state.add_damping(-1.0);
  for (double share = 1.0; share > min_share; share *= reduction) {
    for (std::size_t p = 0; p < state.slots(); ++p) {
      if (state.constrained[p] == 0) state.velocities[p] = velocities_[p] + (share / dt) * (*change)[p];
    }
    state.restart = true;
    state.add_damping(1.0);
    if (loses_energy(state) || !context.gained_energy(before, EnergyGuard::tolerated_gain)) {
      context.contacts.impacts.record_restitution(share, dt);
      return true;
    }
    state.add_damping(-1.0);
  }
  state.velocities = velocities_;
  state.add_damping(1.0);
  return true;
}

/// Returns whether pushes have given more kinetic energy than is left. `velocities_` are those before restitution. The
/// energy of the island is no measure: it has that of the pushes, which goes back to what was pushed.
bool Restitution::loses_energy(const IslandState& state) const {
  double gain = 0.0;
  for (std::size_t p = 0; p < state.pushes.size(); ++p) {
    const Vec2 before = velocities_[p] - state.pushes[p];
    const Vec2 after = state.velocities[p] - state.pushes[p];
    gain += state.masses[p] * (dot(after, after) - dot(before, before));
  }
  return gain < 0.0;
}

}  // namespace ribbon
