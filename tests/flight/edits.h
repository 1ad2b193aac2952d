#pragma once

#include <functional>
#include <vector>

#include "engine/replay/solver_step.h"

namespace flight {

/// Makes something simpler; false if it is so already.
template <typename T>
using Edit = std::function<bool(T&)>;

/// Of the whole step: bodies that nothing refers to go, and gravity.
const std::vector<Edit<engine::SolverStep>>& step_edits();
/// Edits of a cord and its surroundings: terms are switched off, velocities set to zero, memory of earlier steps
/// cleared.
const std::vector<Edit<engine::SolverStep::Cord>>& cord_edits();
/// Of a body.
const std::vector<Edit<ribbon::RigidBody>>& body_edits();

/// Takes so many points off an end of a rope, with what holds them; false for a ribbon, and if two would not be left.
bool cut_rope(engine::SolverStep::Cord& cord, int many, bool at_front);

}  // namespace flight
