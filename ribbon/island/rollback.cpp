#include "ribbon/island/rollback.h"

#include <algorithm>
#include <cmath>

#include "ribbon/cord_forces.h"
#include "ribbon/island/momentum.h"
#include "ribbon/system/stretch.h"

namespace ribbon {
namespace {

constexpr int max_reductions = 6;
constexpr double max_gain = 1e-3;  // of the scene's energy

}  // namespace

void Rollback::resize(std::size_t slots, std::size_t tensions) {
  end_positions_.resize(slots);
  end_velocities_.resize(slots);
  end_tensions_.resize(tensions);
  offsets_.resize(tensions);
}

bool Rollback::apply(const StepContext& context, const CordEnergy& before, bool truncated) {
  IslandState& state = context.state;
  // Of a way that drives make, nothing can be taken back. Belts make none, but give an energy that is not known.
  if (state.frame_velocity != Vec2{} || EnergyGuard::is_moved(state, context.contacts)) return limit_speeds(state);
  if (EnergyGuard::is_driven(state, context.contacts)) {
    const bool limited = limit_speeds(state);
    if (!is_stretched(state)) return limited;
    begin(context);
    take_stretched_back(context);
    return true;
  }
  const bool limited = state.in_medium && limit_speeds(state);
  const auto is_sound = [&] { return !context.gained_energy(before, max_gain) && !is_stretched(state); };
  if (is_sound()) return limited;
  begin(context);
  if (truncated) context.contacts.linearised.forget_forces(context.contacts.forces);
  take_stretched_back(context);
  if (is_sound()) return true;
  if (!truncated) context.contacts.linearised.clear();
  state.taken_back = true;
  double share = 1.0;
  for (int k = 0; k < max_reductions && !is_sound(); ++k) {
    share = k + 1 < max_reductions ? 0.5 * share : 0.0;
    go_to(context, share);
  }
  // At the start, depths that were already there may hold more energy than the forces that the piece began with.
  if (!truncated && !is_sound()) context.contacts.linearised.forget_forces(context.contacts.forces);
  return true;
}

void Rollback::fit_tensions(const StepContext& context) {
  IslandState& state = context.state;
  begin(context);
  go_to(context, 1.0);
  for (const Member& member : state.members) {
    if (!std::isfinite(member.cord->def.stretch_stiffness)) continue;
    const auto fitted = IslandState::tensions_of(member, state.tensions);
    std::copy(fitted.begin(), fitted.end(), IslandState::tensions_of(member, end_tensions_).begin());
  }
  state.tensions.swap(end_tensions_);
}

/// Stores the end of the piece, to which every group makes all of its way.
void Rollback::begin(const StepContext& context) {
  end_positions_ = context.state.positions;
  end_velocities_ = context.state.velocities;
  end_tensions_ = context.state.tensions;
  context.stages.groups().begin(context.state);
}

/// A cord that others stop may be stretched again, so this is repeated.
void Rollback::take_stretched_back(const StepContext& context) {
  IslandState& state = context.state;
  MotionGroups& groups = context.stages.groups();
  for (int k = 0; k < max_reductions && is_stretched(state); ++k) {
    for (const Member& member : state.members) {
      if (!is_stretched(state, member)) continue;
      groups.reduce(member.first_point, k + 1 < max_reductions ? 0.5 : 0.0);
    }
    groups.separate(context.contacts, state.start.positions, end_positions_);
    go_to(context, 1.0);
  }
}

/// Goes to a share of the way that each group makes from the start of the piece to its end, with that share of its
/// velocities. The elastic tensions change as those of the shape do. A piece that follows an unsolved one begins with
/// other tensions than those of its shape.
void Rollback::go_to(const StepContext& context, double share) {
  IslandState& state = context.state;
  state.return_to_start();
  state.add_damping(-1.0);
  offsets_ = state.tensions;
  state.find_tensions();
  for (std::size_t e = 0; e < state.tensions.size(); ++e) offsets_[e] -= state.tensions[e];
  for (std::size_t p = 0; p < state.slots(); ++p) {
    const double of_slot = share * context.stages.groups().share(p);
    state.positions[p] += of_slot * (end_positions_[p] - state.start.positions[p]);
    state.velocities[p] = of_slot * end_velocities_[p];
  }
  state.find_tensions();
  for (const Member& member : state.members) {
    for (std::size_t e = member.first_tension; e < member.first_tension + member.tensions; ++e) {
      state.tensions[e] += offsets_[e];
      if (member.cord->def.tension_only) state.tensions[e] = std::max(0.0, state.tensions[e]);
    }
  }
  state.add_damping(1.0);
}

}  // namespace ribbon
