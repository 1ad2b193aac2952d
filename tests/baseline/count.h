#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tests/baseline/table.h"
#include "tests/tradeoff/scenes.h"

namespace baseline {

/// Returns the rows of a scene: of its variants that count work, over the timed ticks, or over counted_ticks from
/// the first timed one. Variants with the same name have one row.
std::vector<Row> count(const tradeoff::Scene& scene);

/// Returns the row of a whole recorded run, for the cords of the direct solver. Throws std::runtime_error if the run
/// differs from its recording.
Row count_run(const std::filesystem::path& replay);

/// Returns the rows of the scenes, then those of the recorded runs in the assets by name. Calls `progress` with the
/// share done, 0 … 1.
std::vector<Row> count_all(const std::vector<tradeoff::Scene>& scenes, const std::function<void(double)>& progress);

}  // namespace baseline
