#pragma once

#include "ribbon/cord.h"

namespace engine {

/// Returns the largest strain of any link of any row, length / rest length − 1; negative if all links are shortened.
/// Infinity if one is NaN.
double largest_stretch(const ribbon::Cord& cord);
/// Returns the speed of the fastest point in m/s; infinity if one is NaN.
double largest_speed(const ribbon::Cord& cord);
/// Returns whether all positions and velocities are finite.
bool is_finite(const ribbon::Cord& cord);

}  // namespace engine
