#pragma once

#include <vector>

#include "tests/tradeoff/scenes.h"

namespace tradeoff {

/// Computes the figures of each variant, then times all of them in turn, with progress bars on the terminal.
std::vector<Row> run_scene(const Scene& scene, const std::vector<Variant>& variants, int repeats);

}  // namespace tradeoff
