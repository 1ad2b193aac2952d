#include "ribbon/stage/contact_stage.h"

#include <algorithm>

#include "ribbon/system/stretch.h"

namespace ribbon {
namespace {

// Newton steps of a stage near contacts. In random scenes all but one in a hundred of the stages that converge within
// 40 do within 14. The others are cheaper to end here and to linearise once.
constexpr int max_iterations = 20;
constexpr int max_large_budget_iterations = 40;  // with a large budget of work
constexpr std::size_t stored_values = 3;         // of the energy: a step has to get below the largest of them
constexpr int monotone_after = 10;               // iterations, after which each step has to reduce the energy
constexpr double negligible_share = 1e-3;        // of the tolerance: so small a step is always taken in full
constexpr double unsettled_share = 1e-2;         // of the tolerance, by which unexpected forces may move something
constexpr double crawling_share = 0.1;           // of a step: if less is taken, its contacts were not as expected
constexpr int enough_full_steps = 2;             // of a stage with soft contacts
constexpr int max_length_iterations = 6;         // of a stage, in which links may not stretch; later ones may
constexpr double most_driven_strain = 1e-2;      // of links, while something is driven: it may stretch them
constexpr double driven_rest = 1e-9;             // share of a driven displacement that counts as none

}  // namespace

bool ContactStage::solve(const StageContext& context, const StageRequest& request, const Stage& stage) {
  IslandState& state = context.state;
  Contacts& contacts = context.contacts;
  NewtonSolver& newton = context.newton;
  begin(context, request);
  advance_kinematics(context, stage.predicted);
  bool strict = false;
  const bool soft = state.accuracy.soft_contacts;
  const double tolerated = soft ? unsettled_share * state.tolerance : 0.0;
  const int max = context.work.has_large_budget() ? max_large_budget_iterations : max_iterations;
  int full_steps = 0;
  for (int iteration = 0; iteration < max && !context.work.attempt_is_over(); ++iteration) {
    context.count_system();
    if (drive_left_ > 0.0) advance_drives(context, stage);
    contacts.find_for_solve(state.positions, strict);
    if (!newton.find_direction(state, stage, contacts)) return false;
    const double moved = newton.largest_displacement(state);
    if (!(moved <= NewtonSolver::max_displacement)) return false;
    newton.raise_penalty();
    const Taken taken = take_step(context, stage, moved, iteration);
    if (taken.full) ++full_steps;
    if (taken.fraction == 0.0) {
      if (!strict) {
        strict = true;
        continue;
      }
      // Nearer to the solution than the energy can tell, or stuck.
      return taken.small && drive_left_ == 0.0 && is_solution(context, request, stage);
    }
    strict = !strict && taken.crawls;
    state.positions.swap(newton.trial());
    newton.take_tensions(state);
    if (!taken.small || drive_left_ > 0.0 || newton.slip_began() || !newton.is_settled(state, stage, iteration)) {
      continue;
    }
    if (iteration < max_length_iterations && !state.driven && became_stretched(state)) continue;
    if (contacts.are_settled(state.positions, tolerated) ||
        (soft && full_steps >= enough_full_steps && contacts.active.are_shallow(contacts.scene.pairs))) {
      return is_solution(context, request, stage);
    }
  }
  return false;
}

void ContactStage::begin(const StageContext& context, const StageRequest& request) {
  IslandState& state = context.state;
  std::vector<Vec2>& direction = context.newton.direction();
  context.contacts.compliant.begin_stage(context.contacts.scene.pairs);
  context.contacts.scene.anchors.set_kinematic_targets(request.time);
  context.newton.reset_penalty();
  values_.clear();
  for (std::size_t p = 0; p < state.slots(); ++p) direction[p] = state.positions[p] - request.from[p];
  std::copy(request.from.begin(), request.from.end(), state.positions.begin());
  drive_left_ = 1.0;
}

/// Moves what is driven towards where it is at the end of the stage.
void ContactStage::advance_drives(const StageContext& context, const Stage& stage) {
  const IslandState& state = context.state;
  std::vector<Vec2>& direction = context.newton.direction();
  for (std::size_t p = 0; p < state.slots(); ++p) {
    direction[p] = state.constrained[p] != 0 ? stage.predicted[p] - state.positions[p] : Vec2{};
  }
  advance_kinematics(context, stage.predicted);
}

/// Moves along the direction until something is in the way, and kinematic bodies along the same share of what is left
/// of their displacement.
void ContactStage::advance_kinematics(const StageContext& context, std::span<const Vec2> predicted) {
  IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  newton.move(state, newton.trial(), 1.0);
  const double share = context.contacts.sweep.collision_free_fraction(context.contacts.scene, state.positions,
                                                                      newton.trial(), KinematicTime::target);
  newton.move(state, state.positions, share);
  context.contacts.scene.anchors.advance_kinematics(share);
  drive_left_ *= 1.0 - share;
  if (drive_left_ > driven_rest) return;
  drive_left_ = 0.0;
  context.contacts.scene.anchors.advance_kinematics(1.0);
  for (std::size_t p = 0; p < state.slots(); ++p) {
    if (state.constrained[p] != 0) state.positions[p] = predicted[p];
  }
}

/// Takes a small step in full, so that forces balance and momentum is conserved to the last bits, but not in every
/// iteration. Searches along all others.
ContactStage::Taken ContactStage::take_step(const StageContext& context, const Stage& stage, double moved,
                                            int iteration) {
  const IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  newton.move(state, newton.trial(), 1.0);
  const double free = context.contacts.sweep.collision_free_fraction(context.contacts.scene, state.positions,
                                                                     newton.trial(), KinematicTime::current);
  const bool small = moved <= state.tolerance && free == 1.0;
  const bool full = small && (state.accuracy.soft_contacts || iteration < monotone_after ||
                              moved <= negligible_share * state.tolerance);
  const double fraction = full ? 1.0 : search(context, stage, free, iteration);
  return {fraction, small, full, fraction < crawling_share * free};
}

/// Returns the first of fraction, fraction/2, … of the direction that takes the energy below one of its last values.
/// One that has to fall each time cuts steps along curved paths short (Grippo, Lampariello & Lucidi 1986); after some
/// iterations it has to. Returns 0 if none does.
double ContactStage::search(const StageContext& context, const Stage& stage, double fraction, int iteration) {
  IslandState& state = context.state;
  NewtonSolver& newton = context.newton;
  const auto energy = [&](std::span<const Vec2> x) {
    return newton.potential(state, stage, x, state.coupled) + context.contacts.potential(x);
  };
  if (newton.supports_changed()) values_.clear();
  values_.push_back(energy(state.positions));
  while (values_.size() > (iteration > monotone_after ? 1U : stored_values)) values_.erase(values_.begin());
  const double max = *std::max_element(values_.begin(), values_.end());
  for (; fraction >= NewtonSolver::min_fraction; fraction *= 0.5) {
    newton.move(state, newton.trial(), fraction);
    NewtonSolver::close_arms(state, newton.trial());
    if (energy(newton.trial()) < max) return fraction;
  }
  return 0.0;
}

/// Returns whether the positions may be the solution: the path to them from the start of the stage goes through
/// nothing. Whatever touches now has been hit in the stage. What links are still stretched by, within the tolerance, is
/// taken back; if it cannot be, there is no solution.
bool ContactStage::is_solution(const StageContext& context, const StageRequest& request, const Stage& stage) {
  IslandState& state = context.state;
  if (!state.driven && state.wheels.empty() && became_stretched(state, LinkLengths::restored_strain)) {
    link_lengths_.restore(state, stage.inertia);
    if (became_stretched(state, state.accuracy.soft_contacts ? max_strain : LinkLengths::restored_strain)) return false;
  }
  if (state.driven && state.wheels.empty() && became_stretched(state, most_driven_strain)) return false;
  context.contacts.active.update(context.contacts.scene, context.state.positions);
  context.contacts.record_impacts(context.state.positions, request.time_weight);
  return context.contacts.sweep.path_is_clear(context.contacts.scene, request.from, context.state.positions);
}

}  // namespace ribbon
