#pragma once

#include <span>

#include "ribbon/cord.h"
#include "ribbon/island_cord.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace engine {

/// What ribbon::DirectSolver::step is given, but for the reports.
struct SolverInput {
  std::span<const ribbon::IslandCord> cords;  ///< in the order of adding, those that are switched on
  std::span<const ribbon::RigidBody> bodies;  ///< that all of them may meet
  double dt = 0.0;                            ///< s
  ribbon::Vec2 gravity;                       ///< m/s²
};

/// What is called around each step of a coupling's direct solver: see Coupling::watch. It changes nothing, and what it
/// is given is valid until the call returns.
class StepWatcher {
 public:
  StepWatcher() = default;
  StepWatcher(const StepWatcher&) = delete;
  StepWatcher& operator=(const StepWatcher&) = delete;
  virtual ~StepWatcher() = default;

  /// What the step is about to begin with.
  virtual void before(const SolverInput& input) noexcept = 0;
  /// The same cords and bodies after it, with what happened in the island of each cord, and in all islands.
  virtual void after(const SolverInput& input, std::span<const ribbon::CordReport> reports,
                     const ribbon::CordReport& total) noexcept = 0;
};

}  // namespace engine
