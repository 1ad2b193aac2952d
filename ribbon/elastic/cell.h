#pragma once

#include <array>

#include "ribbon/linear/banded_ldlt.h"
#include "ribbon/vec2.h"

namespace ribbon {

/// Four corners in the order (ξ, η) = (−, −), (−, +), (+, −), (+, +), ξ along the cord and η across.
using Corners = std::array<Vec2, 4>;

/// A rectangular cell a × b of Wilson's incompatible modes, co-rotated, in closed form. With points as complex numbers
/// X_i and g_i = ξ_i/(2a) + i·η_i/(2b):
///
///     z = Σ conj(g_i)·X_i      |z| = s₁ + s₂ of the principal stretches, z/|z| the polar rotation
///     w = Σ g_i·X_i            |w| = |s₁ − s₂|
///     h = ¼ Σ ξ_i·η_i·X_i      the hourglass mode, which is how a cell bends
///
///     W = A·(½μ|w|² + ½(μ + λ)(|z| − 2)²) + ½k_h·|h|²,     A = a·b
///
/// with the plane-stress Lamé constants μ = E/(2(1 + ν)), λ = E·ν/(1 − ν²) of E in N/m, and k_h = 16·EI/(a·b²), EI that
/// of the cell. w and h are linear in X, and z is a bar of rest length 2 with the tension τ = A(μ + λ)(|z| − 2).
struct Cell {
  double gx;         ///< 1/(2a), 1/m
  double gy;         ///< 1/(2b), 1/m
  double shear;      ///< A·μ, J
  double stretch;    ///< A·(μ + λ), J
  double hourglass;  ///< k_h, N/m
  double area;       ///< A, m²
};

/// a, b [m], E [N/m], ν, EI [N·m²].
Cell make_cell(double a, double b, double modulus, double poisson_ratio, double bending_stiffness);

/// What a cell's shape says of its strain.
struct CellModes {
  Vec2 z;
  Vec2 w;  ///< 1
  Vec2 h;  ///< m
};
CellModes modes(const Cell& cell, const Corners& x);

/// Energy of w and h, J.
double bending_and_shear_energy(const Cell& cell, const CellModes& at);
/// The forces −∇W [N] on the corners: w and h by their stiffnesses, z by `pull` [J], its tension times its direction.
Corners forces(const Cell& cell, const CellModes& at, Vec2 pull);

/// Adds a cell's Hessian to the matrix; `first` and `second` are its points of lower η on either side, and points are
/// pairs of rows, neighbours across in sequence.
class CellAssembler {
 public:
  explicit CellAssembler(BandedMatrix& matrix) : matrix_(matrix) {}
  /// Of w and h, constant; both scaled by `scale`, and `hourglass` [N/m] in place of the cell's own.
  void add_constant(const Cell& cell, double hourglass, double scale, int first, int second);
  /// Of z: along·u·uᵀ + across·v·vᵀ, u_i = g_i·d, v_i = i·u_i, d = z/|z| [both in J].
  void add_spread(const Cell& cell, Vec2 d, double along, double across, int first, int second);

 private:
  void add_block(int i, int j, Vec2 similar, Vec2 mirrored);
  void locate(int first, int second);

  BandedMatrix& matrix_;
  std::array<int, 4> point_{};
};

/// Twice the signed areas of the corner triangles, in the order of the corners, m².
std::array<double, 4> doubled_corner_areas(const Corners& x);

}  // namespace ribbon
