#pragma once

#include <string>

#include "engine/replay/solver_step.h"

namespace flight {

/// A step as C++ that stands by itself: a GoogleTest that takes it, wants it to converge, and with no more work than
/// `max_work`. Numbers are exact, and what is as in a new definition is left out.
std::string code_of(const engine::SolverStep& step, std::int64_t max_work);

}  // namespace flight
