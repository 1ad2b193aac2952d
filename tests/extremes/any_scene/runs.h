#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// Options of a set of runs.
struct RunOptions {
  double max_seconds = 20.0;  ///< per scene; a tick that hangs is killed after half of that more
  int jobs = 2;               ///< number of parallel processes; one per scene, so that a crash affects one scene only
};

/// Plays the scenes, and calls `take` with each summary as its scene ends.
void run_all(std::span<const SceneId> scenes, const RunOptions& options,
             const std::function<void(const Summary&)>& take);
/// Plays one scene that was not generated, in its own process.
Summary run_guarded(const SceneId& which, const Scene& scene, double max_seconds);

}  // namespace any_scene
