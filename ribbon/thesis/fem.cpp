#include "ribbon/thesis/fem.h"

#include <algorithm>
#include <utility>

#include "ribbon/linear/index.h"
#include "ribbon/thesis/bar.h"

namespace ribbon {

Fem::Fem(const ThesisDef& def, const Mesh& mesh, std::unique_ptr<LinearSolver> solver)
    : def_(&def),
      mesh_(&mesh),
      solver_(std::move(solver)),
      matrix_(2 * mesh.size(), 2 * mesh.h + 3),
      force_(2 * at(mesh.size())) {}

bool Fem::deform(ThesisPoints& points, double dt) {
  assemble(points, dt);
  if (!solver_->solve(matrix_, force_)) return false;
  for (std::size_t p = 0; p < points.positions.size(); ++p) {
    if (points.inverse_mass[p] > 0.0) points.positions[p] += {force_[2 * p], force_[2 * p + 1]};
  }
  return true;
}

/// Assembles the global matrix and force, Eqs. 3.12–3.15 and 3.17. Directions are those at R, which conserves angular
/// momentum.
void Fem::assemble(const ThesisPoints& points, double dt) {
  const std::vector<Vec2>& start = points.substep_start;
  const double k = def_->bar_damping / dt;
  const double inertia = def_->point_mass / (dt * dt);
  matrix_.set_zero();
  for (int row = 0; row < matrix_.size(); ++row) matrix_.row(row)[0] = inertia;
  std::fill(force_.begin(), force_.end(), 0.0);
  for (const Connection& bar : mesh_->connections) {
    const std::size_t a = at(bar.a);
    const std::size_t b = at(bar.b);
    const Vec2 ab = start[b] - start[a];
    const double size = length(ab);
    if (size == 0.0) continue;  // it has no direction
    const Vec2 direction = (1.0 / size) * ab;
    const bool free_a = points.inverse_mass[a] > 0.0;
    const bool free_b = points.inverse_mass[b] > 0.0;
    add_bar_stiffness(matrix_, bar.a, bar.b, direction, k, free_a, free_b);
    const Vec2 pull = bar_force(direction, k, points.positions[a] - start[a], points.positions[b] - start[b]);
    if (free_a) {
      force_[2 * a] += pull.x;
      force_[2 * a + 1] += pull.y;
    }
    if (free_b) {
      force_[2 * b] -= pull.x;
      force_[2 * b + 1] -= pull.y;
    }
  }
}

}  // namespace ribbon
