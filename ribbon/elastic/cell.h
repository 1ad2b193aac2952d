#pragma once

#include <array>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// The four corners in the order (ξ, η) = (−, −), (−, +), (+, −), (+, +), ξ along the cord and η across it; m.
using Corners = std::array<Vec2, 4>;

/// A rectangular cell a × b: the co-rotated incompatible-mode quadrilateral (Wilson, Taylor), in closed form. With
/// points as complex numbers X_i and g_i = ξ_i/(2a) + i·η_i/(2b):
///
///     z = Σ conj(g_i)·X_i      |z| = s₁ + s₂ with the principal stretches; z/|z| is the polar rotation
///     w = Σ g_i·X_i            |w| = |s₁ − s₂|
///     h = ¼ Σ ξ_i·η_i·X_i      the hourglass mode: bending of the cell
///
///     W = A·(½μ|w|² + ½(μ + λ)(|z| − 2)²) + ½k_h·|h|²,     A = a·b
///
/// with the plane-stress Lamé constants μ = E/(2(1 + ν)), λ = E·ν/(1 − ν²), E in N/m, and k_h = 16·EI/(a·b²), EI of the
/// cell. w and h are linear in X. z is a bar of rest length 2 and tension τ = A(μ + λ)(|z| − 2).
struct Cell {
  double gx;         ///< 1/(2a), 1/m
  double gy;         ///< 1/(2b), 1/m
  double shear;      ///< A·μ, J
  double stretch;    ///< A·(μ + λ), J
  double hourglass;  ///< k_h, N/m
  double area;       ///< A, m²
};

/// Returns the cell of the rest size a × b [m], E = `modulus` [N/m], ν and EI [N·m²].
Cell make_cell(double a, double b, double modulus, double poisson_ratio, double bending_stiffness);

/// The deformation modes of a cell; see Cell.
struct CellModes {
  Vec2 z;  ///< rotation and spread, dimensionless
  Vec2 w;  ///< shear, dimensionless
  Vec2 h;  ///< hourglass mode, m
};
/// Returns the modes of a cell with corners x [m].
CellModes modes(const Cell& cell, const Corners& x);

/// Returns the energy of w and h, J.
double bending_and_shear_energy(const Cell& cell, const CellModes& shape);
/// Returns the forces −∇W [N] on the corners. The force of z is given by `pull` [J]: its tension times its direction.
Corners forces(const Cell& cell, const CellModes& shape, Vec2 pull);

/// Adds the Hessians of cells to a banded matrix. `first` and `second` are the points of a cell with η = −1, at ξ = −1
/// and ξ = +1; those with η = +1 are the next points. Point p has the rows 2p and 2p + 1.
class CellAssembler {
 public:
  explicit CellAssembler(BandedMatrix& matrix) : matrix_(matrix) {}
  /// Adds `scale` times the Hessian of w and h, which is constant, with `hourglass` [N/m] for k_h.
  void add_constant(const Cell& cell, double hourglass, double scale, int first, int second);
  /// Adds the Hessian of z: along·u·uᵀ + across·v·vᵀ with u_i = g_i·d, v_i = i·u_i, d = z/|z|; `along` and `across` in
  /// J.
  void add_spread(const Cell& cell, Vec2 d, double along, double across, int first, int second);

 private:
  void add_block(int i, int j, Vec2 similar, Vec2 mirrored);
  void locate(int first, int second);

  BandedMatrix& matrix_;
  std::array<int, 4> point_{};
};

/// Returns twice the signed areas of the corner triangles [m²], in the order of the corners; negative if inverted.
std::array<double, 4> doubled_corner_areas(const Corners& x);

}  // namespace ribbon
