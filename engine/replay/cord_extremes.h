#pragma once

#include "ribbon/cord.h"

namespace engine {

/// By which share the link that is stretched most is longer than at rest, in any row; negative if all are shorter. Of
/// one that is not a number, infinity.
double largest_stretch(const ribbon::Cord& cord);
/// m/s, of the fastest point; infinity of one that is not a number.
double largest_speed(const ribbon::Cord& cord);
/// Whether all positions and velocities are finite.
bool is_finite(const ribbon::Cord& cord);

}  // namespace engine
