#pragma once

#include <functional>

#include "tests/study/trace.h"

namespace study {

/// Calls `run` in a copy of this process and returns its trace, with the same bits. What it moves stays where it is in
/// this process: Box2D has no snapshots, and a run that went back (see ribbon::box2d::WorldSnapshot) has not always the
/// same bits. Costs about a millisecond. Throws std::runtime_error with the sentence of what `run` throws, and if the
/// copy ends early.
Trace run_in_copy(const std::function<Trace()>& run);

}  // namespace study
