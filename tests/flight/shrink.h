#pragma once

#include <functional>

#include "engine/replay/solver_step.h"

namespace flight {

/// Returns whether a step still fails in the same way. A step that throws does not.
using StillFails = std::function<bool(const engine::SolverStep&)>;
/// Receives the smallest step so far, and the number of steps tried.
using ShowProgress = std::function<void(const engine::SolverStep&, int tried)>;

/// Returns a smaller step that still fails: removes cords, end points of ropes, circles, segments, grips, bodies, terms
/// and velocities. Its outcome is that of the smaller step. The step has to fail at the start.
engine::SolverStep shrink(const engine::SolverStep& step, const StillFails& still_fails,
                          const ShowProgress& show_progress = {});

/// Returns the number of cords, points, circles, segments, grips and bodies, to compare sizes.
std::size_t size_of(const engine::SolverStep& step);

}  // namespace flight
