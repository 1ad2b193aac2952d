#pragma once

#include <vector>

#include "engine/replay/solver_step.h"
#include "ribbon/cord.h"
#include "ribbon/rigid_circle.h"

namespace flight {

/// What can be said of a step's cords and bodies from where they are, without the solver's help.
struct Figures {
  bool finite = true;
  double stretch = 0.0;      ///< share by which the longest link is longer than at rest
  int stretched_cord = -1;   ///< which has it
  double penetration = 0.0;  ///< m, the deepest, of a cord in a circle or segment that is near it; 0 if none is in one
  int deep_cord = -1;        ///< which is,
  int deep_body = -1;        ///< and in which body
  double cord_penetration = 0.0;  ///< m, the deepest of cords that declare contact in themselves and each other
  double speed = 0.0;             ///< m/s, of the fastest point
  double grip_gap = 0.0;          ///< m, the farthest that a hand is from what it holds
  double energy = 0.0;            ///< J, of cords and of the bodies that are near them and can be pushed
};

/// Before the step, or, with `moved`, after it. The bodies are then moved as their owner would: as the solver says
/// where it moved them, freely where not.
Figures figures_of(const engine::SolverStep& step, const std::vector<ribbon::Cord>& cords,
                   const std::vector<ribbon::RigidBody>& bodies, bool moved);

}  // namespace flight
