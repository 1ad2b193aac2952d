#pragma once

#include <box2d/b2_body.h>

#include <vector>

#include "ribbon/box2d/coupled_cord.h"
#include "ribbon/box2d/coupling_parts.h"
#include "ribbon/box2d/coupling_state.h"

namespace ribbon::box2d {

/// Returns the number of fixtures of a body.
int fixture_count(const b2Body& body);

/// Throws DefinitionError unless a state fits the bodies in `memory`, in the order of creation, and all its values are
/// in range. Its cords are those of a coupling and the `missing` ones, which are added again.
void check_state(const CouplingState& state, RestoreMemory& memory, const CordTable& cords,
                 const std::vector<CoupledCord>& missing);

}  // namespace ribbon::box2d
