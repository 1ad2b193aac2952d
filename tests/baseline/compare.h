#pragma once

#include <string>
#include <vector>

#include "tests/baseline/table.h"

namespace baseline {

/// The accepted increase of work over the baseline: in all ticks, and in the tick with the maximum.
inline constexpr double allowed_percent = 5.0;

/// The differences, one sentence per row.
struct Comparison {
  std::vector<std::string> worse;   ///< more work than accepted; other number of ticks; missing and new rows
  std::vector<std::string> better;  ///< less work, by more than the accepted increase
};

Comparison compare(const std::vector<Row>& baseline, const std::vector<Row>& counted);

}  // namespace baseline
