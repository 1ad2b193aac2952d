#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "ribbon/linear/index.h"

namespace ribbon {

/// A slot that has the same unknowns as another one.
struct TiedSlot {
  int slot;
  int with;

  bool operator==(const TiedSlot&) const = default;
};

/// The pattern of a sparse symmetric matrix of blocks and of its factors. Each slot has a row, in the order of
/// elimination. Eliminating a row couples all later rows that it is coupled with; these fill-in blocks are part of the
/// pattern.
class BlockPattern {
 public:
  /// Starts a pattern of diagonal blocks: see BlockLdlt::begin_pattern.
  void begin(std::span<const int> order, std::span<const TiedSlot> tied);
  /// Adds the blocks (a, b) and (b, a), by slots. Repeated couplings count once.
  void couple(int a, int b);
  /// Completes the pattern with the fill-in.
  void end();
  /// Changes the order of elimination, with the same tied slots, and completes the pattern again.
  void reorder(std::span<const int> order);
  /// Calls visit(a, b) for each call of couple(), with either slot first.
  template <typename Visit>
  void for_each_coupling(Visit&& visit) const {
    for (const auto& [a, b] : couplings_) visit(order_[at(a)], order_[at(b)]);
  }

  /// Returns the number of rows.
  std::size_t size() const { return order_.size(); }
  /// Returns the number of blocks right of the diagonal.
  std::size_t blocks() const { return columns_.size(); }
  /// Returns the number of blocks for which memory is reserved.
  std::size_t capacity() const { return columns_.capacity(); }
  int row_of(int slot) const { return row_of_[at(slot)]; }
  int slot_of(std::size_t row) const { return order_[row]; }
  std::span<const TiedSlot> tied() const { return tied_; }
  /// Returns the index of the first block of a row, or the number of blocks for the row behind the last.
  std::size_t first(std::size_t row) const { return first_[row]; }
  /// The columns of the blocks, ascending within a row.
  const int* columns() const { return columns_.data(); }
  /// Returns how many rows from this one on are eliminated together: 4, 2 or 1. They have the same columns behind them.
  std::size_t width(std::size_t row) const { return at(widths_[row]); }
  /// Returns the index of the block (row, column), or the number of blocks if the pattern has no such block.
  std::size_t find(int row, int column) const;

 private:
  void assign_rows(std::span<const int> order);
  void sort_couplings();
  void find_columns();
  void merge_other_columns(std::size_t first);
  void find_widths();

  std::vector<int> order_;  // slot by row
  std::vector<TiedSlot> tied_;
  std::vector<int> row_of_;                    // row by slot
  std::vector<std::array<int, 2>> couplings_;  // rows a < b, in any order, some more than once
  std::vector<std::size_t> coupling_first_;    // index in coupled_ of each row, and the end of the last
  std::vector<int> coupled_;                   // columns of the couplings, row by row
  std::vector<int> first_child_, next_child_;  // elimination tree, by row; −1: none
  std::vector<int> other_columns_;             // of the row that is found, beside those of its largest child
  std::vector<int> mark_;                      // by column: the last row that listed it
  std::vector<std::size_t> first_;             // index in columns_ of each row, and the end of the last
  std::vector<int> columns_;
  std::vector<int> widths_;  // by the first row of those that are eliminated together
};

inline std::size_t BlockPattern::find(int row, int column) const {
  constexpr std::ptrdiff_t max_linear_search = 8;  // columns; a binary search is faster above
  const auto begin = columns_.begin() + static_cast<std::ptrdiff_t>(first_[at(row)]);
  const auto end = columns_.begin() + static_cast<std::ptrdiff_t>(first_[at(row) + 1]);
  const auto found = end - begin <= max_linear_search
                         ? std::find_if(begin, end, [column](int c) { return c >= column; })
                         : std::lower_bound(begin, end, column);
  return found != end && *found == column ? static_cast<std::size_t>(found - columns_.begin()) : columns_.size();
}

}  // namespace ribbon
