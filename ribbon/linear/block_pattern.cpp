#include "ribbon/linear/block_pattern.h"

#include <algorithm>

#include "ribbon/linear/index.h"
#include "ribbon/linear/reserve_more.h"

namespace ribbon {
namespace {

constexpr std::size_t min_shared = 4;  // columns, from which on rows are eliminated together

}  // namespace

void BlockPattern::begin(std::span<const int> order, std::span<const TiedSlot> tied) {
  tied_.assign(tied.begin(), tied.end());
  row_of_.resize(order.size() + tied.size());
  assign_rows(order);
  couplings_.clear();
}

void BlockPattern::assign_rows(std::span<const int> order) {
  reserve_more(order_, order.size());
  order_.assign(order.begin(), order.end());
  for (std::size_t row = 0; row < order.size(); ++row) row_of_[at(order[row])] = static_cast<int>(row);
  for (const TiedSlot& tied : tied_) row_of_[at(tied.slot)] = row_of_[at(tied.with)];
}

void BlockPattern::couple(int a, int b) {
  const int row_a = row_of_[at(a)];
  const int row_b = row_of_[at(b)];
  if (row_a == row_b) return;
  couplings_.push_back({std::min(row_a, row_b), std::max(row_a, row_b)});
}

void BlockPattern::reorder(std::span<const int> order) {
  for (auto& coupling : couplings_) coupling = {order_[at(coupling[0])], order_[at(coupling[1])]};
  assign_rows(order);
  for (auto& coupling : couplings_) {
    const int a = row_of_[at(coupling[0])];
    const int b = row_of_[at(coupling[1])];
    coupling = {std::min(a, b), std::max(a, b)};
  }
  end();
}

void BlockPattern::end() {
  sort_couplings();
  find_columns();
  find_widths();
}

/// Sorts the couplings by row: a counting sort in O(rows + couplings).
void BlockPattern::sort_couplings() {
  const std::size_t n = order_.size();
  reserve_more(coupling_first_, n + 1);
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
void BlockPattern::find_columns() {
  const std::size_t n = order_.size();
  for (auto* all : {&first_child_, &next_child_, &mark_, &other_columns_}) reserve_more(*all, n);
  first_child_.assign(n, -1);
  next_child_.assign(n, -1);
  mark_.assign(n, -1);
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
void BlockPattern::merge_other_columns(std::size_t first) {
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
void BlockPattern::find_widths() {
  const std::size_t n = order_.size();
  const auto columns_of = [this](std::size_t row) { return first_[row + 1] - first_[row]; };
  reserve_more(widths_, n);
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

}  // namespace ribbon
