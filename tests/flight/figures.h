#pragma once

#include <vector>

#include "engine/replay/solver_step.h"
#include "ribbon/cord.h"
#include "ribbon/rigid_circle.h"

namespace flight {

/// Figures of a step's cords and bodies, computed from positions, independent of the solver.
struct Figures {
  bool finite = true;
  double stretch = 0.0;           ///< relative elongation of the longest link
  int stretched_cord = -1;        ///< its cord
  double penetration = 0.0;       ///< m, the deepest of a cord in a nearby circle or segment; 0 if none penetrates
  int deep_cord = -1;             ///< its cord
  int deep_body = -1;             ///< its body
  double cord_penetration = 0.0;  ///< m, the deepest of cords with contact, in themselves and each other
  double speed = 0.0;             ///< m/s, of the fastest point
  double grip_gap = 0.0;          ///< m, the greatest distance between a hand and its held point
  double energy = 0.0;            ///< J, of cords and of nearby bodies that cords can push
};

/// Returns the figures before the step or, with `moved`, after it. Bodies then move as their owner would move them: as
/// the solver reports for solver-driven bodies, freely for others.
Figures figures_of(const engine::SolverStep& step, const std::vector<ribbon::Cord>& cords,
                   const std::vector<ribbon::RigidBody>& bodies, bool moved);

}  // namespace flight
