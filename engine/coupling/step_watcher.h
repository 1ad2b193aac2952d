#pragma once

#include <span>

#include "ribbon/cord.h"
#include "ribbon/island_cord.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/tie.h"
#include "ribbon/vec2.h"

namespace ribbon::box2d {

/// The arguments of DirectSolver::step, without the reports.
struct SolverInput {
  std::span<const IslandCord> cords;  ///< enabled cords, in the order of adding
  std::span<const RigidBody> bodies;  ///< bodies that the cords refer to
  double dt = 0.0;                    ///< s
  Vec2 gravity;                       ///< m/s²
  std::span<const Tie> ties = {};     ///< ties of these cords
};

/// Interface that is called before and after each step of a coupling's direct solver; see Coupling::watch. Arguments
/// are valid until the call returns.
class StepWatcher {
 public:
  StepWatcher() = default;
  StepWatcher(const StepWatcher&) = delete;
  StepWatcher& operator=(const StepWatcher&) = delete;
  virtual ~StepWatcher() = default;

  /// Called before the step.
  virtual void before(const SolverInput& input) noexcept = 0;
  /// Called after the step, with the reports of all islands, in the order of their first cords, and their total.
  virtual void after(const SolverInput& input, std::span<const IslandReport> islands,
                     const IslandReport& total) noexcept = 0;
};

}  // namespace ribbon::box2d
