#pragma once

#include <span>

#include "ribbon/vec2.h"

namespace ribbon {

/// Where points are [m] and go [m/s]; without velocities they rest.
struct Motion {
  std::span<const Vec2> x;
  std::span<const Vec2> v;
};

/// How fast two points part, m/s.
inline double extension_rate(const Motion& at, std::size_t a, std::size_t b) {
  if (at.v.empty()) return 0.0;
  const Vec2 ab = at.x[b] - at.x[a];
  const double size = length(ab);
  return size > 0.0 ? dot(ab, at.v[b] - at.v[a]) / size : 0.0;
}

/// A symmetric 2 × 2 block.
struct Block {
  double xx;
  double xy;
  double yy;
};
constexpr Block operator+(Block a, Block b) { return {a.xx + b.xx, a.xy + b.xy, a.yy + b.yy}; }
constexpr Block operator*(double s, Block b) { return {s * b.xx, s * b.xy, s * b.yy}; }

/// What a body adds to the point that holds it, in a Newton step.
struct CarriedLoad {
  std::size_t point;
  Block stiffness;  ///< N/m
  Vec2 residual;    ///< N
};

/// One implicit stage of a time step: find x with M·a = forces at (x, v), where x = x̃ + q²·a and v = ṽ + q·a. With drag
/// C and constant forces f that is, W being the elastic energy and its dissipation,
///
///     (M + q·C)/q² · (x − x̃) + ∇W(x) = f − C·ṽ,
///
/// the stationary point of ½|x − x̃|² in the norm of `inertia`, plus W, minus force·x.
struct Stage {
  double q;                         ///< s
  std::span<const Vec2> predicted;  ///< x̃ [m]; of a constrained point where it is
  std::span<const Vec2> velocity;   ///< ṽ [m/s]; of a constrained point its velocity
  std::span<const double> inertia;  ///< (m + q·c)/q² [N/m]
  std::span<const Vec2> force;      ///< f − c·ṽ [N]
  std::span<const char> constrained;
  std::span<const CarriedLoad> carried = {};  ///< by point, ascending
  /// What is pushed together has a negative geometric stiffness. A bar that is given none converges slowly; with no
  /// less than this share of the inertia of its ends, two bars a point of 2·share each leave the matrix positive
  /// definite.
  static constexpr double bearable_push = -0.24;
  /// Of the inertia of its ends, ≤ 0: the least geometric stiffness that a bar of a chain is given.
  double least_geometric = 0.0;
  bool euler = false;  ///< implicit Euler: v = (x − x₀)/q with x₀ = x̃ − q·ṽ

  Vec2 residual(std::size_t p, Vec2 x) const { return force[p] - inertia[p] * (x - predicted[p]); }
  /// v at x.
  Vec2 velocity_at(std::size_t p, Vec2 x) const { return velocity[p] + (1.0 / q) * (x - predicted[p]); }
  /// x₀ of implicit Euler.
  Vec2 start(std::size_t p) const { return predicted[p] - q * velocity[p]; }
};

/// m/s, by which implicit Euler has a bar lengthen faster than it does. Its velocities are along the chords of the
/// ways: d·v of a bar that turns by φ and keeps its length L is (1 − cos φ)·L/q. Damping would hold that back and
/// shorten the bar in every step, so it acts on (|D| − |E|)/q = d·v − (|E| − d·E)/q instead, from E at the start to D =
/// |D|·d: the gradient of a potential, which takes energy however far the bar turns.
inline double turning_rate(const Stage& stage, Vec2 start, Vec2 d) {
  return stage.euler ? (length(start) - dot(d, start)) / stage.q : 0.0;
}

}  // namespace ribbon
