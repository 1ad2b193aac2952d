#pragma once

#include <fstream>
#include <string>

namespace engine {

/// Opens a regular file for reading, in binary. Throws a std::runtime_error naming path and reason if there is none or
/// it cannot be opened; a directory, device or pipe is refused, since reading one could fail late or never end.
std::ifstream open_regular_file(const std::string& path);

}  // namespace engine
