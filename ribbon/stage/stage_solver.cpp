#include "ribbon/stage/stage_solver.h"

#include <algorithm>
#include <utility>

#include "ribbon/system/cord_in_medium.h"
#include "ribbon/system/grips.h"
#include "ribbon/system/supports.h"
#include "ribbon/system/wheels.h"

namespace ribbon {

void StageSolver::resize(std::size_t slots, std::size_t tensions, std::size_t grips) {
  prediction.positions.resize(slots);
  prediction.velocities.resize(slots);
  inertia_.resize(slots);
  force_.resize(slots);
  newton_.resize(slots, tensions, grips);
  free_stage_.resize(slots, tensions);
  contact_stage_.resize(slots);
  linearised_stage_.resize(slots, tensions);
}

void StageSolver::set_contact_solve(ContactSolve solve) {
  contact_solve_ = solve;
  discard_pattern();
}

bool StageSolver::solve(IslandState& state, Contacts& contacts, const MotionBounds& bounds, StepWork& work,
                        const StageRequest& request) {
  ++work.report.stages;
  load_forces(state, request);
  state.supports.stage_begins = true;
  Stage stage{request.q, prediction.positions, prediction.velocities, inertia_, force_, state.constrained};
  if (state.in_medium) stage.resistance = resistance_;
  stage.implicit_euler = request.euler;
  const bool converged = solve_contacts({state, contacts, newton_, work}, bounds, request, stage);
  const double inverse_q2 = 1.0 / (request.q * request.q);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    state.accelerations[p] = inverse_q2 * (state.positions[p] - prediction.positions[p]);
    state.velocities[p] = prediction.velocities[p] + request.q * state.accelerations[p];
  }
  if (state.in_medium) find_medium_forces(state);
  end_stage_of_supports(state);
  if (!request.euler) return converged;
  for (const Member& member : state.members) {
    member.cord->elasticity->add_rotational_damping(IslandState::stage_of(stage, member),
                                                    IslandState::points_of(member, state.positions),
                                                    IslandState::tensions_of(member, state.tensions));
  }
  return converged;
}

bool StageSolver::solve_contacts(const StageContext& context, const MotionBounds& bounds, const StageRequest& request,
                                 Stage& stage) {
  if (contact_solve_ == ContactSolve::newton) {
    return context.contacts.empty() ? free_stage_.solve(context, stage) : contact_stage_.solve(context, request, stage);
  }
  linearised_result_ = linearised_stage_.solve(context, bounds, request, stage, contact_solve_);
  return linearised_result_.converged;
}

void StageSolver::load_forces(IslandState& state, const StageRequest& request) {
  const double inverse_q2 = 1.0 / (request.q * request.q);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    inertia_[p] = state.masses[p] * inverse_q2;
    force_[p] = state.masses[p] * state.free_accelerations[p];
  }
  for (HeldBody& held : state.held) held.share = request.time / state.dt;
  place_driven(state, request.time);
  state.place_gaps(request.time);
  for (const Member& member : state.members) {
    load_member(state, member, request);
    if (move_climbing_grips(state, member)) discard_pattern();
  }
  if (state.in_medium) load_medium(state, request);
  load_wheel_forces(state, force_);
}

/// What is driven moves at constant velocity from where the step found it to its target.
void StageSolver::place_driven(IslandState& state, double time) {
  state.now = time;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] == 0) continue;
    state.positions[p] = prediction.positions[p] = state.drive_starts[p] + time * state.drive_velocities[p];
    prediction.velocities[p] = state.drive_velocities[p];
  }
}

/// What a cord alone declares: loads, drag, and rest lengths that change in the step. Drag acts on the cord's own mass
/// and not on what is attached to it: with c = drag·m,
///
///     −c·v = −c·ṽ − q·c·a.
void StageSolver::load_member(const IslandState& state, const Member& member, const StageRequest& request) {
  CordParts& cord = *member.cord;
  for (std::size_t p = 0; p < cord.state.loads.size(); ++p) force_[member.first_point + p] += cord.state.loads[p];
  if (cord.def.drag > 0.0) {
    for (std::size_t i = 0; i < member.points; ++i) {
      const std::size_t p = member.first_point + i;
      const double c = cord.def.drag * cord.own_masses[i];
      inertia_[p] += c / request.q;
      force_[p] -= c * prediction.velocities[p];
    }
  }
  if (state.reeling && !cord.rest_start.empty()) {
    const double share = request.time / state.dt;
    for (std::size_t e = 0; e < cord.state.rest.size(); ++e) {
      cord.state.rest[e] = cord.rest_start[e] + share * (cord.rest_end[e] - cord.rest_start[e]);
    }
    cord.elasticity->set_rest_lengths(cord.state.rest);
  }
}

/// What a medium does: see find_medium_loads.
void StageSolver::load_medium(IslandState& state, const StageRequest& request) {
  resistance_.assign(state.slots(), {0.0, 0.0, 0.0});
  std::fill(state.medium_forces.begin(), state.medium_forces.end(), Vec2{});
  for (const Member& member : state.members) {
    if (!member.in_medium) continue;
    const PredictedMotion motion{IslandState::points_of(member, std::as_const(prediction.positions)),
                                 IslandState::points_of(member, std::as_const(prediction.velocities)), request.q,
                                 member.surroundings.time + request.time, state.gravity};
    find_medium_loads(*member.cord, member.surroundings, motion, IslandState::points_of(member, state.medium_forces),
                      IslandState::points_of(member, resistance_));
  }
  for (std::size_t p = 0; p < state.points; ++p) force_[p] += state.medium_forces[p];
}

/// The forces of a medium where the stage has ended.
void StageSolver::find_medium_forces(IslandState& state) const {
  for (std::size_t p = 0; p < state.points; ++p) {
    state.medium_forces[p] -= resistance_[p] * (state.positions[p] - prediction.positions[p]);
  }
}

const std::vector<Vec2>* StageSolver::find_restitution(IslandState& state, Contacts& contacts, double dt) {
  for (std::size_t p = 0; p < state.slots(); ++p) {
    inertia_[p] = state.masses[p] / (dt * dt);
    force_[p] = {};
  }
  prediction.positions = state.positions;
  prediction.velocities = state.velocities;
  const Stage stage{dt, prediction.positions, prediction.velocities, inertia_, force_, state.constrained};
  discard_pattern();
  const bool solved = newton_.find_coupled_direction(state, stage, contacts);
  discard_pattern();
  return solved ? &newton_.direction() : nullptr;
}

}  // namespace ribbon
