#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ribbon/thesis/body_motions.h"
#include "ribbon/thesis/fem.h"
#include "ribbon/thesis/mesh.h"
#include "ribbon/thesis/self_collision.h"
#include "ribbon/thesis/thesis_def.h"
#include "ribbon/thesis/thesis_points.h"

namespace ribbon {

/// What a ThesisCord consists of: the points, and what moves them in a step.
struct ThesisParts {
  /// Requires a checked definition.
  ThesisParts(const ThesisDef& cord_def, std::unique_ptr<LinearSolver> solver);
  ThesisParts(const ThesisParts&) = delete;
  ThesisParts& operator=(const ThesisParts&) = delete;

  void set_kind(int point, PointKind kind);

  ThesisDef def;
  Mesh mesh;  // the next ones refer to both
  ThesisPoints points;
  BodyMotions bodies;
  std::optional<Fem> fem;                       // if the bars have damping
  std::optional<SelfCollision> self_collision;  // if the cord declares it
};

}  // namespace ribbon
