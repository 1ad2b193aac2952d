#pragma once

#include "engine/replay/solver_step.h"
#include "tests/flight/replay.h"

namespace flight {

/// Prints the reason of a recording, and its contents.
void print_step(const engine::SolverStep& step);
/// Takes the step. Prints whether the result is as recorded, figures before and after, and the report of each island.
void print_replay(const engine::SolverStep& step, Replay& replay);
/// Takes the step `repeats` times. Prints the median and the least time in milliseconds, and the time of each part.
void print_profile(Replay& replay, int repeats);

}  // namespace flight
