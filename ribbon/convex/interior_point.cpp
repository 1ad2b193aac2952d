#include "ribbon/convex/interior_point.h"

#include <algorithm>
#include <cmath>

namespace ribbon {
namespace {

constexpr double boundary_fraction = 0.995;  // of the way to the boundary, the most that a step goes

}  // namespace

/// Forces and multipliers start well inside, with a tenth of the largest force and length.
void InteriorPoint::begin(std::span<const LimitedRow> rows, double max_force) {
  points_.assign(rows.size(), Point{});
  double forces = 0.0;
  double lengths = 0.0;
  const bool has_contacts =
      !std::all_of(rows.begin(), rows.end(), [](const LimitedRow& row) { return row.has_high(); });
  for (const LimitedRow& row : rows) {
    if (has_contacts && row.has_high()) continue;
    forces = std::max(forces, has_contacts ? row.force : row.high);
    lengths = std::max(lengths, std::abs(row.value));
  }
  if (max_force > 0.0) forces = std::min(forces, max_force);
  const double force = forces > 0.0 ? 0.1 * forces : 1.0;
  const double length = lengths > 0.0 ? 0.1 * lengths : 1.0;
  length_per_force_ = length / force;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LimitedRow& row = rows[k];
    Point& point = points_[k];
    const double width = row.high - row.low;
    const double margin = std::min(force, 0.25 * width);
    point.force = std::clamp(std::min(row.force, 10.0 * force), row.low + margin, row.high - margin);
    const double z = row.value + point.force * row.compliance;
    point.low = std::max(0.0, z) + length;
    point.high = row.has_high() ? std::max(0.0, -z) + length : 0.0;
  }
  residual_ = 1.0;
  gap_ = 1.0;
  centring_ = 0.0;
  first_mu_ = complementarity(rows, 0.0);
}

/// A row without its multipliers is a spring of the compliance D = compliance + p/(f − low) + q/(high − f).
double InteriorPoint::stiffness(const LimitedRow& row, const Point& point) {
  double compliance = row.compliance + point.low / (point.force - row.low);
  if (row.has_high()) compliance += point.high / (row.high - point.force);
  return 1.0 / compliance;
}

void InteriorPoint::load_matrix(std::span<const LimitedRow> rows, BlockLdlt& matrix) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    matrix.add_outer(stiffness(rows[k], points_[k]), rows[k].row.slots(), rows[k].row.derivatives());
  }
}

/// With E = D − compliance, A = (σμ − Δf·Δp)/(f − low) and B = (σμ + Δf·Δq)/(high − f), the products those of the
/// predictor: f⁺ = (E·f + A − B − z − J·δ)/D.
void InteriorPoint::load_force(std::span<const LimitedRow> rows, std::span<Vec2> right_side) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LimitedRow& row = rows[k];
    const Point& point = points_[k];
    const double d = stiffness(row, point);
    double load = (1.0 / d - row.compliance) * point.force - row.value;
    load += (centring_ - point.low_product) / (point.force - row.low);
    if (row.has_high()) load -= (centring_ + point.high_product) / (row.high - point.force);
    row.row.push(d * load, right_side);
  }
}

/// Sets the next forces and multipliers, see load_force.
void InteriorPoint::solve_rows(std::span<const LimitedRow> rows, std::span<const Vec2> step) {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const LimitedRow& row = rows[k];
    Point& point = points_[k];
    const double d = stiffness(row, point);
    const double below = 1.0 / (point.force - row.low);
    const double a = (centring_ - point.low_product) * below;
    const double above = row.has_high() ? 1.0 / (row.high - point.force) : 0.0;
    const double b = (centring_ + point.high_product) * above;
    const double next = d * ((1.0 / d - row.compliance) * point.force + a - (row.has_high() ? b : 0.0) - row.value -
                             row.row.along(step));
    point.next_force = next;
    point.next_low = a - point.low * (next - point.force) * below;
    point.next_high = row.has_high() ? b + point.high * (next - point.force) * above : 0.0;
  }
}

/// The largest fraction of the way to the next forces and multipliers on which all stay inside; at most 1.
double InteriorPoint::max_fraction(std::span<const LimitedRow> rows) const {
  double fraction = 1.0;
  const auto limit = [&fraction](double distance, double change) {
    if (change < 0.0) fraction = std::min(fraction, -boundary_fraction * distance / change);
  };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Point& point = points_[k];
    const double change = point.next_force - point.force;
    limit(point.force - rows[k].low, change);
    limit(point.low, point.next_low - point.low);
    if (!rows[k].has_high()) continue;
    limit(rows[k].high - point.force, -change);
    limit(point.high, point.next_high - point.high);
  }
  return fraction;
}

/// The mean μ after this fraction of the way, N·m.
double InteriorPoint::complementarity(std::span<const LimitedRow> rows, double fraction) const {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Point& point = points_[k];
    const double force = point.force + fraction * (point.next_force - point.force);
    sum += (force - rows[k].low) * (point.low + fraction * (point.next_low - point.low));
    count += 1.0;
    if (!rows[k].has_high()) continue;
    sum += (rows[k].high - force) * (point.high + fraction * (point.next_high - point.high));
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

/// σ = (μ_predicted/μ)³.
void InteriorPoint::predict(std::span<const LimitedRow> rows, std::span<const Vec2> step) {
  solve_rows(rows, step);
  const double now = complementarity(rows, 0.0);
  const double predicted = complementarity(rows, max_fraction(rows));
  const double ratio = now > 0.0 ? std::min(1.0, predicted / now) : 0.0;
  for (Point& point : points_) {
    const double change = point.next_force - point.force;
    point.low_product = change * (point.next_low - point.low);
    point.high_product = change * (point.next_high - point.high);
  }
  centring_ = ratio * ratio * ratio * now;
}

void InteriorPoint::advance(std::span<LimitedRow> rows, std::span<const Vec2> step) {
  solve_rows(rows, step);
  const double fraction = max_fraction(rows);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Point& point = points_[k];
    point.force += fraction * (point.next_force - point.force);
    point.low += fraction * (point.next_low - point.low);
    point.high += fraction * (point.next_high - point.high);
    point.next_force = point.force;
    point.next_low = point.low;
    point.next_high = point.high;
    point.low_product = point.high_product = 0.0;
    rows[k].force = point.force;
  }
  centring_ = 0.0;
  residual_ *= 1.0 - fraction;
  gap_ = std::max(residual_, first_mu_ > 0.0 ? complementarity(rows, 0.0) / first_mu_ : 0.0);
}

void InteriorPoint::end(std::span<LimitedRow> rows, ActiveSet& active_set) const {
  for (std::size_t k = 0; k < rows.size(); ++k) {
    LimitedRow& row = rows[k];
    const Point& point = points_[k];
    ActiveSet::State state = ActiveSet::State::spring;
    if (point.low > length_per_force_ * (point.force - row.low)) state = ActiveSet::State::low;
    if (row.has_high() && point.high > length_per_force_ * (row.high - point.force)) state = ActiveSet::State::high;
    if (state != ActiveSet::State::spring) row.force = state == ActiveSet::State::low ? row.low : row.high;
    active_set.set(k, state);
  }
}

}  // namespace ribbon
