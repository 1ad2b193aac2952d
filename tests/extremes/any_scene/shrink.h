#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// A figure of a run, and its upper bound.
struct Limit {
  std::string_view figure;
  double most;
  double (*value)(const Summary& run);
};
/// Returns the default limits, most severe first: end, crossings, inverted, unconverged, stretch, gap, rise, work.
const std::vector<Limit>& limits();
/// Returns the first limit that the run exceeds; null if none.
const Limit* first_exceeded(const Summary& run);

/// Returns whether a scene still fails in the same way.
using Fails = std::function<bool(const Scene& scene)>;

/// Returns whether a scene can be built, has no overlaps, has holders at their cords, and has links of the rest length.
bool starts_clear(const Scene& scene);

/// Returns the smallest failing scene that it finds. Removes cords, solids, holds, wheels, drags, reels, cuts, ties,
/// terms, points and ticks, and rounds numbers. `scene` has to fail.
Scene shrink(const Scene& scene, const Fails& fails);

}  // namespace any_scene
