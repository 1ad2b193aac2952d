#pragma once

#include <optional>
#include <string>

#include "tests/study/trace.h"

namespace study {

/// Writes a run to a file, completely or not at all. `key` identifies the run. Returns false if it cannot be written.
bool save_trace(const Trace& trace, const std::string& key, const std::string& path);

/// Returns the run in a file, with the same bits; none if the file is missing, incomplete, or has another key.
std::optional<Trace> load_trace(const std::string& key, const std::string& path);

}  // namespace study
