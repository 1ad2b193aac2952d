#pragma once

#include <limits>
#include <span>
#include <vector>

#include "ribbon/convex/slot_row.h"
#include "ribbon/linear/block_ldlt.h"

namespace ribbon {

/// A spring of limited force along a length that is linear in a step δ. With z = value + J·δ its force along J is
///
///     f = clamp(−z/compliance, low, high) = −φ′(z),     φ convex.
///
/// A contact has low = 0 and high = ∞; friction and a slipping grip have −S and S, S being the largest force. A bar
/// that cannot push has low = 0 and high = ∞, and z is its shortening.
struct LimitedRow {
  SlotRow row;        ///< J
  double value;       ///< m, z without a step
  double compliance;  ///< m/N, above 0
  double low;         ///< N, below `high`; finite
  double high;        ///< N, or infinity
  double force;       ///< N: predicted, and after a solve its solution
  /// m/N, of a bar: how far a force beyond its limit moves a point; 0 for other rows.
  double point_compliance = 0.0;

  bool is_bar() const { return point_compliance > 0.0; }

  bool has_high() const { return high < std::numeric_limits<double>::infinity(); }
};

/// The limited springs of a convex problem
///
///     ½·δᵀ·H·δ − rᵀ·δ + Σ φ(z)   → min.
///
/// It is solved by linear systems of H and a multiple of Jᵀ·J for each row, see ActiveSet and InteriorPoint.
class LimitedRows {
 public:
  void clear() { rows_.clear(); }
  /// Reserves memory for so many rows.
  void reserve(std::size_t count) { rows_.reserve(count); }
  void add(const LimitedRow& row) { rows_.push_back(row); }
  std::span<const LimitedRow> rows() const { return rows_; }
  std::span<LimitedRow> rows() { return rows_; }
  bool empty() const { return rows_.empty(); }

  /// Calls visit(a, b) for every two slots of a row, in both orders, and for each with itself.
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
  /// Returns Σ φ(z) after this fraction of a step, J, without bars: their energy is that of their cords.
  double potential(std::span<const Vec2> step, double fraction) const;

 private:
  std::vector<LimitedRow> rows_;
};

}  // namespace ribbon
