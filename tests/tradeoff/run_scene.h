#pragma once

#include <vector>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// Finds the figures of each contestant, then times all of them side by side; with bars of progress on the terminal.
std::vector<Row> run_scene(const Scene& scene, const std::vector<Contestant>& contestants, int repeats);

}  // namespace tradeoff
