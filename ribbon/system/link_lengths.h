#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/system/island_state.h"

namespace ribbon {

/// Gives the links of inextensible cords their rest lengths back, where a solve that was ended early has stretched or
/// compressed them. With W the inverse inertias, c the errors of the lengths and J their derivatives, it is a Newton
/// iteration on c(x) = 0 by the displacements that are least in the norm of the inertia (SHAKE, Ryckaert et al. 1977):
///
///     J·W·Jᵀ·λ = c        x ← x − W·Jᵀ·λ.
///
/// Two links share a point only if they are neighbours, so the matrix is tridiagonal and the cost O(points). It is
/// factorised here, and not by BandedLdlt, whose matrix has one size while the cords of an island have many. Points
/// that are constrained, tied or held by bodies do not move.
class LinkLengths {
 public:
  static constexpr double restored_strain = 1e-3;  ///< at which a cord needs no further iteration

  void resize(std::size_t slots);
  /// Changes the positions. `inertia` is that of the stage, by slot, N/m.
  void restore(IslandState& state, std::span<const double> inertia);

 private:
  /// A link's row of the system. A link that is slack, or cannot move, has the row 1·λ = 0.
  struct Row {
    Vec2 normal;
    double diagonal = 1.0;  // m/N
    double upper = 0.0;     // m/N, the entry to the right of it
    double right = 0.0;     // m; after the solve λ, N
  };
  void restore(IslandState& state, const Member& member);
  void load(const IslandState& state, const Member& member);
  bool solve();
  void move(IslandState& state, const Member& member) const;

  std::vector<double> mobility_;  // W, m/N, by point
  std::vector<Row> rows_;         // by link
  std::vector<Vec2> before_;      // m, by point, before the iterations
};

}  // namespace ribbon
