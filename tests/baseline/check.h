#pragma once

#include <filesystem>
#include <vector>

#include "tests/tradeoff/scenes.h"

namespace baseline {

/// Counts the work of the scenes and of all recorded runs and prints how it differs from the table's; 1 if any is
/// worse, 0 otherwise. Throws std::runtime_error for a table that cannot be read, or a run that goes otherwise than
/// recorded.
int check(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table);

/// Writes the table anew, as it is counted now. Throws std::runtime_error as check does, or if it cannot be written.
void accept(const std::vector<tradeoff::Scene>& scenes, const std::filesystem::path& table);

}  // namespace baseline
