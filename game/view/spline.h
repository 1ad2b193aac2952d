#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace game {

/// The centripetal Catmull-Rom spline through the points: smooth, without loops or cusps between two points however
/// unequal the distances are. Written to `curve`: the first point, and then `steps` (1 or more) for each that follows,
/// the last of them the point itself.
void smooth_curve(std::span<const ribbon::Vec2> points, int steps, std::vector<ribbon::Vec2>& curve);

}  // namespace game
