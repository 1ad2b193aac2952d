#pragma once

#include <vector>

#include "ribbon/thesis/thesis_cord.h"

namespace ribbon {

/// The points of a cord of the thesis's method.
struct ThesisPoints : ThesisCord::State {
  std::vector<double> inverse_mass;  ///< 1/kg, 0 for driven points
  // In a step:
  std::vector<Vec2> step_start;     ///< m, positions at the start of the step
  std::vector<Vec2> substep_start;  ///< m, R of Eq. 3.16: positions at the start of the substep
};

}  // namespace ribbon
