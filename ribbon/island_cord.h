#pragma once

#include <cstdint>

#include "ribbon/rigid_circle.h"

namespace ribbon {

class Cord;

/// A cord to be stepped by DirectSolver, and its surroundings.
struct IslandCord {
  Cord* cord = nullptr;         ///< not null; each cord occurs once
  Surroundings surroundings;    ///< its circles, segments and grips; `bodies` is ignored
  std::uint64_t id = 0;         ///< identifies the cord from step to step; differs from the ids of circles and segments
  bool records_pushes = false;  ///< its contacts get Touch::push; it changes nothing else
};

/// Throws DefinitionError unless the surroundings have as many axles as the cord has pulleys.
void check_axles(const Cord& cord, const Surroundings& surroundings);

}  // namespace ribbon
