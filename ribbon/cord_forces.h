#pragma once

#include <optional>

#include "ribbon/cord.h"
#include "ribbon/vec2.h"

// Forces in and on a cord, and its energies, from its state.

namespace ribbon {

/// Energies of a cord, its loads and its attached masses.
struct CordEnergy {
  double kinetic = 0.0;    ///< J
  double elastic = 0.0;    ///< J, of bars and cells, from their tensions
  double potential = 0.0;  ///< J, in gravity and under the loads
  /// Returns the sum, J.
  double total() const { return kinetic + elastic + potential; }
};
/// Returns the energies under `gravity` [m/s²]. O(points).
CordEnergy energy_of(const Cord& cord, Vec2 gravity);

/// Returns the tension of the link from column `link` to the next one, N; negative under compression. That of a ribbon
/// is the force of all elements between the two columns, in the direction of the middle line. Throws DefinitionError
/// for an unknown link. O(rows).
double tension_of(const Cord& cord, int link);

/// Returns the reaction of a pin on the cord at the end of the last step, N, under `gravity` [m/s²]: the force that
/// balances the other forces on a constrained or operated point. It includes neither the inertia of the point, nor
/// contacts of the links at it, nor damping after set_velocity and while inverted cells are turned back. It is 0 for a
/// free point. Throws DefinitionError for an unknown point. O(points).
Vec2 reaction(const Cord& cord, int point, Vec2 gravity);
/// Returns the force [N] that balances the other forces on any point, free or not, among them its weight under
/// gravity_scale times `gravity`, with the same exceptions. For a point that a static or kinematic body holds it is the
/// force of the body.
/// Throws DefinitionError for an unknown point.
Vec2 holding_force(const Cord& cord, int point, Vec2 gravity);
/// Returns the link whose tension exceeds its breaking force by the largest factor, the first of equal ones; nothing if
/// none does. O(1) if no link can break, otherwise O(points).
std::optional<int> overloaded_link(const Cord& cord);

}  // namespace ribbon
