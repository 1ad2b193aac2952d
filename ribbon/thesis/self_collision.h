#pragma once

#include <vector>

#include "ribbon/thesis/broad_phase.h"
#include "ribbon/thesis/mesh.h"
#include "ribbon/thesis/thesis_def.h"
#include "ribbon/thesis/thesis_points.h"

namespace ribbon {

/// Contact of a cord with itself. The definition and the mesh must outlive it.
class SelfCollision {
 public:
  SelfCollision(const ThesisDef& def, const Mesh& mesh);

  /// Starts a step: finds the columns where the cord crosses itself. Returns their number.
  int begin_step(const ThesisPoints& points);
  /// Goto 2017, section 3.6: the circle of each point against the triangles that are not its own. Tangled columns have
  /// no contact with each other. Returns the number of contacts.
  int collide(ThesisPoints& points);

 private:
  const ThesisDef* def_;
  const Mesh* mesh_;
  BroadPhase broad_phase_;
  std::vector<double> radii_;
  std::vector<char> tangled_;  // by column: 1 where the cord crosses itself in this step
};

}  // namespace ribbon
