#pragma once

#include <box2d/box2d.h>

#include <limits>
#include <vector>

#include "ribbon/box2d/coupling.h"
#include "tests/support/contact_figures.h"

namespace study {

inline constexpr double lacking = std::numeric_limits<double>::quiet_NaN();

/// The figures of all cords and bodies of a world at a moment. Unavailable ones are NaN.
struct Figures {
  /// N, the greatest of links of ropes and of bars of ribbons; the thesis's cords and cells have none.
  double tension = lacking;
  /// The deepest that a cord is in a circle, edge or polygon, as a share of its radius; of cords of the direct solver
  /// that have a radius.
  double penetration = lacking;
  double stretch = 0.0;     ///< the cords' mean, of the whole length of each, as a share
  double energy = lacking;  ///< J, kinetic, elastic and potential; the thesis's cords have no elastic energy
  double kinetic = 0.0;     ///< J, of cords and dynamic bodies
  ribbon::Vec2 momentum{};  ///< kg·m/s, linear, of both
};

/// kg, of all cords and dynamic bodies.
double mass_of(const b2World& world, const ribbon::box2d::Coupling& coupling);

/// All but the stretch, which needs the lengths at rest. `filter` is that of the cords.
Figures figures_of(const b2World& world, const ribbon::box2d::Coupling& coupling, const b2Filter& filter);

/// What of a cord of either solver can be touched.
test_support::Outline outline_of(const ribbon::box2d::Coupling& coupling, ribbon::box2d::CordId cord);

}  // namespace study
