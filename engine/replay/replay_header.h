#pragma once

#include <string>
#include <string_view>

#include "engine/replay/replay.h"

/// The header of a replay as its line of JSON. Part of the writer and the reader; included by their sources only.
namespace engine {

/// With its line feed. Throws a ReplayError on what cannot be recorded.
std::string replay_header_line(const ReplayHeader& header);

/// Throws a ReplayError naming the field, what was found and what is accepted.
ReplayHeader parse_replay_header(std::string_view line);

}  // namespace engine
