#pragma once

#include <box2d/box2d.h>

#include <limits>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "tests/support/contact_figures.h"

namespace study {

inline constexpr double unavailable = std::numeric_limits<double>::quiet_NaN();

/// The figures of all cords and bodies of a world at a moment. Unavailable ones are NaN.
struct Figures {
  /// N, maximum over links of ropes and bars of ribbons; the thesis's cords and cells have none.
  double tension = unavailable;
  /// Greatest depth in a circle, edge or polygon, relative to the cord's radius; for cords of the direct solver
  /// with a radius.
  double penetration = unavailable;
  double stretch = 0.0;         ///< mean of the cords' stretches, relative to each whole length
  double energy = unavailable;  ///< J, kinetic, elastic and potential; cords of the thesis have no elastic energy
  double kinetic = 0.0;         ///< J, of cords and dynamic bodies
  ribbon::Vec2 momentum{};      ///< kg·m/s, linear, of cords and dynamic bodies
};

/// Returns the mass of all cords and dynamic bodies, kg.
double mass_of(const b2World& world, const ribbon::box2d::Coupling& coupling);

/// Returns all figures but the stretch, which needs the rest lengths. `filter` is that of the cords.
Figures figures_of(const b2World& world, const ribbon::box2d::Coupling& coupling, const b2Filter& filter);

/// Returns the collision geometry of a cord of either solver.
test_support::Outline outline_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

}  // namespace study
