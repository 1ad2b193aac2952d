#pragma once

#include <vector>

#include "ribbon/stage/contact_stage.h"
#include "ribbon/stage/linearised_stage.h"
#include "ribbon/stage/newton_solver.h"

namespace ribbon {

/// Solves one implicit stage of a substep: its forces, where what is driven ends, the Newton steps, and the velocities
/// that follow from the positions.
class StageSolver {
 public:
  /// x̃ [m] and ṽ [m/s] of a stage, by slot, which an integrator writes. The state's positions are the first
  /// guess.
  struct Prediction {
    std::vector<Vec2> positions;
    std::vector<Vec2> velocities;
  };
  Prediction prediction;

  void resize(std::size_t slots, std::size_t tensions, std::size_t grips);
  void reserve(std::size_t grips) { newton_.reserve(grips); }
  void begin_step() { newton_.system().begin_step(); }
  /// Call it when what is coupled has changed within a step.
  void discard_pattern() { newton_.system().discard_pattern(); }
  /// Reserves memory for a step of an island that may touch something or is coupled.
  void reserve_linearised(const IslandState& state, const Contacts& contacts) {
    linearised_stage_.reserve(state, contacts);
  }

  /// Solves a stage. Returns false if it did not converge. The state is finite in either case.
  bool solve(IslandState& state, Contacts& contacts, const MotionBounds& bounds, StepWork& work,
             const StageRequest& request);
  /// Finds the change of positions in dt by which, from the current velocities, the contacts that have been hit open
  /// with restitution. Returns null if the system is singular.
  const std::vector<Vec2>* find_restitution(IslandState& state, Contacts& contacts, double dt);

  /// Stores the largest correction of each member's points by the last linear solve.
  void store_corrections(IslandState& state) const { newton_.store_corrections(state); }

  /// Selects how the contacts of the next stages are solved.
  void set_contact_solve(ContactSolve solve);
  /// Returns how the last linearised stage ended.
  const LinearisedResult& linearised_result() const { return linearised_result_; }
  /// Returns memory for shares of motions.
  MotionGroups& groups() { return linearised_stage_.groups(); }
  /// Returns memory for positions that are tried.
  std::vector<Vec2>& trial() { return newton_.trial(); }

 private:
  void load_forces(IslandState& state, const StageRequest& request);
  void place_driven(IslandState& state, double time);
  void load_member(const IslandState& state, const Member& member, const StageRequest& request);
  void load_medium(IslandState& state, const StageRequest& request);
  void find_medium_forces(IslandState& state) const;
  bool solve_contacts(const StageContext& context, const MotionBounds& bounds, const StageRequest& request,
                      Stage& stage);

  NewtonSolver newton_;
  FreeStage free_stage_;
  ContactStage contact_stage_;
  LinearisedStage linearised_stage_;
  ContactSolve contact_solve_ = ContactSolve::newton;
  LinearisedResult linearised_result_;
  std::vector<double> inertia_;    // N/m, by slot
  std::vector<Vec2> force_;        // N, by slot
  std::vector<Block> resistance_;  // N/m, by slot, of a medium
};

}  // namespace ribbon
