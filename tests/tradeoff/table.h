#pragma once

#include <vector>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// Prints rows to the standard output: as comma-separated values, or as a table with the cost per point and relative to
/// the scene's reference_setting.
void print_csv(const Scene& scene, const std::vector<Row>& rows);
void print_table(const Scene& scene, const std::vector<Row>& rows);

}  // namespace tradeoff
