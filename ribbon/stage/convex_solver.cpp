#include "ribbon/stage/convex_solver.h"

#include "ribbon/linear/index.h"

namespace ribbon {
namespace {

constexpr double tied_share = 1e-3;       // of the tolerance, by which a row may be on the wrong side of its limit
constexpr int max_active_sets = 5;        // tried before the interior point,
constexpr int few_rows = 2;               // unless more rows than that change, and not fewer each time
constexpr int truncated_sets = 2;         // of a truncated solve,
constexpr std::size_t settled_rows = 50;  // in so many of which no more than one changes after the first
constexpr int max_interior = 25;          // iterations of the interior point
constexpr double polishing_gap = 1e-4;    // of the interior point, below which its active set is tried
constexpr double closed_gap = 1e-10;      // at which it ends
constexpr double far_gap = 1e-2;          // at which it is good enough far from where the linearisations end

}  // namespace

void ConvexSolver::reserve(std::size_t rows, std::size_t right_side) {
  rows_.reserve(rows);
  active_set_.reserve(rows);
  interior_point_.reserve(rows);
  load_.reserve(right_side);
}

ConvexSolver::Result ConvexSolver::solve(const StageContext& context, const Stage& stage, bool far, Method first) {
  context.newton.system().make_pattern(context.state, rows_);
  active_set_.begin(rows_.rows());
  Result result = Result::exact;
  last_method_ = Method::active_sets;
  if (first == Method::interior_point || !solve_active_sets(context, stage)) {
    last_method_ = Method::interior_point;
    result = solve_interior(context, stage, far);
  }
  if (result == Result::failed) return result;
  return context.newton.take_solution(context.state, stage) ? result : Result::failed;
}

bool ConvexSolver::solve_truncated(const StageContext& context, const Stage& stage) {
  context.newton.system().make_pattern(context.state, rows_);
  active_set_.begin(rows_.rows());
  for (int k = 0; k < truncated_sets; ++k) {
    const int changed = solve_active_set(context, stage);
    if (changed < 0) return false;
    if (settled_rows * at(changed) <= rows_.rows().size()) break;
  }
  return context.newton.take_solution(context.state, stage);
}

/// Returns the number of rows that change their state, −1 if the matrix is not definite.
int ConvexSolver::solve_active_set(const StageContext& context, const Stage& stage) {
  BlockSystem& system = context.newton.system();
  context.count_system();
  system.load(context.state, stage);
  active_set_.load(rows_.rows(), system.matrix(), system.right_side());
  if (!system.solve(context.state)) return -1;
  return active_set_.update(rows_.rows(), system.right_side(), tied_share * context.state.tolerance);
}

/// Goes on as long as the sets get better, each by half. Returns false if none of them was that of the solution.
bool ConvexSolver::solve_active_sets(const StageContext& context, const Stage& stage) {
  int before = static_cast<int>(rows_.rows().size()) + 1;
  for (int k = 0; k < max_active_sets; ++k) {
    const int changed = solve_active_set(context, stage);
    if (changed <= 0) return changed == 0;
    if (2 * changed > before && changed > few_rows) return false;
    before = changed;
  }
  return false;
}

ConvexSolver::Result ConvexSolver::solve_interior(const StageContext& context, const Stage& stage, bool far) {
  std::vector<Vec2>& right_side = context.newton.system().right_side();
  interior_point_.begin(rows_.rows(), active_set_.max_predicted_force());
  double polished = polishing_gap;
  for (int k = 0; k < max_interior; ++k) {
    if (!advance_interior(context, stage)) return Result::failed;
    if ((far && interior_point_.gap() <= far_gap) || context.work.linearising_is_over()) {
      interior_point_.end(rows_.rows(), active_set_);
      return Result::near;
    }
    if (interior_point_.gap() > polished) continue;
    interior_point_.end(rows_.rows(), active_set_);
    if (interior_point_.gap() <= closed_gap) return Result::exact;
    load_ = right_side;
    if (solve_active_sets(context, stage)) return Result::exact;
    polished *= 1e-2;
    right_side = load_;
  }
  interior_point_.end(rows_.rows(), active_set_);
  return Result::near;
}

/// One iteration: a predictor and a corrector with the same factorisation.
bool ConvexSolver::advance_interior(const StageContext& context, const Stage& stage) {
  BlockSystem& system = context.newton.system();
  std::vector<Vec2>& right_side = system.right_side();
  context.count_system();
  system.load(context.state, stage);
  load_ = right_side;
  interior_point_.load_matrix(rows_.rows(), system.matrix());
  interior_point_.load_force(rows_.rows(), right_side);
  if (!system.solve(context.state)) return false;
  interior_point_.predict(rows_.rows(), right_side);
  right_side = load_;
  interior_point_.load_force(rows_.rows(), right_side);
  system.solve_again(context.state);
  interior_point_.advance(rows_.rows(), right_side);
  return true;
}

}  // namespace ribbon
