#pragma once

#include <optional>
#include <string>

#include "tests/study/trace.h"

namespace study {

/// Writes a run to a file, all of it or nothing. `key` is what it is a run of. False if it cannot be written.
bool keep(const Trace& trace, const std::string& key, const std::string& path);

/// The run that a file keeps, to the same bits; none if there is no such file, or it is not whole, or of another key.
std::optional<Trace> kept(const std::string& key, const std::string& path);

}  // namespace study
