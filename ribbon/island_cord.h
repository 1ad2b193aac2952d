#pragma once

#include <cstdint>

#include "ribbon/rigid_circle.h"

namespace ribbon {

class Cord;

/// A cord among those that are stepped together, and what it alone meets.
struct IslandCord {
  Cord* cord = nullptr;  ///< not null, and no other's
  Surroundings met;      ///< its circles, segments and grips; the bodies are those of all
  std::uint64_t id = 0;  ///< the same from step to step, and of no circle or segment
};

}  // namespace ribbon
