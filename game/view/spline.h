#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace game {

/// Computes the centripetal Catmull-Rom spline through the points, which has no loops or cusps between two points for
/// any distances. Writes to `curve` the first point and then `steps` (1 or more) points for each that follows; the last
/// of these is the point itself.
void smooth_curve(std::span<const ribbon::Vec2> points, int steps, std::vector<ribbon::Vec2>& curve);

}  // namespace game
