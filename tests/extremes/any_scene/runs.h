#pragma once

#include <functional>
#include <span>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// How runs are made.
struct RunOptions {
  double max_seconds = 20.0;  ///< a scene; what hangs in a tick is ended half as long later
  int jobs = 2;               ///< scenes at a time, each in a process of its own, so that one that crashes is counted
};

/// Plays the scenes and hands over their summaries as they come.
void run_all(std::span<const Which> scenes, const RunOptions& options, const std::function<void(const Summary&)>& take);
/// The same of one scene that was not generated.
Summary run_guarded(const Which& which, const Scene& scene, double max_seconds);

}  // namespace any_scene
