#pragma once

#include <functional>
#include <vector>

#include "engine/replay/solver_step.h"

namespace flight {

/// Makes an object simpler; returns false if the edit changes nothing.
template <typename T>
using Edit = std::function<bool(T&)>;

/// Edits of the whole step: they remove unreferenced bodies, and gravity.
const std::vector<Edit<engine::SolverStep>>& step_edits();
/// Edits of a cord and its surroundings: terms are switched off, velocities set to zero, memory of earlier steps
/// cleared.
const std::vector<Edit<engine::SolverStep::Cord>>& cord_edits();
/// Edits of a body.
const std::vector<Edit<ribbon::RigidBody>>& body_edits();

/// Removes `many` points and their holds from an end of a rope. Returns false for a ribbon, or if too few would remain.
bool cut_rope(engine::SolverStep::Cord& cord, int many, bool at_front);

}  // namespace flight
