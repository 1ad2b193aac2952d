#pragma once

#include <filesystem>
#include <vector>

#include "tests/tradeoff/scenes.h"

namespace baseline {

/// Counts the work of the scenes and of all recorded runs, and prints the differences from the table. Returns 1 if any
/// row is worse, 0 otherwise. Throws std::runtime_error for a table that cannot be read, or a run that differs from its
/// recording.
int check(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table);

/// Rewrites the table with the present counts. Throws std::runtime_error as check does, or if it cannot be written.
void accept(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table);

}  // namespace baseline
