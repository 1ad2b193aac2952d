#pragma once

#include "engine/replay/solver_step.h"
#include "tests/flight/replay.h"

namespace flight {

/// Prints what a step was recorded for and what is in it.
void print_step(const engine::SolverStep& step);
/// Takes it, and prints whether it did as recorded, figures from before and after it, and the report of each island.
void print_replay(const engine::SolverStep& step, Replay& replay);
/// Takes it so many times, and prints the median and the least of the milliseconds, and what they were spent on.
void print_profile(Replay& replay, int repeats);

}  // namespace flight
