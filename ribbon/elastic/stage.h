#pragma once

#include <span>

#include "ribbon/vec2.h"

namespace ribbon {

/// Positions and velocities of points. Without velocities the points are at rest.
struct Motion {
  std::span<const Vec2> x;  ///< m
  std::span<const Vec2> v;  ///< m/s; may be empty
};

/// Returns the rate of change of the distance between points a and b, m/s.
inline double extension_rate(const Motion& motion, std::size_t a, std::size_t b) {
  if (motion.v.empty()) return 0.0;
  const Vec2 ab = motion.x[b] - motion.x[a];
  const double size = length(ab);
  return size > 0.0 ? dot(ab, motion.v[b] - motion.v[a]) / size : 0.0;
}

/// A symmetric 2 × 2 block.
struct Block {
  double xx;
  double xy;
  double yy;
};
constexpr Block operator+(Block a, Block b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
constexpr Block operator*(double s, Block b) { return {s * b.xx, s * b.xy, s * b.yy}; }
constexpr Vec2 operator*(Block b, Vec2 v) { return {b.xx * v.x + b.xy * v.y, b.xy * v.x + b.yy * v.y}; }

/// A body that a point holds, condensed to that point for a Newton step: its unknowns are eliminated.
struct CondensedBody {
  std::size_t point;  ///< index
  Block stiffness;    ///< N/m
  Vec2 residual;      ///< N
};

/// One implicit stage of a time step: find x with M·a = forces at (x, v), where x = x̃ + q²·a and v = ṽ + q·a. With drag
/// C, constant forces f, and the elastic energy and dissipation potential W, the equation is
///
///     (M + q·C)/q² · (x − x̃) + ∇W(x) = f − C·ṽ.
///
/// Its solution is the stationary point of ½|x − x̃|² in the norm of `inertia`, plus W, minus force·x. A medium adds a
/// `resistance` to the inertia, which differs from direction to direction.
struct Stage {
  double q;                                              ///< s
  std::span<const Vec2> predicted;                       ///< x̃ [m]; of a constrained point its position
  std::span<const Vec2> velocity;                        ///< ṽ [m/s]; of a constrained point its velocity
  std::span<const double> inertia;                       ///< (m + q·c)/q² [N/m]
  std::span<const Vec2> force;                           ///< f − c·ṽ [N]
  std::span<const char> constrained;                     ///< 1 for a constrained point, 0 for others
  std::span<const CondensedBody> condensed_bodies = {};  ///< ordered by point
  /// Lower bound of min_geometric_ratio. A bar under compression has a negative geometric stiffness; Newton's method
  /// converges slowly without it. Two bars per point subtract at most 4 · 0.24 of the point's inertia, so the matrix
  /// stays positive definite.
  static constexpr double definite_geometric_ratio = -0.24;
  /// The least geometric stiffness of a bar of a chain, as a multiple of the smaller inertia of its ends, ≤ 0.
  double min_geometric_ratio = 0.0;
  /// Bars of chains are proximal() in coupled solves: where more is asked of an inextensible rope than is possible, its
  /// tensions stay small enough for a definite matrix.
  bool is_proximal = false;
  /// Bars that cannot push are limited rows of a convex problem (OneSidedBar): a coupled system has only their
  /// geometric stiffness.
  bool bars_are_rows = false;
  std::span<const Block> resistance = {};  ///< N/m, by point, of a medium; empty without one
  bool implicit_euler = false;  ///< the stage is a step of implicit Euler: v = (x − x₀)/q with x₀ = x̃ − q·ṽ

  /// Returns the force on point p at x without that of W, less its inertia force, N.
  Vec2 residual(std::size_t p, Vec2 x) const {
    const Vec2 free = residual_without_medium(p, x);
    return resistance.empty() ? free : free - resistance[p] * (x - predicted[p]);
  }
  /// Returns the same without the force of a medium.
  Vec2 residual_without_medium(std::size_t p, Vec2 x) const { return force[p] - inertia[p] * (x - predicted[p]); }
  /// Returns the velocity of point p at x, m/s.
  Vec2 velocity_at(std::size_t p, Vec2 x) const { return velocity[p] + (1.0 / q) * (x - predicted[p]); }
  /// Returns the start position x₀ of implicit Euler, m.
  Vec2 start(std::size_t p) const { return predicted[p] - q * velocity[p]; }
};

/// Returns the extension rate [m/s] that implicit Euler computes for the rotation of a bar, `start` its vector E at the
/// start and d its direction at the end; 0 in other stages.
///
/// The velocities of implicit Euler are chords: a bar that rotates by φ and keeps its length L has d·v = (1 − cos
/// φ)·L/q. Damping of this rate would shorten the bar in every step. So damping acts on the change of length instead,
/// from E to D = |D|·d:
///
///     (|D| − |E|)/q = d·v − (|E| − d·E)/q.
///
/// Its force is the gradient of a potential, and it dissipates energy for any rotation.
inline double rotational_extension_rate(const Stage& stage, Vec2 start, Vec2 d) {
  return stage.implicit_euler ? (length(start) - dot(d, start)) / stage.q : 0.0;
}

}  // namespace ribbon
