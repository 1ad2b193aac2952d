#pragma once

#include <optional>

namespace study {

/// A bar on the terminal's error stream, so that what is printed stays clean; with the seconds that are left, if
/// somebody knows.
void show_progress(const char* what, double share, std::optional<double> seconds_left = std::nullopt);

}  // namespace study
