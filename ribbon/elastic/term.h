#pragma once

#include <span>
#include <vector>

#include "ribbon/elastic/link.h"
#include "ribbon/elastic/stage.h"
#include "ribbon/linear/banded_ldlt.h"

namespace ribbon {

/// Returns along·d·dᵀ + across·u·uᵀ with u = perp(d), |d| = 1.
constexpr Block directed(Vec2 d, double along, double across) {
  return {along * d.x * d.x + across * d.y * d.y, (along - across) * d.x * d.y, along * d.y * d.y + across * d.x * d.x};
}

/// The positions at which the terms of a lattice are evaluated in a stage.
struct Shape {
  const Stage& stage;
  std::span<const Vec2> x;       ///< m
  std::span<const Vec2> damped;  ///< m, x + β·v: its elastic forces are the sum of elastic and damping forces at x
  double stiffening;             ///< 1 + β/q: damping multiplies the elastic Hessian by it
};

/// The Newton system of a lattice, to which its terms add. Point p has the rows 2p and 2p + 1.
struct NewtonSystem : Shape {
  BandedMatrix& matrix;
  std::span<Vec2> force;  ///< N, the right-hand side

  /// Adds b to the blocks (p, q) and (q, p), p ≤ q.
  void add(int p, int q, Block b) const {
    double* upper = matrix.row(2 * p) + 2 * (q - p);
    double* lower = matrix.row(2 * p + 1) + 2 * (q - p);
    upper[0] += b.xx;
    upper[1] += b.xy;
    if (p != q) lower[-1] += b.xy;
    lower[0] += b.yy;
  }
  /// Adds b to the blocks (p, p) and (q, q), and subtracts it from (p, q) and (q, p); p < q.
  void add_between(int p, int q, Block b) const {
    const int along = 2 * (q - p);
    double* p_upper = matrix.row(2 * p);
    double* p_lower = p_upper + matrix.stride();
    double* q_upper = p_upper + along * matrix.stride();
    double* q_lower = q_upper + matrix.stride();
    p_upper[0] += b.xx;
    p_upper[1] += b.xy;
    p_upper[along] -= b.xx;
    p_upper[along + 1] -= b.xy;
    p_lower[0] += b.yy;
    p_lower[along - 1] -= b.xy;
    p_lower[along] -= b.yy;
    q_upper[0] += b.xx;
    q_upper[1] += b.xy;
    q_lower[0] += b.yy;
  }
  /// Adds factor·g·hᵀ to the block (p, q), p ≤ q, and its transpose to (q, p).
  void add_outer(int p, int q, double factor, Vec2 g, Vec2 h) const {
    double* upper = matrix.row(2 * p) + 2 * (q - p);
    double* lower = matrix.row(2 * p + 1) + 2 * (q - p);
    upper[0] += factor * g.x * h.x;
    upper[1] += factor * g.x * h.y;
    if (p != q) lower[-1] += factor * g.y * h.x;
    lower[0] += factor * g.y * h.y;
  }
};

/// One kind of elastic energy: the sum over its elements. Functions without a comment are as in Elasticity. A Lattice
/// has terms, a Chain has none: for a term of its own that a rope declares, make_elasticity has to choose a Lattice, as
/// it does for bending stiffness.
class Term {
 public:
  Term() = default;
  Term(const Term&) = delete;
  Term& operator=(const Term&) = delete;
  virtual ~Term() = default;

  virtual std::size_t tension_count() const { return 0; }
  virtual void find_tensions(std::span<const Vec2> /*x*/, std::span<double> /*tensions*/) const {}
  virtual void add_damping(const Motion& /*motion*/, double /*sign*/, std::span<double> /*tensions*/) const {}
  virtual void add_rotational_damping(const Stage& /*stage*/, std::span<const Vec2> /*x*/,
                                      std::span<double> /*tensions*/) const {}
  virtual void set_rest_lengths(std::span<const double> lengths) = 0;
  /// Adds the part of the Hessian that does not depend on the positions.
  virtual void add_constant(BandedMatrix& /*matrix*/) const {}
  /// Adds the forces, and the part of the Hessian that depends on the positions.
  virtual void load(const NewtonSystem& system, std::span<const double> tensions) = 0;
  /// Writes the tensions after the step `direction` [m] to `next`. The system must be the one that was loaded last.
  virtual void update(const NewtonSystem& /*system*/, std::span<const double> /*tensions*/,
                      std::span<const Vec2> /*direction*/, std::span<double> /*next*/) const {}
  virtual void append_bars(const Shape& /*shape*/, std::span<const double> /*tensions*/,
                           std::vector<OneSidedBar>& /*bars*/) const {}
  virtual double active_set_error(const Shape& /*shape*/, std::span<const double> /*tensions*/) const { return 0.0; }
  /// See Elasticity. For a quadratic term it is the energy at the damped positions, divided by the stiffening: its
  /// gradient is the sum of the elastic and the damping force.
  virtual double potential(const Shape& shape, std::span<const double> max_tensions) const = 0;
  virtual double energy(const Motion& motion, std::span<const double> tensions) const = 0;
  virtual Vec2 force_on(std::size_t point, const Motion& motion, std::span<const double> tensions) const = 0;
  virtual Vec2 section_force(std::size_t /*link*/, const Motion& /*motion*/,
                             std::span<const double> /*tensions*/) const {
    return {};
  }
  virtual bool unlock(std::span<const Vec2> /*x*/) { return false; }
  virtual std::span<char> unlocked() { return {}; }
  virtual void lock() {}
  virtual bool has_deep_inversion(std::span<const Vec2> /*x*/) const { return false; }
};

}  // namespace ribbon
