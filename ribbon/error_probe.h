#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/cord.h"
#include "ribbon/direct_solver.h"
#include "ribbon/island_cord.h"
#include "ribbon/rigid_circle.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Estimates the time integration error of a step. It advances copies of the cords with `finer` times as many substeps
/// and compares the results: by Richardson extrapolation, the difference is 15/16 of the error of a second-order step
/// (E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I, section II.4). The step itself
/// keeps its bits. An estimate costs `finer` steps, and memory for each new cord.
class ErrorProbe {
 public:
  static constexpr int finer = 4;  ///< substeps of a copy for each substep of the cord

  /// Advances the copies. Call it before DirectSolver::step with the same arguments.
  void foresee(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt, Vec2 gravity,
               std::span<const Tie> ties = {});

  /// Returns the largest distance [m] of a point of cord number `cord` from the point of its copy. Call it after the
  /// step.
  double error(std::size_t cord, const Cord& stepped) const;

 private:
  static CordDef finer_def(const Cord& cord);

  DirectSolver solver_;
  std::vector<Cord> copies_;
  std::vector<IslandCord> members_;
  std::vector<RigidBody> bodies_;
  std::vector<CordReport> reports_;
};

}  // namespace ribbon
