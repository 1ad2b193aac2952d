#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/convex/active_set.h"
#include "ribbon/convex/limited_rows.h"

namespace ribbon {

/// Primal-dual interior point method with predictor and corrector (Mehrotra 1992; Nocedal & Wright 2006, 16.6). It
/// converges from any start, in about ten iterations. An iteration solves one matrix for two right sides: load_matrix,
/// load_force, predict with the solution, load_force, advance with the solution.
class InteriorPoint {
 public:
  /// Reserves memory for so many rows.
  void reserve(std::size_t count) { points_.reserve(count); }
  /// Starts from the forces of the rows, after an active set was tried. Contact forces are limited to `max_force` [N]
  /// unless that is 0, because an active set that is far off may find forces out of all proportion, from which
  /// convergence is slow.
  void begin(std::span<const LimitedRow> rows, double max_force);
  void load_matrix(std::span<const LimitedRow> rows, BlockLdlt& matrix) const;
  /// Adds the right side of the predictor, or, after predict(), of the corrector.
  void load_force(std::span<const LimitedRow> rows, std::span<Vec2> right_side) const;
  void predict(std::span<const LimitedRow> rows, std::span<const Vec2> step);
  /// Takes over the solution of the corrector, and the forces of the rows.
  void advance(std::span<LimitedRow> rows, std::span<const Vec2> step);
  /// Returns the distance from the solution, 1 at the start: the larger of the complementarity and of the residual,
  /// each relative to that at the start.
  double gap() const { return gap_; }
  /// Sets the active set to the one that the method converges to: a row is at a limit if its multiplier outweighs the
  /// distance of the force from the limit. The force is then that limit: a little force that is left of a contact would
  /// limit its friction to so little that the next solve, which starts inside all limits, takes tiny steps.
  void end(std::span<LimitedRow> rows, ActiveSet& active_set) const;

 private:
  /// The force f of a row, strictly between its limits, and its multipliers p and q:
  ///
  ///     z + f·compliance − p + q = 0,     p·(f − low) = q·(high − f) = μ → 0.
  struct Point {
    double force = 0.0;       // N, f
    double low = 0.0;         // m, p
    double high = 0.0;        // m, q; 0 without an upper limit
    double next_force = 0.0;  // by the last linear solve
    double next_low = 0.0;
    double next_high = 0.0;
    double low_product = 0.0;   // N·m, Δf·Δp of the predictor
    double high_product = 0.0;  // N·m, Δf·Δq
  };
  static double stiffness(const LimitedRow& row, const Point& point);
  void solve_rows(std::span<const LimitedRow> rows, std::span<const Vec2> step);
  double max_fraction(std::span<const LimitedRow> rows) const;
  double complementarity(std::span<const LimitedRow> rows, double fraction) const;

  std::vector<Point> points_;      // by row
  double centring_ = 0.0;          // N·m, σ·μ
  double first_mu_ = 0.0;          // N·m
  double length_per_force_ = 1.0;  // m/N, of the start
  double residual_ = 1.0;          // relative to that of the start
  double gap_ = 1.0;
};

}  // namespace ribbon
