#pragma once

#include "ribbon/cord_forces.h"
#include "ribbon/island/integrators.h"
#include "ribbon/island/restitution.h"
#include "ribbon/island/step_context.h"

namespace ribbon {

/// Takes one substep: with the declared integrator; where that does not converge or gains energy, with implicit Euler;
/// where that does not converge either, in halves.
class Substeps {
 public:
  void resize(std::size_t slots, std::size_t tensions);
  /// Takes the substep that begins `time` seconds after the start of the step. Returns false if it did not converge;
  /// then Island::step takes the whole step again.
  bool take(const StepContext& context, double time, double dt, Restitution& restitution);

 private:
  /// A substep of implicit Euler that is halved.
  struct Halving {
    double time;         // s, start of the substep since the step began
    int iterations;      // of the report before it
    bool solved = true;  // all of its parts
  };

  static bool end_turning(const StepContext& context, const CordEnergy& before);
  bool take_second_order(const StepContext& context, double time, double dt, const CordEnergy& before);
  bool take_damped(const StepContext& context, double time, double dt, const CordEnergy& before);
  bool take_whole(const StepContext& context, double time, double dt, const CordEnergy& before);
  bool take_halved(const StepContext& context, double time, double dt, const CordEnergy& before);
  bool halve(const StepContext& context, double time, double dt);
  bool take_halves(const StepContext& context, double time, double dt, int depth, Halving& halving);
  static bool accept(const StepContext& context, bool converged, const CordEnergy& before);
  static void end(const StepContext& context, const CordEnergy& before, double dt, Restitution& restitution);

  Integrators integrators_;
  SubstepStart whole_;  // start of a substep that is being halved
};

}  // namespace ribbon
