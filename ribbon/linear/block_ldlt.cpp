#include "ribbon/linear/block_ldlt.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

namespace ribbon {

inline void BlockLdlt::Block::operator+=(Block b) {
  xx += b.xx;
  xy += b.xy;
  yx += b.yx;
  yy += b.yy;
}

void BlockLdlt::end_pattern() {
  pattern_.end();
  resize_blocks();
}

void BlockLdlt::reorder(std::span<const int> order) {
  pattern_.reorder(order);
  resize_blocks();
}

bool BlockLdlt::is_coupled(int a, int b) const {
  const int row_a = pattern_.row_of(a);
  const int row_b = pattern_.row_of(b);
  return row_a == row_b || pattern_.find(std::min(row_a, row_b), std::max(row_a, row_b)) < pattern_.blocks();
}

void BlockLdlt::resize_blocks() {
  const std::size_t n = pattern_.size();
  blocks_.reserve(pattern_.capacity());
  blocks_.resize(pattern_.blocks());
  diagonals_.resize(n);
  held_.resize(n);
  dual_.resize(n);
  right_side_.resize(n);
}

void BlockLdlt::set_zero() {
  std::fill(blocks_.begin(), blocks_.end(), Block{});
  std::fill(diagonals_.begin(), diagonals_.end(), Diagonal{});
  std::fill(held_.begin(), held_.end(), 0);
  std::fill(dual_.begin(), dual_.end(), 0);
}

void BlockLdlt::add(int a, int b, double xx, double xy, double yx, double yy) {
  int row = pattern_.row_of(a);
  int column = pattern_.row_of(b);
  if (row == column) {
    add(a, 2.0 * xx, xy + yx, 2.0 * yy);  // of tied slots: the block and its transpose
    return;
  }
  if (row > column) {
    std::swap(row, column);
    std::swap(xy, yx);
  }
  const std::size_t place = pattern_.find(row, column);
  assert(place < pattern_.blocks());
  blocks_[place] += {xx, xy, yx, yy};
}

void BlockLdlt::add(int a, double xx, double xy, double yy) {
  Diagonal& diagonal = diagonals_[at(pattern_.row_of(a))];
  diagonal.xx += xx;
  diagonal.xy += xy;
  diagonal.yy += yy;
}

void BlockLdlt::add_outer(double factor, std::span<const int> slots, std::span<const Vec2> by) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const Vec2 g = factor * by[i];
    add(slots[i], g.x * by[i].x, g.x * by[i].y, g.y * by[i].y);
    if (g == Vec2{}) continue;
    for (std::size_t j = i + 1; j < slots.size(); ++j) {
      add(slots[i], slots[j], g.x * by[j].x, g.x * by[j].y, g.y * by[j].x, g.y * by[j].y);
    }
  }
}

void BlockLdlt::add_band(int first, const BandedMatrix& band, int reach) {
  const int n = band.size() / 2;
  for (int p = 0; p < n; ++p) {
    const double* upper = band.row(2 * p);
    const double* lower = band.row(2 * p + 1);
    add(first + p, upper[0], upper[1], lower[0]);
    const int row = pattern_.row_of(first + p);
    std::size_t place = pattern_.first(at(row));
    int before = row;
    for (int k = 1; k <= reach && p + k < n; ++k) {
      const int column = pattern_.row_of(first + p + k);
      if (column < before) {
        add(first + p, first + p + k, upper[2 * k], upper[2 * k + 1], lower[2 * k - 1], lower[2 * k]);
        continue;
      }
      before = column;
      while (pattern_.columns()[place] != column) ++place;
      blocks_[place] += {upper[2 * k], upper[2 * k + 1], lower[2 * k - 1], lower[2 * k]};
    }
  }
}

void BlockLdlt::load_right_side(std::span<const Vec2> b) {
  for (std::size_t k = 0; k < pattern_.size(); ++k) right_side_[k] = b[at(pattern_.slot_of(k))];
  for (const TiedSlot& tied : pattern_.tied()) right_side_[at(pattern_.row_of(tied.slot))] += b[at(tied.slot)];
}

bool BlockLdlt::solve(std::span<Vec2> b) {
  const std::size_t n = pattern_.size();
  load_right_side(b);
  for (std::size_t k = 0; k < n; k += pattern_.width(k)) {
    const bool done = pattern_.width(k) == 4    ? eliminate_rows<4>(k)
                      : pattern_.width(k) == 2  ? eliminate_rows<2>(k)
                      : dual_[k] == scalar_dual ? eliminate<1, 1>(k)
                                                : eliminate<1, 0>(k);
    if (!done) return false;
  }
  substitute(b);
  return true;
}

void BlockLdlt::solve_again(std::span<Vec2> b) {
  const std::size_t n = pattern_.size();
  load_right_side(b);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 r = right_side_[k];
    for (std::size_t i = pattern_.first(k); i < pattern_.first(k + 1); ++i) {
      const Block& l = blocks_[i];
      right_side_[at(pattern_.columns()[i])] -= {l.xx * r.x + l.yx * r.y, l.xy * r.x + l.yy * r.y};
    }
  }
  substitute(b);
}

/// Back substitution from the last row to the first: x = D⁻¹·r − Σ L_i·x_i.
inline void BlockLdlt::substitute(std::span<Vec2> b) {
  const std::size_t n = pattern_.size();
  for (std::size_t k = n; k-- > 0;) {
    const Diagonal& inverse = diagonals_[k];
    const Vec2 r = right_side_[k];
    Vec2 x{inverse.xx * r.x + inverse.xy * r.y, inverse.xy * r.x + inverse.yy * r.y};
    for (std::size_t i = pattern_.first(k + 1); i-- > pattern_.first(k);) {
      const Block& l = blocks_[i];
      const Vec2 later = right_side_[at(pattern_.columns()[i])];
      x -= {l.xx * later.x + l.xy * later.y, l.yx * later.x + l.yy * later.y};
    }
    right_side_[k] = x;
  }
  for (std::size_t k = 0; k < n; ++k) b[at(pattern_.slot_of(k))] = right_side_[k];
  for (const TiedSlot& tied : pattern_.tied()) b[at(tied.slot)] = b[at(tied.with)];
}

/// Inverts the diagonal block of a row. Returns false if its sign is not that of the row.
inline bool BlockLdlt::invert_pivot(std::size_t row) {
  Diagonal& d = diagonals_[row];
  if (held_[row] != 0) {
    d = {1.0, 0.0, 1.0};
    std::fill(blocks_.begin() + static_cast<std::ptrdiff_t>(pattern_.first(row)),
              blocks_.begin() + static_cast<std::ptrdiff_t>(pattern_.first(row + 1)), Block{});
    return true;
  }
  const double inverse_det = 1.0 / (d.xx * d.yy - d.xy * d.xy);
  if (!((dual_[row] != 0 ? -d.xx : d.xx) > 0.0 && inverse_det > 0.0 &&
        inverse_det < std::numeric_limits<double>::infinity()))
    return false;
  d = {inverse_det * d.yy, -inverse_det * d.xy, inverse_det * d.xx};
  return true;
}

/// Eliminates rows that follow each other and have the same columns behind them. With the diagonal block D of a row and
/// the blocks B_i right of it,
///
///     A_ij ← A_ij − B_iᵀ·D⁻¹·B_j      r_i ← r_i − B_iᵀ·D⁻¹·r
///
/// for all pairs of its columns i ≤ j; the pattern has a block for each pair. The row keeps D⁻¹ and L_i = D⁻¹·B_i. A
/// block behind all of the rows is read and written once for all of them, in their order: the bits are those of one row
/// after the other.
/// Of rows that are scalars, bits of the template argument, the second components are left out: they are 0.
template <std::size_t rows, std::size_t scalars>
inline bool BlockLdlt::eliminate(std::size_t first_row) {
  std::array<Pivot, rows> pivots;
  for (std::size_t k = 0; k < rows; ++k) {
    const std::size_t row = first_row + k;
    if (!invert_pivot(row)) return false;
    pivots[k] = {diagonals_[row], right_side_[row], blocks_.data() + pattern_.first(row)};
    const int* const columns = pattern_.columns() + pattern_.first(row);
    const std::size_t count = pattern_.first(row + 1) - pattern_.first(row);
    for (std::size_t i = 0; i + 1 + k < rows; ++i) {
      if (((scalars >> k) & 1U) != 0) {
        subtract_rows<1, 1>(&pivots[k], columns + i, count - i);
      } else {
        subtract_rows<1, 0>(&pivots[k], columns + i, count - i);
      }
    }
  }
  const std::size_t last = first_row + rows - 1;
  const int* const end = pattern_.columns() + pattern_.first(last + 1);
  for (const int* column = pattern_.columns() + pattern_.first(last); column != end; ++column) {
    subtract_rows<rows, scalars>(pivots.data(), column, static_cast<std::size_t>(end - column));
  }
  return true;
}

/// Eliminates rows from this one on, with the function for their scalars.
template <std::size_t rows>
bool BlockLdlt::eliminate_rows(std::size_t first_row) {
  using Eliminate = bool (BlockLdlt::*)(std::size_t);
  static constexpr auto functions = []<std::size_t... scalars>(std::index_sequence<scalars...>) {
    return std::array<Eliminate, sizeof...(scalars)>{&BlockLdlt::eliminate<rows, scalars>...};
  }
  (std::make_index_sequence<std::size_t{1} << rows>{});
  std::size_t scalars = 0;
  for (std::size_t k = 0; k < rows; ++k) {
    if (dual_[first_row + k] == scalar_dual) scalars |= std::size_t{1} << k;
  }
  return (this->*functions[scalars])(first_row);
}

/// Eliminates the next block of each pivot, which is in the column of `target`: it becomes a block of L, and is
/// subtracted from the diagonal and the right side of the target.
template <std::size_t rows>
[[gnu::always_inline]] inline BlockLdlt::Factors<rows> BlockLdlt::eliminate_column(Pivot* pivots, std::size_t target) {
  Factors<rows> factors;
  Diagonal& diagonal = diagonals_[target];
  for (std::size_t k = 0; k < rows; ++k) {
    const Diagonal inverse = pivots[k].inverse;
    const Vec2 r = pivots[k].right_side;
    Block& block = *pivots[k].block++;
    const Pair b_x = load_pair(&block.xx);
    const Pair b_y = load_pair(&block.yx);
    const Pair l_x = inverse.xx * b_x + inverse.xy * b_y;
    const Pair l_y = inverse.xy * b_x + inverse.yy * b_y;
    store_pair(l_x, &block.xx);
    store_pair(l_y, &block.yx);
    subtract_pair(l_x * r.x + l_y * r.y, &right_side_[target].x);
    subtract_pair(l_x[0] * b_x + l_y[0] * b_y, &diagonal.xx);
    diagonal.yy -= (l_x * b_x + l_y * b_y)[1];
    factors.l[k] = {l_x, l_y};
    factors.later[k] = pivots[k].block;
  }
  return factors;
}

/// Subtracts Lᵀ·B_j of each pivot from a block of the target's row, B_j being the pivot's block number j from its next
/// one on.
template <std::size_t rows, std::size_t scalars>
[[gnu::always_inline]] inline void BlockLdlt::subtract_products(const Factors<rows>& factors, std::size_t j,
                                                                Block& block) {
  const auto& [l, later] = factors;
  Pair x = load_pair(&block.xx);
  Pair y = load_pair(&block.yx);
  for (std::size_t k = 0; k < rows; ++k) {
    const Pair c_x = load_pair(&later[k][j].xx);
    if (((scalars >> k) & 1U) != 0) {
      x = x - l[k][0][0] * c_x;
      y = y - l[k][0][1] * c_x;
      continue;
    }
    const Pair c_y = load_pair(&later[k][j].yx);
    x = x - (l[k][0][0] * c_x + l[k][1][0] * c_y);
    y = y - (l[k][0][1] * c_x + l[k][1][1] * c_y);
  }
  store_pair(x, &block.xx);
  store_pair(y, &block.yx);
}

/// Subtracts what pivots contribute to the row of the first of `count` columns, and moves them on to their next blocks.
template <std::size_t rows, std::size_t scalars>
[[gnu::always_inline]] inline void BlockLdlt::subtract_rows(Pivot* pivots, const int* columns, std::size_t count) {
  const std::size_t target = at(columns[0]);
  if (held_[target] != 0) {
    for (std::size_t k = 0; k < rows; ++k) *pivots[k].block++ = {};
    return;
  }
  const Factors<rows> factors = eliminate_column<rows>(pivots, target);
  const std::size_t first = pattern_.first(target);
  Block* block = blocks_.data() + first;
  if (rows > 1 && pattern_.first(target + 1) - first == count - 1) {  // the target has no other columns than these
    for (std::size_t j = 0; j + 1 < count; ++j) subtract_products<rows, scalars>(factors, j, *block++);
    return;
  }
  const int* column = pattern_.columns() + first;
  for (std::size_t j = 0; j + 1 < count; ++j) {
    while (*column != columns[j + 1]) ++column, ++block;
    subtract_products<rows, scalars>(factors, j, *block);
  }
}

}  // namespace ribbon
