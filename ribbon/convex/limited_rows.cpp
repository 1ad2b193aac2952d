#include "ribbon/convex/limited_rows.h"

#include <algorithm>

namespace ribbon {

void LimitedRows::couple(BlockLdlt& matrix) const {
  for (const LimitedRow& limited : rows_) limited.row.couple(matrix);
}

bool LimitedRows::are_coupled(const BlockLdlt& matrix) const {
  return std::all_of(rows_.begin(), rows_.end(),
                     [&matrix](const LimitedRow& limited) { return limited.row.is_coupled(matrix); });
}

/// φ(z) = −f·z − ½·compliance·f², with f the force at z: its slope is −f.
double LimitedRows::potential(std::span<const Vec2> step, double fraction) const {
  double sum = 0.0;
  for (const LimitedRow& row : rows_) {
    if (row.is_bar()) continue;
    const double z = row.value + fraction * row.row.along(step);
    const double force = std::clamp(-z / row.compliance, row.low, row.high);
    sum -= force * (z + 0.5 * row.compliance * force);
  }
  return sum;
}

}  // namespace ribbon
