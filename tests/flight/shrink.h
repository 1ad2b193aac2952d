#pragma once

#include <functional>

#include "engine/replay/solver_step.h"

namespace flight {

/// Whether a step still does what is looked into. A step that throws does not.
using StillFails = std::function<bool(const engine::SolverStep&)>;
/// Is shown the smallest step so far, and how many have been tried.
using ShowProgress = std::function<void(const engine::SolverStep&, int tried)>;

/// Takes out of a step what it can while it still fails: cords, points from the ends of ropes, circles, segments,
/// grips, bodies, terms, and what moves. Its outcome is that of the smaller step. The step has to fail at the start.
engine::SolverStep shrink(const engine::SolverStep& step, const StillFails& still_fails,
                          const ShowProgress& show_progress = {});

/// What there is of a step, to compare sizes: cords, points, circles, segments, grips and bodies.
std::size_t size_of(const engine::SolverStep& step);

}  // namespace flight
