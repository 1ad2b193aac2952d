#pragma once

#include <optional>
#include <string>

#include "tests/study/trace.h"

namespace study {

/// Returns a run as bytes that only this program reads; and the run of such bytes, with the same bits. Precondition of
/// the latter: the bytes are complete.
std::string bytes_of(const Trace& trace);
Trace trace_of(const std::string& bytes);

/// Writes a run to a file, completely or not at all. `key` identifies the run. Returns false if it cannot be written.
bool save_trace(const Trace& trace, const std::string& key, const std::string& path);

/// Returns the run in a file, with the same bits; none if the file is missing, incomplete, or has another key.
std::optional<Trace> load_trace(const std::string& key, const std::string& path);

}  // namespace study
