#include "ribbon/island/integrators.h"

#include <numbers>

namespace ribbon {
namespace {

constexpr double tr_gamma = 2.0 - std::numbers::sqrt2;
// Weights of BDF2 after a stage of γ·dt.
constexpr double c1 = 1.0 / (tr_gamma * (2.0 - tr_gamma));
constexpr double c0 = (1.0 - tr_gamma) * (1.0 - tr_gamma) * c1;

bool solve(const StepContext& context, const StageRequest& request) {
  return context.stages.solve(context.state, context.contacts, context.bounds, context.work, request);
}

}  // namespace

void Integrators::resize(std::size_t slots) {
  x1_.resize(slots);
  v1_.resize(slots);
}

void Integrators::store_first_stage(const IslandState& state) {
  x1_ = state.positions;
  v1_ = state.velocities;
}

bool Integrators::tr_bdf2(const StepContext& context, double time, double dt) {
  IslandState& state = context.state;
  auto& [predicted, velocity] = context.stages.prediction;
  const double q = 0.5 * tr_gamma * dt;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    velocity[p] = state.start.velocities[p] + q * state.accelerations[p];
    predicted[p] = state.start.positions[p] + q * (state.start.velocities[p] + velocity[p]);
    state.positions[p] = predicted[p] + (q * q) * state.accelerations[p];
  }
  // The weight is that with which bdf2_stage takes this stage's velocity.
  const double weight = q / (tr_gamma * (2.0 - tr_gamma));
  if (!solve(context, {time + tr_gamma * dt, q, state.start.positions, weight})) return false;
  return bdf2_stage(context, time, dt);
}

bool Integrators::euler_bdf2(const StepContext& context, double time, double dt) {
  if (!implicit_euler(context, time, tr_gamma * dt)) return false;
  context.contacts.impacts.scale_impulses(c1);  // as bdf2_stage takes the first stage's velocity
  return bdf2_stage(context, time, dt);
}

/// From the start of the substep and a stage that ended at γ·dt to its end.
bool Integrators::bdf2_stage(const StepContext& context, double time, double dt) {
  IslandState& state = context.state;
  auto& [predicted, velocity] = context.stages.prediction;
  store_first_stage(state);
  const double q = 0.5 * tr_gamma * dt;
  const double rest = (1.0 - tr_gamma) * dt;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    velocity[p] = c1 * v1_[p] - c0 * state.start.velocities[p];
    predicted[p] = c1 * x1_[p] - c0 * state.start.positions[p] + q * velocity[p];
    state.positions[p] = x1_[p] + rest * v1_[p] + (0.5 * rest * rest) * state.accelerations[p];
  }
  return solve(context, {time + dt, q, x1_, q});
}

bool Integrators::sdirk2(const StepContext& context, double time, double dt) {
  IslandState& state = context.state;
  auto& [predicted, velocity] = context.stages.prediction;
  const double gamma = 1.0 - 1.0 / std::numbers::sqrt2;
  const double q = gamma * dt;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    velocity[p] = state.start.velocities[p];
    predicted[p] = state.start.positions[p] + q * velocity[p];
    state.positions[p] = predicted[p];
  }
  if (!solve(context, {time + q, q, state.start.positions, dt - q})) return false;
  store_first_stage(state);

  const double rest = (1.0 - gamma) * dt;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    velocity[p] = state.start.velocities[p] + rest * state.accelerations[p];
    predicted[p] = state.start.positions[p] + rest * v1_[p] + q * velocity[p];
    state.positions[p] = predicted[p];
  }
  return solve(context, {time + dt, q, x1_, q});
}

bool Integrators::implicit_euler(const StepContext& context, double time, double dt) {
  IslandState& state = context.state;
  auto& [predicted, velocity] = context.stages.prediction;
  for (std::size_t p = 0; p < state.slots(); ++p) {
    velocity[p] = state.start.velocities[p];
    predicted[p] = state.start.positions[p] + dt * velocity[p];
    state.positions[p] = predicted[p];
  }
  return solve(context, {time + dt, dt, state.start.positions, dt, true});
}

}  // namespace ribbon
