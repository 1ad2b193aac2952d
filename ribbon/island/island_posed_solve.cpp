#include <algorithm>

#include "ribbon/island/island.h"

// The solve of the convex problem that posed contacts make of a linearisation.

namespace ribbon {
namespace {

constexpr double tied_share = 1e-3;     // of the tolerance, by which a row may be on the wrong side of its limit
constexpr int active_sets = 5;          // tried before the interior point,
constexpr int few_rows = 2;             // unless more than so many change, and not less each time
constexpr int most_interior = 25;       // its iterations
constexpr double polishing_gap = 1e-4;  // of the interior point, from where on its active set is tried
constexpr double closed_gap = 1e-10;    // at which it has ended
constexpr double far_gap = 1e-2;        // and at which it is good enough far from where the linearisations end

}  // namespace

/// The step of the convex problem about positions_, and the tensions after it. One that is `far` from where the
/// linearisations end need not be exact.
Island::Solve Island::solve_posed(Stage& stage, bool far, CordReport& report) {
  slips_ = false;
  if (!has_pattern_ || !limited_.are_coupled(blocks_)) make_pattern();
  has_pattern_ = true;
  active_set_.begin(limited_.rows());
  Solve solve = solve_active_sets(stage, active_sets, report) ? Solve::exact : Solve::failed;
  if (solve == Solve::failed) solve = solve_interior(stage, far, report);
  if (solve == Solve::failed) return solve;
  take_direction();
  if (!std::all_of(direction_.begin(), direction_.end(), [](Vec2 v) { return is_finite(v); })) return Solve::failed;
  update_together(stage);
  return solve;
}

/// As long as they get better, each by half. False if none of them was the solution's.
bool Island::solve_active_sets(Stage& stage, int most, CordReport& report) {
  int before = static_cast<int>(limited_.rows().size()) + 1;
  for (int k = 0; k < most; ++k) {
    count_system(report);
    load_together(stage);
    active_set_.load(limited_.rows(), blocks_, right_side_);
    if (!solve_together()) return false;
    const int changed = active_set_.update(limited_.rows(), right_side_, tied_share * tolerance_);
    if (changed == 0) return true;
    if (2 * changed > before && changed > few_rows) return false;
    before = changed;
  }
  return false;
}

/// Predictor and corrector by one factorisation each time, and the active set that they lead to in the end.
Island::Solve Island::solve_interior(Stage& stage, bool far, CordReport& report) {
  interior_point_.begin(limited_.rows(), active_set_.max_predicted_force());
  double polished = polishing_gap;
  for (int k = 0; k < most_interior; ++k) {
    count_system(report);
    load_together(stage);
    load_ = right_side_;
    for (std::size_t p = 0; p < positions_.size(); ++p) {
      if (constrained_[p] != 0) load_[p] = {};
    }
    interior_point_.load_matrix(limited_.rows(), blocks_);
    interior_point_.load_force(limited_.rows(), right_side_);
    if (!solve_together()) return Solve::failed;
    interior_point_.predict(limited_.rows(), right_side_);
    right_side_ = load_;
    interior_point_.load_force(limited_.rows(), right_side_);
    for (std::size_t p = 0; p < positions_.size(); ++p) {
      if (constrained_[p] != 0) right_side_[p] = {};
    }
    blocks_.solve_again(right_side_);
    interior_point_.advance(limited_.rows(), right_side_);
    if ((far && interior_point_.gap() <= far_gap) || is_posed_out(report)) {
      interior_point_.end(limited_.rows(), active_set_);
      return Solve::near;
    }
    if (interior_point_.gap() > polished) continue;
    if (interior_point_.gap() <= closed_gap) return Solve::exact;
    load_ = right_side_;
    interior_point_.end(limited_.rows(), active_set_);
    if (solve_active_sets(stage, active_sets, report)) return Solve::exact;
    polished *= 1e-2;
    right_side_ = load_;
  }
  return Solve::exact;
}

}  // namespace ribbon
