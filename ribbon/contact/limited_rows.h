#pragma once

#include <span>
#include <vector>

#include "ribbon/contact/slot_row.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// A spring of limited force along a length that is linear in a step δ: with z = value + J·δ its force along J is
///
///     f = clamp(−z/compliance, low, high),     the slope of a convex potential.
///
/// A contact is one with low = 0, high = ∞; friction one with −S and S; what slips at its strength, too.
struct LimitedRow {
  SlotRow row;        ///< J
  double value;       ///< m, z without a step
  double compliance;  ///< m/N, above 0
  double low;         ///< N, below `high`; finite
  double high;        ///< N, or infinity
  double force;       ///< N, expected, and after a solve found
};

/// The limited springs of a convex problem
///
///     ½·δᵀ·H·δ − rᵀ·δ + Σ φ(z)   → min,
///
/// and two ways to solve it by linear systems of H and a multiple of J·Jᵀ for each row: by active sets, which end at
/// the very solution in a few systems where the expected forces are nearly right, and else may go on for ever; and by
/// an interior point, which ends from anywhere in some ten (Mehrotra 1992; Nocedal & Wright 2006, 16.6). Memory grows
/// with the number of rows only.
class LimitedRows {
 public:
  void clear() { rows_.clear(); }
  /// Takes the memory for so many.
  void reserve(std::size_t count);
  void add(const LimitedRow& row) { rows_.push_back(row); }
  std::span<const LimitedRow> rows() const { return rows_; }
  bool empty() const { return rows_.empty(); }

  /// Tells visit(a, b) every two slots of a row, both ways round.
  template <typename Visit>
  void for_each_pair(Visit&& visit) const {
    for (const LimitedRow& limited : rows_) {
      for (const int a : limited.row.slots()) {
        for (const int b : limited.row.slots()) visit(a, b);
      }
    }
  }
  void couple(BlockLdlt& matrix) const;
  bool are_coupled(const BlockLdlt& matrix) const;
  /// J, of all of them after `share` of a step.
  double potential(std::span<const Vec2> step, double share) const;

  // Active sets: each row is at a limit, or a spring.

  /// Takes each row to be where its expected force is.
  void begin_active_set();
  void load_active_set(BlockLdlt& matrix, std::span<Vec2> right_side) const;
  /// Takes over the step that the system gave. How many rows it did not leave where they were taken to be, nor so near
  /// that they are off by no more than `tolerance` [m] or a ten thousandth of the greatest force: if none, it is the
  /// solution.
  int update_active_set(std::span<const Vec2> step, double tolerance);

  // Interior point, to be begun after an active set was tried.

  void begin_interior();
  /// Each iteration: the matrix, then the right side, which predicts; after `predict` the one that corrects; and
  /// `advance` with its solution.
  void load_interior(BlockLdlt& matrix) const;
  void load_interior_force(std::span<Vec2> right_side) const;
  void predict(std::span<const Vec2> step);
  void advance(std::span<const Vec2> step);
  /// How far it is from the solution, 1 at the start: complementarity, and what of the start's misfit is left.
  double gap() const { return gap_; }
  /// Takes each row to be where the interior point has it.
  void end_interior();

 private:
  enum class State : unsigned char { low, spring, high };
  /// Of a row, inside: f between its limits, and with the multipliers p and q of these
  ///
  ///     z + f·compliance − p + q = 0,     p·(f − low) = q·(high − f) = μ → 0.
  struct Inside {
    double force = 0.0;
    double low = 0.0;         // p, m
    double high = 0.0;        // q, m; 0 where there is no such limit
    double next_force = 0.0;  // of the last linear solve
    double next_low = 0.0;
    double next_high = 0.0;
    double low_product = 0.0;  // of what the predictor changes, Δf·Δp
    double high_product = 0.0;
  };
  static bool has_high(const LimitedRow& row);
  double stiffness(std::size_t k) const;
  void take_next(std::span<const Vec2> step);
  double longest_share() const;
  double complementarity(double share) const;

  std::vector<LimitedRow> rows_;
  std::vector<State> states_;
  std::vector<Inside> inside_;
  double known_force_ = 0.0;       // N, the largest that presses, before an active set was tried
  double most_force_ = 0.0;        // N
  double centring_ = 0.0;          // N·m, σ·μ
  double first_mu_ = 0.0;          // N·m
  double length_per_force_ = 1.0;  // m/N, of where the interior point begins
  double misfit_ = 1.0;
  double gap_ = 1.0;
};

}  // namespace ribbon
