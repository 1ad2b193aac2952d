#pragma once

#include <memory>

#include "ribbon/cord_def.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// The direct solver. `stiffness` is EA in N.
std::unique_ptr<Swing> cord_swing(double stiffness, const ribbon::Accuracy& accuracy);

/// The thesis's stepper. It needs two rows, so it is a ribbon of 51 × 2 points of equal mass: pinned by the first point
/// of its lower row, which is the path that is looked at, with the load gripped to the last. Springs as stiff as they
/// help and bars no more damped than they must be; a spring's cross makes a plank of it, which the load bends all the
/// same.
std::unique_ptr<Swing> thesis_swing(int substeps);

}  // namespace tradeoff
