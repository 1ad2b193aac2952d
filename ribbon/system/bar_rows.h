#pragma once

#include <vector>

#include "ribbon/convex/limited_rows.h"
#include "ribbon/elastic/link.h"
#include "ribbon/system/island_state.h"

namespace ribbon {

/// The bars of an island that cannot push, as rows of a convex problem: which of them are slack is then part of its
/// solution. Bars at wheels are not among them.
class BarRows {
 public:
  /// Reserves memory for so many bars.
  void reserve(std::size_t count);
  /// Appends a row for each bar.
  void append(IslandState& state, const Stage& stage, LimitedRows& rows);
  /// Writes the tensions of the solution to `next`, by tension.
  void take(const LimitedRows& rows, std::span<double> next) const;

 private:
  std::vector<OneSidedBar> bars_;
  std::vector<std::size_t> tensions_;  // index, by row
  std::size_t first_ = 0;              // row
};

}  // namespace ribbon
