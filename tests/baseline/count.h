#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "tests/baseline/table.h"
#include "tests/tradeoff/scenes.h"

namespace baseline {

/// The rows of a scene: of its contestants that count work, over the ticks that it times, or its counted_ticks, from
/// where it times them. One row of those that have one name.
std::vector<Row> count(const tradeoff::Scene& scene);

/// A recorded run, all of it: the cords of its level that the direct solver solves. Throws std::runtime_error if it
/// goes otherwise than it was recorded.
Row count_run(const std::filesystem::path& replay);

/// The scenes, then the recorded runs in the assets, by name. `progress` is told the share done, 0 … 1.
std::vector<Row> count_all(const std::vector<tradeoff::Scene>& scenes, const std::function<void(double)>& progress);

}  // namespace baseline
