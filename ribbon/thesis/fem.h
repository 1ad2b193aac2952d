#pragma once

#include <memory>
#include <vector>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/thesis/mesh.h"
#include "ribbon/thesis/thesis_def.h"
#include "ribbon/thesis/thesis_points.h"

namespace ribbon {

/// The finite element bars of a cord. The definition and the mesh must outlive it.
class Fem {
 public:
  Fem(const ThesisDef& def, const Mesh& mesh, std::unique_ptr<LinearSolver> solver);

  /// Goto 2017, section 3.4, Eqs. 3.16–3.19 with the restoring sign and with inertia in the matrix that is solved:
  /// U = P − R, F = −K·U on free rows, (K_ff + M/δ²)·U′ = F, P += U′, with K = η/δ for a bar. U is the increment of
  /// this substep. So FEM is an implicit damper of the bar lengths; only the springs restore the shape. Returns false,
  /// and moves nothing, if the matrix is not positive definite.
  bool deform(ThesisPoints& points, double dt);

 private:
  void assemble(const ThesisPoints& points, double dt);

  const ThesisDef* def_;
  const Mesh* mesh_;
  std::unique_ptr<LinearSolver> solver_;
  BandedMatrix matrix_;
  std::vector<double> force_;  // F [N], overwritten by U′ [m]
};

}  // namespace ribbon
