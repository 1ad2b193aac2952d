#include "engine/files/regular_file.h"

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace engine {

std::ifstream open_regular_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw std::runtime_error(path + ": there is no such file");
  if (status.type() == fs::file_type::none) throw std::runtime_error(path + ": " + error.message());
  if (fs::is_directory(status)) throw std::runtime_error(path + ": is a directory, accepted is a file");
  if (!fs::is_regular_file(status)) throw std::runtime_error(path + ": is a device or pipe, accepted is a file");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  const int reason = errno;
  if (!in) {
    throw std::runtime_error(
        path + ": cannot be opened: " + (reason == 0 ? "reason unknown" : std::generic_category().message(reason)));
  }
  return in;
}

}  // namespace engine
