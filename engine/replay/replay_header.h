#pragma once

#include <string>
#include <string_view>

#include "engine/replay/replay.h"

/// The header of a replay as one line of JSON. Private to the writer and the reader.
namespace engine {

/// Returns the line including its line feed. Throws a ReplayError if the header cannot be recorded.
std::string replay_header_line(const ReplayHeader& header);

/// Throws a ReplayError with the field, what was found and what is accepted.
ReplayHeader parse_replay_header(std::string_view line);

}  // namespace engine
