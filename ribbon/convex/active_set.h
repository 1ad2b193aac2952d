#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/convex/limited_rows.h"

namespace ribbon {

/// Active set method: each row is taken to be at one of its limits, or a spring. It ends at the exact solution, in a
/// few linear systems if the predicted forces are nearly right; otherwise it may cycle.
class ActiveSet {
 public:
  enum class State : unsigned char { low, spring, high };

  /// Reserves memory for so many rows.
  void reserve(std::size_t count) { states_.reserve(count); }
  /// Sets the state of each row by its predicted force.
  void begin(std::span<const LimitedRow> rows);
  /// Adds the rows to a linear system.
  void load(std::span<const LimitedRow> rows, BlockLdlt& matrix, std::span<Vec2> right_side) const;
  /// Takes over the step that the system gave: forces and states. Returns the number of rows whose state has changed,
  /// except those that are within `tolerance` [m], or a ten thousandth of the largest force, of the limit. If there
  /// are none, the step is the solution.
  int update(std::span<LimitedRow> rows, std::span<const Vec2> step, double tolerance);
  void set(std::size_t row, State state) { states_[row] = state; }
  /// Returns the largest predicted force of the rows without an upper limit, as begin() found it, N.
  double max_predicted_force() const { return max_predicted_force_; }

 private:
  std::vector<State> states_;
  double max_predicted_force_ = 0.0;  // N
  double max_force_ = 0.0;            // N, of all rows
};

}  // namespace ribbon
