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

/// How exact a step is, while it is going on: the same step is taken `finer` times as often on copies, and by
/// Richardson's argument nearly all of the difference is the step's own (E. Hairer, S. P. Nørsett, G. Wanner, Solving
/// Ordinary Differential Equations I, section II.4; of the second order 15/16 of it are). What the step itself does
/// stays the same to the bit; it costs `finer` further steps, and memory anew for cords that were not there before.
class ErrorProbe {
 public:
  static constexpr int finer = 4;  ///< substeps of a copy in place of one

  /// Before the step of these cords among these bodies: see DirectSolver::step.
  void foresee(std::span<const IslandCord> cords, std::span<const RigidBody> bodies, double dt, Vec2 gravity);

  /// After it: m, how far the point that is furthest off is from where it was foreseen.
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
