#pragma once

#include <vector>

#include "ribbon/convex/active_set.h"
#include "ribbon/convex/interior_point.h"
#include "ribbon/convex/limited_rows.h"
#include "ribbon/stage/newton_solver.h"

namespace ribbon {

/// Solves the convex problem that a linearisation with limited rows is: by active sets, and by an interior point where
/// these do not lead to the solution. It ends in bounded work.
class ConvexSolver {
 public:
  enum class Result { failed, near, exact };
  /// What a solve begins with, and what ends it.
  enum class Method { active_sets, interior_point };

  LimitedRows& rows() { return rows_; }
  const LimitedRows& rows() const { return rows_; }
  void reserve(std::size_t rows, std::size_t right_side);
  /// Finds the step of the problem about the current positions, and the tensions after it. With `far` from where the
  /// linearisations end, it need not be exact.
  Result solve(const StageContext& context, const Stage& stage, bool far, Method first);
  /// Returns what ended the last solve that was not truncated.
  Method last_method() const { return last_method_; }
  /// Finds the step by a few active sets, whether the last of them is that of the solution or not. Returns false if the
  /// matrix is not definite or the step not finite.
  bool solve_truncated(const StageContext& context, const Stage& stage);

 private:
  int solve_active_set(const StageContext& context, const Stage& stage);
  bool solve_active_sets(const StageContext& context, const Stage& stage);
  Result solve_interior(const StageContext& context, const Stage& stage, bool far);
  bool advance_interior(const StageContext& context, const Stage& stage);

  LimitedRows rows_;
  ActiveSet active_set_;
  InteriorPoint interior_point_;
  Method last_method_ = Method::active_sets;
  std::vector<Vec2> load_;  // the right-hand side without the rows, or a solution
};

}  // namespace ribbon
