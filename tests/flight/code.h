#pragma once

#include <string>

#include "engine/replay/solver_step.h"

namespace flight {

/// Returns a self-contained GoogleTest in C++ that takes the step and expects convergence with at most `max_work` work.
/// Numbers are exact; fields with their default value are omitted.
std::string code_of(const engine::SolverStep& step, std::int64_t max_work);

}  // namespace flight
