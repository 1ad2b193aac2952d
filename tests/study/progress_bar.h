#pragma once

#include <optional>

namespace study {

/// Draws a bar on the error stream, so that the output stays clean; with the remaining seconds, if they are known.
void show_progress(const char* what, double share, std::optional<double> seconds_left = std::nullopt);

}  // namespace study
