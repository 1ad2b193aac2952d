#pragma once

#include <string>
#include <vector>

#include "tests/baseline/table.h"

namespace baseline {

/// How much more work than the baseline's is taken: in all ticks, and in the tick that takes the most.
inline constexpr double allowed_percent = 5.0;

/// What differs, a sentence each.
struct Comparison {
  std::vector<std::string> worse;   ///< more work than is allowed; other ticks; rows that only one of both has
  std::vector<std::string> better;  ///< less work, by as much as more would not be allowed
};

Comparison compare(const std::vector<Row>& baseline, const std::vector<Row>& counted);

}  // namespace baseline
