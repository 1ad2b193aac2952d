#pragma once

#include "ribbon/island/integrators.h"
#include "ribbon/island/restitution.h"
#include "ribbon/island/step_context.h"

namespace ribbon {

/// Takes one substep: with the declared integrator and, where that does not converge or gains energy, with implicit
/// Euler.
class Substeps {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Takes the substep that begins `time` seconds after the start of the step. Returns false if it did not converge and
  /// LinearisedStep has to take the whole step.
  bool take(const StepContext& context, double time, double dt, Restitution& restitution);

 private:
  /// A substep of implicit Euler that is halved.
  struct Halving {
    double time;           // s, start of the substep since the step began
    int iterations;        // of the report before it
    bool gave_up = false;  // part of it is not solved
  };

  bool take_second_order(const StepContext& context, double time, double dt, const Cord::Energy& before);
  bool take_damped(const StepContext& context, double time, double dt, const Cord::Energy& before);
  bool take_halved(const StepContext& context, double time, double dt, const Cord::Energy& before);
  bool halve(const StepContext& context, double time, double dt);
  void take_halves(const StepContext& context, double time, double dt, int depth, Halving& halving);
  static bool accept(const StepContext& context, bool converged, const Cord::Energy& before);
  static void end(const StepContext& context, const Cord::Energy& before, double dt, Restitution& restitution);

  Integrators integrators_;
  SubstepStart whole_;  // start of a substep that is being halved
};

}  // namespace ribbon
