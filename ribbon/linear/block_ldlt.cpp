#include "ribbon/linear/block_ldlt.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "ribbon/linear/pair.h"

namespace ribbon {
namespace {

constexpr std::ptrdiff_t max_linear_search = 8;  // columns; a binary search is faster above
constexpr std::size_t min_shared = 4;            // columns, from which on rows are eliminated together

}  // namespace

inline void BlockLdlt::Block::operator+=(Block b) {
  xx += b.xx;
  xy += b.xy;
  yx += b.yx;
  yy += b.yy;
}

void BlockLdlt::begin_pattern(std::span<const int> order, std::span<const TiedSlot> tied) {
  tied_.assign(tied.begin(), tied.end());
  row_of_.resize(order.size() + tied.size());
  assign_rows(order);
  couplings_.clear();
}

void BlockLdlt::assign_rows(std::span<const int> order) {
  order_.assign(order.begin(), order.end());
  for (std::size_t row = 0; row < order.size(); ++row) row_of_[at(order[row])] = static_cast<int>(row);
  for (const TiedSlot& tied : tied_) row_of_[at(tied.slot)] = row_of_[at(tied.with)];
}

void BlockLdlt::couple(int a, int b) {
  const int row_a = row_of_[at(a)];
  const int row_b = row_of_[at(b)];
  if (row_a == row_b) return;
  couplings_.push_back({std::min(row_a, row_b), std::max(row_a, row_b)});
}

void BlockLdlt::reorder(std::span<const int> order) {
  for (auto& coupling : couplings_) coupling = {order_[at(coupling[0])], order_[at(coupling[1])]};
  assign_rows(order);
  for (auto& coupling : couplings_) {
    const int a = row_of_[at(coupling[0])];
    const int b = row_of_[at(coupling[1])];
    coupling = {std::min(a, b), std::max(a, b)};
  }
  end_pattern();
}

void BlockLdlt::end_pattern() {
  sort_couplings();
  find_columns();
  find_widths();
  resize_blocks();
}

/// Sorts the couplings by row: a counting sort in O(rows + couplings).
void BlockLdlt::sort_couplings() {
  const std::size_t n = order_.size();
  coupling_first_.assign(n + 1, 0);
  for (const auto& coupling : couplings_) ++coupling_first_[at(coupling[0]) + 1];
  for (std::size_t k = 0; k < n; ++k) coupling_first_[k + 1] += coupling_first_[k];
  coupled_.reserve(couplings_.capacity());
  coupled_.resize(couplings_.size());
  for (const auto& coupling : couplings_) coupled_[coupling_first_[at(coupling[0])]++] = coupling[1];
  for (std::size_t k = n; k > 0; --k) coupling_first_[k] = coupling_first_[k - 1];
  coupling_first_[0] = 0;
}

/// Finds the columns of each row: those of its couplings and those of its children in the elimination tree. A row is a
/// child of its first column (Davis, Direct Methods for Sparse Linear Systems, 2006, 4.1). The columns of its largest
/// child are in order already; the others, mostly few, are sorted and merged into them.
void BlockLdlt::find_columns() {
  const std::size_t n = order_.size();
  first_child_.assign(n, -1);
  next_child_.assign(n, -1);
  mark_.assign(n, -1);
  other_columns_.reserve(n);
  first_.assign(1, 0);
  columns_.clear();
  for (std::size_t k = 0; k < n; ++k) {
    const int row = static_cast<int>(k);
    mark_[k] = row;
    other_columns_.clear();
    const auto add_column = [&](int column) {
      if (mark_[at(column)] == row) return;
      mark_[at(column)] = row;
      other_columns_.push_back(column);
    };
    const auto count = [this](int child) { return first_[at(child) + 1] - first_[at(child)]; };
    int largest = first_child_[k];
    for (int child = largest; child >= 0; child = next_child_[at(child)]) {
      if (count(child) > count(largest)) largest = child;
    }
    if (largest >= 0) {
      for (std::size_t i = first_[at(largest)] + 1; i < first_[at(largest) + 1]; ++i) {  // its first column is the row
        mark_[at(columns_[i])] = row;
        columns_.push_back(columns_[i]);
      }
    }
    for (std::size_t i = coupling_first_[k]; i < coupling_first_[k + 1]; ++i) add_column(coupled_[i]);
    for (int child = first_child_[k]; child >= 0; child = next_child_[at(child)]) {
      if (child == largest) continue;
      for (std::size_t i = first_[at(child)]; i < first_[at(child) + 1]; ++i) add_column(columns_[i]);
    }
    merge_other_columns(first_[k]);
    first_.push_back(columns_.size());
    if (first_[k] == first_[k + 1]) continue;
    const std::size_t parent = at(columns_[first_[k]]);
    next_child_[k] = first_child_[parent];
    first_child_[parent] = row;
  }
}

/// Merges the other columns into those from `first` on.
void BlockLdlt::merge_other_columns(std::size_t first) {
  if (other_columns_.empty()) return;
  std::sort(other_columns_.begin(), other_columns_.end());
  std::size_t left = columns_.size();
  std::size_t other = other_columns_.size();
  columns_.resize(left + other);
  while (other > 0) {
    const std::size_t place = left + other - 1;
    const bool from_left = left > first && columns_[left - 1] > other_columns_[other - 1];
    columns_[place] = from_left ? columns_[--left] : other_columns_[--other];
  }
}

/// Finds which rows are eliminated together: four or two that follow each other, of which each has those behind it as
/// its first columns, and no column that the last does not have.
void BlockLdlt::find_widths() {
  const std::size_t n = order_.size();
  const auto columns_of = [this](std::size_t row) { return first_[row + 1] - first_[row]; };
  widths_.assign(n, 1);
  for (std::size_t k = 0; k < n; k += at(widths_[k])) {
    std::size_t width = 1;
    while (width < 4 && columns_of(k + width - 1) > 0 && at(columns_[first_[k + width - 1]]) == k + width &&
           columns_of(k + width - 1) == columns_of(k + width) + 1) {
      ++width;
    }
    if (columns_of(k + width - 1) < min_shared) width = 1;
    widths_[k] = width == 3 ? 2 : static_cast<int>(width);
  }
}

void BlockLdlt::resize_blocks() {
  const std::size_t n = order_.size();
  blocks_.reserve(columns_.capacity());
  blocks_.resize(columns_.size());
  diagonals_.resize(n);
  held_.resize(n);
  dual_.resize(n);
  right_side_.resize(n);
}

inline std::size_t BlockLdlt::find(int row, int column) const {
  const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(first_[at(row)]);
  const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_[at(row) + 1]);
  const auto found = end - begin <= max_linear_search
                         ? std::find_if(begin, end, [column](int c) { return c >= column; })
                         : std::lower_bound(begin, end, column);
  return found != end && *found == column ? static_cast<std::size_t>(found - columns_.begin()) : columns_.size();
}

bool BlockLdlt::is_coupled(int a, int b) const {
  const int row_a = row_of_[at(a)];
  const int row_b = row_of_[at(b)];
  return row_a == row_b || find(std::min(row_a, row_b), std::max(row_a, row_b)) < columns_.size();
}

void BlockLdlt::set_zero() {
  std::fill(blocks_.begin(), blocks_.end(), Block{});
  std::fill(diagonals_.begin(), diagonals_.end(), Diagonal{});
  std::fill(held_.begin(), held_.end(), 0);
  std::fill(dual_.begin(), dual_.end(), 0);
}

void BlockLdlt::add(int a, int b, double xx, double xy, double yx, double yy) {
  int row = row_of_[at(a)];
  int column = row_of_[at(b)];
  if (row == column) {
    add(a, 2.0 * xx, xy + yx, 2.0 * yy);  // of tied slots: the block and its transpose
    return;
  }
  if (row > column) {
    std::swap(row, column);
    std::swap(xy, yx);
  }
  const std::size_t place = find(row, column);
  assert(place < columns_.size());
  blocks_[place] += {xx, xy, yx, yy};
}

void BlockLdlt::add(int a, double xx, double xy, double yy) {
  Diagonal& diagonal = diagonals_[at(row_of_[at(a)])];
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
    const int row = row_of_[at(first + p)];
    std::size_t place = first_[at(row)];
    int before = row;
    for (int k = 1; k <= reach && p + k < n; ++k) {
      const int column = row_of_[at(first + p + k)];
      if (column < before) {
        add(first + p, first + p + k, upper[2 * k], upper[2 * k + 1], lower[2 * k - 1], lower[2 * k]);
        continue;
      }
      before = column;
      while (columns_[place] != column) ++place;
      blocks_[place] += {upper[2 * k], upper[2 * k + 1], lower[2 * k - 1], lower[2 * k]};
    }
  }
}

void BlockLdlt::load_right_side(std::span<const Vec2> b) {
  for (std::size_t k = 0; k < order_.size(); ++k) right_side_[k] = b[at(order_[k])];
  for (const TiedSlot& tied : tied_) right_side_[at(row_of_[at(tied.slot)])] += b[at(tied.slot)];
}

bool BlockLdlt::solve(std::span<Vec2> b) {
  const std::size_t n = order_.size();
  load_right_side(b);
  for (std::size_t k = 0; k < n; k += at(widths_[k])) {
    const bool done = widths_[k] == 4           ? eliminate_rows<4>(k)
                      : widths_[k] == 2         ? eliminate_rows<2>(k)
                      : dual_[k] == scalar_dual ? eliminate<1, 1>(k)
                                                : eliminate<1, 0>(k);
    if (!done) return false;
  }
  substitute(b);
  return true;
}

void BlockLdlt::solve_again(std::span<Vec2> b) {
  const std::size_t n = order_.size();
  load_right_side(b);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 r = right_side_[k];
    for (std::size_t i = first_[k]; i < first_[k + 1]; ++i) {
      const Block& l = blocks_[i];
      right_side_[at(columns_[i])] -= {l.xx * r.x + l.yx * r.y, l.xy * r.x + l.yy * r.y};
    }
  }
  substitute(b);
}

/// Back substitution from the last row to the first: x = D⁻¹·r − Σ L_i·x_i.
inline void BlockLdlt::substitute(std::span<Vec2> b) {
  const std::size_t n = order_.size();
  for (std::size_t k = n; k-- > 0;) {
    const Diagonal& inverse = diagonals_[k];
    const Vec2 r = right_side_[k];
    Vec2 x{inverse.xx * r.x + inverse.xy * r.y, inverse.xy * r.x + inverse.yy * r.y};
    for (std::size_t i = first_[k + 1]; i-- > first_[k];) {
      const Block& l = blocks_[i];
      const Vec2 later = right_side_[at(columns_[i])];
      x -= {l.xx * later.x + l.xy * later.y, l.yx * later.x + l.yy * later.y};
    }
    right_side_[k] = x;
  }
  for (std::size_t k = 0; k < n; ++k) b[at(order_[k])] = right_side_[k];
  for (const TiedSlot& tied : tied_) b[at(tied.slot)] = b[at(tied.with)];
}

/// Inverts the diagonal block of a row. Returns false if its sign is not that of the row.
inline bool BlockLdlt::invert_pivot(std::size_t row) {
  Diagonal& d = diagonals_[row];
  if (held_[row] != 0) {
    d = {1.0, 0.0, 1.0};
    std::fill(blocks_.begin() + static_cast<std::ptrdiff_t>(first_[row]),
              blocks_.begin() + static_cast<std::ptrdiff_t>(first_[row + 1]), Block{});
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
    pivots[k] = {diagonals_[row], right_side_[row], blocks_.data() + first_[row]};
    const int* const columns = columns_.data() + first_[row];
    const std::size_t count = first_[row + 1] - first_[row];
    for (std::size_t i = 0; i + 1 + k < rows; ++i) {
      if (((scalars >> k) & 1U) != 0) {
        subtract_rows<1, 1>(&pivots[k], columns + i, count - i);
      } else {
        subtract_rows<1, 0>(&pivots[k], columns + i, count - i);
      }
    }
  }
  const std::size_t last = first_row + rows - 1;
  const int* const end = columns_.data() + first_[last + 1];
  for (const int* column = columns_.data() + first_[last]; column != end; ++column) {
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

/// Subtracts what pivots contribute to the row of the first of `count` columns, and moves them on to their next blocks.
template <std::size_t rows, std::size_t scalars>
[[gnu::always_inline]] inline void BlockLdlt::subtract_rows(Pivot* pivots, const int* columns, std::size_t count) {
  const std::size_t target = at(columns[0]);
  if (held_[target] != 0) {
    for (std::size_t k = 0; k < rows; ++k) *pivots[k].block++ = {};
    return;
  }
  std::array<std::array<Pair, 2>, rows> l;
  std::array<const Block*, rows> later;
  Diagonal& diagonal = diagonals_[target];
  for (std::size_t k = 0; k < rows; ++k) {
    const Diagonal inverse = pivots[k].inverse;
    const Vec2 r = pivots[k].right_side;
    Block& block = *pivots[k].block++;
    later[k] = pivots[k].block;
    const Pair b_x = load_pair(&block.xx);
    const Pair b_y = load_pair(&block.yx);
    const Pair l_x = inverse.xx * b_x + inverse.xy * b_y;
    const Pair l_y = inverse.xy * b_x + inverse.yy * b_y;
    store_pair(l_x, &block.xx);
    store_pair(l_y, &block.yx);
    subtract_pair(l_x * r.x + l_y * r.y, &right_side_[target].x);
    subtract_pair(l_x[0] * b_x + l_y[0] * b_y, &diagonal.xx);
    diagonal.yy -= (l_x * b_x + l_y * b_y)[1];
    l[k] = {l_x, l_y};
  }
  const auto subtract_from = [&](Block& block, std::size_t j) {
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
  };
  const std::size_t first = first_[target];
  Block* block = blocks_.data() + first;
  if (rows > 1 && first_[target + 1] - first == count - 1) {  // the target has no other columns than these
    for (std::size_t j = 0; j + 1 < count; ++j) subtract_from(*block++, j);
    return;
  }
  const int* column = columns_.data() + first;
  for (std::size_t j = 0; j + 1 < count; ++j) {
    while (*column != columns[j + 1]) ++column, ++block;
    subtract_from(*block, j);
  }
}

}  // namespace ribbon
