#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// A figure of a run, and what it may be at the most.
struct Bar {
  std::string_view figure;
  double most;
  double (*value)(const Summary& run);
};
/// Those that are looked at if none is named, the gravest first: end, crossings, inverted, unconverged, stretch, gap,
/// rise, work.
const std::vector<Bar>& bars();
/// The first figure that is above its bar; null if none is.
const Bar* first_broken(const Summary& run);

/// Whether a scene still fails as it should.
using Fails = std::function<bool(const Scene& scene)>;

/// Whether a scene can be built, nothing in it overlaps, holders are at their cords and links are at their lengths.
bool starts_clear(const Scene& scene);

/// The smallest scene that it finds which still fails: without cords, solids, holds, drags, reels and terms that are
/// not needed, with fewer points and ticks, and rounder numbers. `scene` has to fail.
Scene shrink(const Scene& scene, const Fails& fails);

}  // namespace any_scene
