#pragma once

#include <fstream>
#include <string>

namespace engine {

/// Opens a regular file for reading in binary mode. Throws a std::runtime_error with path and reason if the file does
/// not exist, cannot be opened, or is a directory, device or pipe, since reading those may fail late or never end.
std::ifstream open_regular_file(const std::string& path);

}  // namespace engine
