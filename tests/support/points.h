#pragma once

#include <span>
#include <vector>

#include "ribbon/vec2.h"

namespace test_support {

/// Returns `count` points: the first at `start`, each next one `step` [m] further.
std::vector<ribbon::Vec2> equally_spaced(int count, ribbon::Vec2 start, ribbon::Vec2 step);
std::vector<ribbon::Vec2> copy(std::span<const ribbon::Vec2> points);

/// Returns the largest distance between a point of `from` and the point of `to` with the same index, m.
double max_distance(std::span<const ribbon::Vec2> from, std::span<const ribbon::Vec2> to);
/// Returns the sum of the lengths of the segments from point to point, m.
double path_length(std::span<const ribbon::Vec2> points);
/// Returns the distance from `p` to the nearest segment of the path, m; infinity if it has no segment.
double distance_to_path(ribbon::Vec2 p, std::span<const ribbon::Vec2> path);
/// Returns whether the segments from a to b and from c to d cross.
bool segments_cross(ribbon::Vec2 a, ribbon::Vec2 b, ribbon::Vec2 c, ribbon::Vec2 d);
/// Returns whether no coordinate is infinite or NaN.
bool all_finite(std::span<const ribbon::Vec2> points);

}  // namespace test_support
