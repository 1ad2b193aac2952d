#pragma once

#include "ribbon/rigid_circle.h"
#include "ribbon/thesis/thesis_cord.h"
#include "ribbon/thesis/thesis_parts.h"

namespace ribbon {

/// Energies of a cord and of the bodies around it.
struct ThesisEnergy {
  double kinetic_and_elastic = 0.0;  ///< J
  double potential = 0.0;            ///< J
  /// Returns the sum, J.
  double total() const { return kinetic_and_elastic + potential; }
};

/// Returns the energies under `gravity` [m/s²], of the bodies as they move in this step.
ThesisEnergy energy(const ThesisParts& cord, Vec2 gravity, const Surroundings& surroundings);
/// Reports an energy gain in this step, unless a driven point, a kinematic body or a grip did work. `before` is the
/// energy at its start.
void report_gain(const ThesisParts& cord, const ThesisEnergy& before, Vec2 gravity, const Surroundings& surroundings,
                 StepReport& report);
/// Counts strained bars and inverted triangles.
void report_shape(const ThesisParts& cord, StepReport& report);

}  // namespace ribbon
