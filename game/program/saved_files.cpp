#include "game/program/saved_files.h"

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "game/words/words.h"

namespace game {

namespace fs = std::filesystem;

std::string SavedFiles::next(const std::string& ending) const {
  if (folder_.empty()) throw std::runtime_error(words::no_folder);
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw std::runtime_error(folder_ + ": " + error.message());
  for (int number = 1;; ++number) {
    std::string path = folder_ + "/ropeswing-" + std::to_string(number) + ending;
    if (!fs::exists(path, error)) return path;
  }
}

std::string SavedFiles::to_tell(const std::string& path) {
  return std::exchange(told_, true) ? fs::path(path).filename().string() : path;
}

}  // namespace game
