#include "ribbon/contact/limited_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ribbon {
namespace {

constexpr double tied_share = 1e-4;       // of the greatest force, by which one may be on the wrong side of its limit
constexpr double boundary_share = 0.995;  // of the way to the boundary, that a step of the interior point goes

}  // namespace

void LimitedRows::reserve(std::size_t count) {
  rows_.reserve(count);
  states_.reserve(count);
  inside_.reserve(count);
}

void LimitedRows::couple(BlockLdlt& matrix) const {
  for (const LimitedRow& limited : rows_) {
    const auto slots = limited.row.slots();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      for (std::size_t j = i + 1; j < slots.size(); ++j) matrix.couple(slots[i], slots[j]);
    }
  }
}

bool LimitedRows::are_coupled(const BlockLdlt& matrix) const {
  for (const LimitedRow& limited : rows_) {
    const auto slots = limited.row.slots();
    for (std::size_t i = 0; i < slots.size(); ++i) {
      for (std::size_t j = i + 1; j < slots.size(); ++j) {
        if (!matrix.is_coupled(slots[i], slots[j])) return false;
      }
    }
  }
  return true;
}

/// φ(z) = −f·z − ½·compliance·f², f the force at z: its slope is −f.
double LimitedRows::potential(std::span<const Vec2> step, double share) const {
  double sum = 0.0;
  for (const LimitedRow& row : rows_) {
    const double z = row.value + share * row.row.along(step);
    const double force = std::clamp(-z / row.compliance, row.low, row.high);
    sum -= force * (z + 0.5 * row.compliance * force);
  }
  return sum;
}

void LimitedRows::begin_active_set() {
  states_.resize(rows_.size());
  most_force_ = 0.0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const LimitedRow& row = rows_[k];
    const double force = row.force;
    states_[k] = force <= row.low ? State::low : force >= row.high ? State::high : State::spring;
    if (states_[k] == State::low && -row.value > row.low * row.compliance) states_[k] = State::spring;
    most_force_ = std::max(most_force_, std::abs(force));
  }
  known_force_ = 0.0;
  for (const LimitedRow& row : rows_) {
    if (!has_high(row)) known_force_ = std::max(known_force_, row.force);
  }
}

void LimitedRows::load_active_set(BlockLdlt& matrix, std::span<Vec2> right_side) const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const LimitedRow& row = rows_[k];
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

int LimitedRows::update_active_set(std::span<const Vec2> step, double tolerance) {
  int changed = 0;
  double most = 0.0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    LimitedRow& row = rows_[k];
    const double spring = -(row.value + row.row.along(step)) / row.compliance;
    row.force = std::clamp(spring, row.low, row.high);
    if (states_[k] != State::spring) row.force = states_[k] == State::low ? row.low : row.high;
    most = std::max(most, std::abs(row.force));
    const State state = spring < row.low ? State::low : spring > row.high ? State::high : State::spring;
    if (state == states_[k]) continue;
    const double limit = state == State::low || states_[k] == State::low ? row.low : row.high;
    const double off = std::abs(spring - limit);
    if (off <= tied_share * most_force_ || off * row.compliance <= tolerance) continue;
    states_[k] = state;
    ++changed;
  }
  most_force_ = most;
  return changed;
}

bool LimitedRows::has_high(const LimitedRow& row) { return row.high < std::numeric_limits<double>::infinity(); }

/// Forces and multipliers well inside, as large as those that the last active set found, but no larger than those that
/// there were before any was tried: one that is not the solution's may find forces beyond all measure, from which the
/// interior point comes back slowly.
void LimitedRows::begin_interior() {
  inside_.assign(rows_.size(), Inside{});
  double forces = 0.0;
  double lengths = 0.0;
  const bool presses = !std::all_of(rows_.begin(), rows_.end(), has_high);
  for (const LimitedRow& row : rows_) {
    if (presses && has_high(row)) continue;
    forces = std::max(forces, presses ? row.force : row.high);
    lengths = std::max(lengths, std::abs(row.value));
  }
  if (known_force_ > 0.0) forces = std::min(forces, known_force_);
  const double force = forces > 0.0 ? 0.1 * forces : 1.0;
  const double length = lengths > 0.0 ? 0.1 * lengths : 1.0;
  length_per_force_ = length / force;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const LimitedRow& row = rows_[k];
    Inside& inside = inside_[k];
    const double width = row.high - row.low;
    const double margin = std::min(force, 0.25 * width);
    inside.force = std::clamp(std::min(row.force, 10.0 * force), row.low + margin, row.high - margin);
    const double z = row.value + inside.force * row.compliance;
    inside.low = std::max(0.0, z) + length;
    inside.high = has_high(row) ? std::max(0.0, -z) + length : 0.0;
  }
  misfit_ = 1.0;
  gap_ = 1.0;
  centring_ = 0.0;
  first_mu_ = complementarity(0.0);
}

/// D = compliance + p/(f − low) + q/(high − f): what is left of a row once its multipliers are eliminated is a spring
/// of that compliance.
double LimitedRows::stiffness(std::size_t k) const {
  const LimitedRow& row = rows_[k];
  const Inside& inside = inside_[k];
  double compliance = row.compliance + inside.low / (inside.force - row.low);
  if (has_high(row)) compliance += inside.high / (row.high - inside.force);
  return 1.0 / compliance;
}

void LimitedRows::load_interior(BlockLdlt& matrix) const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    matrix.add_outer(stiffness(k), rows_[k].row.slots(), rows_[k].row.derivatives());
  }
}

/// With E = D − compliance, A = (σμ − Δf·Δp)/(f − low) and B = (σμ + Δf·Δq)/(high − f), the products those of the
/// predictor: f⁺ = (E·f + A − B − z − J·δ)/D.
void LimitedRows::load_interior_force(std::span<Vec2> right_side) const {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const LimitedRow& row = rows_[k];
    const Inside& inside = inside_[k];
    const double d = stiffness(k);
    double load = (1.0 / d - row.compliance) * inside.force - row.value;
    load += (centring_ - inside.low_product) / (inside.force - row.low);
    if (has_high(row)) load -= (centring_ + inside.high_product) / (row.high - inside.force);
    row.row.push(d * load, right_side);
  }
}

/// Forces and multipliers by a linear solve.
void LimitedRows::take_next(std::span<const Vec2> step) {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const LimitedRow& row = rows_[k];
    Inside& inside = inside_[k];
    const double d = stiffness(k);
    const double below = 1.0 / (inside.force - row.low);
    const double a = (centring_ - inside.low_product) * below;
    const double above = has_high(row) ? 1.0 / (row.high - inside.force) : 0.0;
    const double b = (centring_ + inside.high_product) * above;
    const double next = d * ((1.0 / d - row.compliance) * inside.force + a - (has_high(row) ? b : 0.0) - row.value -
                             row.row.along(step));
    inside.next_force = next;
    inside.next_low = a - inside.low * (next - inside.force) * below;
    inside.next_high = has_high(row) ? b + inside.high * (next - inside.force) * above : 0.0;
  }
}

/// Of the way to the next forces and multipliers, on which all stay inside; at most 1.
double LimitedRows::longest_share() const {
  double share = 1.0;
  const auto keep = [&share](double room, double change) {
    if (change < 0.0) share = std::min(share, -boundary_share * room / change);
  };
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Inside& inside = inside_[k];
    const double change = inside.next_force - inside.force;
    keep(inside.force - rows_[k].low, change);
    keep(inside.low, inside.next_low - inside.low);
    if (!has_high(rows_[k])) continue;
    keep(rows_[k].high - inside.force, -change);
    keep(inside.high, inside.next_high - inside.high);
  }
  return share;
}

/// μ after a share of the way, N·m.
double LimitedRows::complementarity(double share) const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Inside& inside = inside_[k];
    const double force = inside.force + share * (inside.next_force - inside.force);
    sum += (force - rows_[k].low) * (inside.low + share * (inside.next_low - inside.low));
    count += 1.0;
    if (!has_high(rows_[k])) continue;
    sum += (rows_[k].high - force) * (inside.high + share * (inside.next_high - inside.high));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void LimitedRows::predict(std::span<const Vec2> step) {
  take_next(step);
  const double now = complementarity(0.0);
  const double then = complementarity(longest_share());
  const double ratio = now > 0.0 ? std::min(1.0, then / now) : 0.0;
  for (Inside& inside : inside_) {
    const double change = inside.next_force - inside.force;
    inside.low_product = change * (inside.next_low - inside.low);
    inside.high_product = change * (inside.next_high - inside.high);
  }
  centring_ = ratio * ratio * ratio * now;
}

void LimitedRows::advance(std::span<const Vec2> step) {
  take_next(step);
  const double share = longest_share();
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    Inside& inside = inside_[k];
    inside.force += share * (inside.next_force - inside.force);
    inside.low += share * (inside.next_low - inside.low);
    inside.high += share * (inside.next_high - inside.high);
    inside.next_force = inside.force;
    inside.next_low = inside.low;
    inside.next_high = inside.high;
    inside.low_product = inside.high_product = 0.0;
    rows_[k].force = inside.force;
  }
  centring_ = 0.0;
  misfit_ *= 1.0 - share;
  gap_ = std::max(misfit_, first_mu_ > 0.0 ? complementarity(0.0) / first_mu_ : 0.0);
}

/// A row is at a limit whose multiplier outweighs the force that is left to it, each in units of what it began with.
void LimitedRows::end_interior() {
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    LimitedRow& row = rows_[k];
    const Inside& inside = inside_[k];
    states_[k] = State::spring;
    if (inside.low > length_per_force_ * (inside.force - row.low)) states_[k] = State::low;
    if (has_high(row) && inside.high > length_per_force_ * (row.high - inside.force)) states_[k] = State::high;
    if (states_[k] != State::spring) row.force = states_[k] == State::low ? row.low : row.high;
  }
}

}  // namespace ribbon
