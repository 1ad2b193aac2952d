#include "ribbon/convex/active_set.h"

#include <algorithm>
#include <cmath>

namespace ribbon {
namespace {

constexpr double force_tolerance = 1e-4;  // of the largest force, by which a force may be beyond its limit

}  // namespace

void ActiveSet::begin(std::span<const LimitedRow> rows) {
  states_.resize(rows.size());
  max_force_ = 0.0;
  max_predicted_force_ = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LimitedRow& row = rows[k];
    const double force = row.force;
    states_[k] = force <= row.low ? State::low : force >= row.high ? State::high : State::spring;
    if (states_[k] == State::low && -row.value > row.low * row.compliance) states_[k] = State::spring;
    max_force_ = std::max(max_force_, std::abs(force));
    if (!row.has_high()) max_predicted_force_ = std::max(max_predicted_force_, force);
  }
}

void ActiveSet::load(std::span<const LimitedRow> rows, BlockLdlt& matrix, std::span<Vec2> right_side) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LimitedRow& row = rows[k];
    switch (states_[k]) {
      case State::low: row.row.push(row.low, right_side); break;
      case State::high: row.row.push(row.high, right_side); break;
      case State::spring:
        row.row.push(-row.value / row.compliance, right_side);
        matrix.add_outer(1.0 / row.compliance, row.row.slots(), row.row.derivatives());
        break;
    }
  }
}

int ActiveSet::update(std::span<LimitedRow> rows, std::span<const Vec2> step, double tolerance) {
  int changed = 0;
  double max_force = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    LimitedRow& row = rows[k];
    const double spring = -(row.value + row.row.along(step)) / row.compliance;
    row.force = std::clamp(spring, row.low, row.high);
    if (states_[k] != State::spring) row.force = states_[k] == State::low ? row.low : row.high;
    max_force = std::max(max_force, std::abs(row.force));
    const State state = spring < row.low ? State::low : spring > row.high ? State::high : State::spring;
    if (state == states_[k]) continue;
    const double limit = state == State::low || states_[k] == State::low ? row.low : row.high;
    const double error = std::abs(spring - limit);
    // A stiff contact may pull by as much as it may be deep. A bar that pushes moves its points.
    const double moved = error * (row.is_bar() && spring < row.low ? row.point_compliance : row.compliance);
    if (error <= force_tolerance * max_force_ || moved <= tolerance) continue;
    states_[k] = state;
    ++changed;
  }
  max_force_ = max_force;
  return changed;
}

}  // namespace ribbon
