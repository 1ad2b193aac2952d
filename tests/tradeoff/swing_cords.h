#pragma once

#include <memory>

#include "ribbon/cord_def.h"
#include "tests/tradeoff/swing.h"

namespace tradeoff {

/// Returns the rope of the direct solver. `stiffness` is EA in N.
std::unique_ptr<Swing> cord_swing(double stiffness, const ribbon::Accuracy& accuracy);

/// The thesis's stepper. It needs two rows, so it is a ribbon of 51 × 2 points of equal mass. The first point of its
/// lower row is pinned, the last one holds the load; this row is the compared path. The springs have the best stiffness
/// and the bars the least necessary damping. The diagonal springs make it stiff against bending, but the load bends it
/// anyway.
std::unique_ptr<Swing> thesis_swing(int substeps);

}  // namespace tradeoff
