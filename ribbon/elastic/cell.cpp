#include "ribbon/elastic/cell.h"

#include <algorithm>

#include "ribbon/geometry/rotation.h"
#include "ribbon/linear/index.h"

namespace ribbon {

Cell make_cell(double a, double b, double modulus, double poisson_ratio, double bending_stiffness) {
  const double mu = modulus / (2.0 * (1.0 + poisson_ratio));
  const double mu_and_lambda = modulus / (2.0 * (1.0 - poisson_ratio));
  const double area = a * b;
  return {0.5 / a, 0.5 / b, area * mu, area * mu_and_lambda, 16.0 * bending_stiffness / (area * b), area};
}

CellModes modes(const Cell& cell, const Corners& x) {
  const Vec2 along = cell.gx * ((x[2] + x[3]) - (x[0] + x[1]));   // Σ ξ/(2a)·X
  const Vec2 across = cell.gy * ((x[1] + x[3]) - (x[0] + x[2]));  // Σ η/(2b)·X
  return {along - perp(across), along + perp(across), 0.25 * ((x[0] - x[1]) - (x[2] - x[3]))};
}

double bending_and_shear_energy(const Cell& cell, const CellModes& shape) {
  return 0.5 * (cell.shear * dot(shape.w, shape.w) + cell.hourglass * dot(shape.h, shape.h));
}

/// The gradients as complex numbers are ∂(½|w|²)/∂X_i = conj(g_i)·w, ∂|z|/∂X_i = g_i·d and ∂(½|h|²)/∂X_i = ¼ξη·h.
Corners forces(const Cell& cell, const CellModes& shape, Vec2 pull) {
  const Vec2 w = cell.shear * shape.w;
  const Vec2 h = (0.25 * cell.hourglass) * shape.h;
  const Vec2 along = cell.gx * (w + pull);       // real parts of g, ξ/(2a)
  const Vec2 across = cell.gy * perp(pull - w);  // imaginary parts, η/(2b)
  return {(along + across) - h, (along - across) + h, (across - along) + h, -(along + across) - h};
}

void CellAssembler::locate(int first, int second) { point_ = {first, first + 1, second, second + 1}; }

/// Adds a 2 × 2 block between corners i ≤ j. Its action on a complex number x is similar·x + mirrored·conj(x).
void CellAssembler::add_block(int i, int j, Vec2 similar, Vec2 mirrored) {
  const int r = 2 * point_[at(i)];
  const int offset = 2 * point_[at(j)] - r;
  double* upper = matrix_.row(r) + offset;
  double* lower = matrix_.row(r + 1) + offset;
  upper[0] += similar.x + mirrored.x;
  upper[1] += mirrored.y - similar.y;
  if (i != j) lower[-1] += mirrored.y + similar.y;
  lower[0] += similar.x - mirrored.x;
}

/// The block of corners i and j multiplies by A·μ·conj(g_i)·g_j for w, and by k_h/16 with the sign of ξη for h.
void CellAssembler::add_constant(const Cell& cell, double hourglass, double scale, int first, int second) {
  locate(first, second);
  const double gg = scale * cell.shear * (cell.gx * cell.gx + cell.gy * cell.gy);
  const Vec2 e = (scale * cell.shear) * Vec2{cell.gx * cell.gx - cell.gy * cell.gy, -2.0 * cell.gx * cell.gy};
  const double k = scale * hourglass / 16.0;
  for (int i = 0; i < 4; ++i) add_block(i, i, {gg + k, 0.0}, {});
  add_block(0, 1, e - Vec2{k, 0.0}, {});
  add_block(0, 2, -e - Vec2{k, 0.0}, {});
  add_block(0, 3, {k - gg, 0.0}, {});
  add_block(1, 2, {k - gg, 0.0}, {});
  add_block(1, 3, -conj(e) - Vec2{k, 0.0}, {});
  add_block(2, 3, conj(e) - Vec2{k, 0.0}, {});
}

/// u_i·u_jᵀ + v_i·v_jᵀ multiplies by u_i·conj(u_j) = g_i·conj(g_j). u_i·u_jᵀ − v_i·v_jᵀ conjugates and multiplies by
/// u_i·u_j = g_i·g_j·d². Both have three different values, their conjugates and negatives.
void CellAssembler::add_spread(const Cell& cell, Vec2 d, double along, double across, int first, int second) {
  locate(first, second);
  const Vec2 g2{cell.gx * cell.gx - cell.gy * cell.gy, 2.0 * cell.gx * cell.gy};
  const double gg = cell.gx * cell.gx + cell.gy * cell.gy;
  const double similar = 0.5 * (along + across);
  const Vec2 mirrored = (0.5 * (along - across)) * times(d, d);
  const Vec2 s{similar * gg, 0.0};
  const Vec2 se = similar * g2;
  const Vec2 m = gg * mirrored;
  const Vec2 me = times(g2, mirrored);
  const Vec2 mc = times(conj(g2), mirrored);
  add_block(0, 0, s, me);
  add_block(1, 1, s, mc);
  add_block(2, 2, s, mc);
  add_block(3, 3, s, me);
  add_block(0, 1, se, m);
  add_block(0, 2, -se, -m);
  add_block(0, 3, -s, -me);
  add_block(1, 2, -s, -mc);
  add_block(1, 3, -conj(se), -m);
  add_block(2, 3, conj(se), m);
}

std::array<double, 4> doubled_corner_areas(const Corners& x) {
  const Vec2 bottom = x[2] - x[0];
  const Vec2 top = x[3] - x[1];
  const Vec2 left = x[1] - x[0];
  const Vec2 right = x[3] - x[2];
  return {cross(bottom, left), cross(top, left), cross(bottom, right), cross(top, right)};
}

}  // namespace ribbon
