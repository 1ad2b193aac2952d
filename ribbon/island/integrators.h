#pragma once

#include <vector>

#include "ribbon/island/step_context.h"

namespace ribbon {

/// The integrators of a substep that has begun, from `time` [s] since the step began, over dt. Every stage has the form
/// x = x̃ + q²·a, v = ṽ + q·a; x̃ and ṽ are StageSolver::prediction. Each returns false if a stage did not
/// converge.
class Integrators {
 public:
  void resize(std::size_t slots);
  /// The trapezoidal rule over γ·dt, then BDF2 over the whole substep. γ = 2 − √2 gives both the same q = γ·dt/2 (Hosea
  /// & Shampine 1996).
  bool tr_bdf2(const StepContext& context, double time, double dt);
  /// Two implicit stages that end at γ·dt and dt, γ = 1 − 1/√2, stiffly accurate (Alexander 1977). It has the same
  /// order and needs no acceleration from before: for the first step after something was constrained, released, loaded
  /// or moved.
  bool sdirk2(const StepContext& context, double time, double dt);
  /// TR-BDF2 with implicit Euler as its first stage, for a substep in which a contact begins or ends.
  bool euler_bdf2(const StepContext& context, double time, double dt);
  /// One stage over dt, which damps most.
  static bool implicit_euler(const StepContext& context, double time, double dt);

 private:
  bool bdf2_stage(const StepContext& context, double time, double dt);
  void store_first_stage(const IslandState& state);

  std::vector<Vec2> x1_, v1_;  // after the first stage
};

}  // namespace ribbon
