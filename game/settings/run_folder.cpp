#include "game/settings/run_folder.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t digits = 6;
constexpr int max_number = 999'999;

/// Returns the number at the start of a recording's name; 0 for other files.
int number_of(const fs::path& path) {
  const std::string name = path.filename().string();
  if (path.extension() != ".replay" || name.size() <= digits || name[digits] != '-') return 0;
  const std::string number = name.substr(0, digits);
  return number.find_first_not_of("0123456789") == std::string::npos ? std::stoi(number) : 0;
}

std::multimap<int, fs::path> recordings(const std::string& folder) {
  std::multimap<int, fs::path> found;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (const int number = number_of(entry.path()); number > 0) found.emplace(number, entry.path());
  }
  return found;
}

}  // namespace

std::string RunFolder::next_path(const std::string& level) {
  if (folder_.empty()) return "";
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) return "";
  std::multimap<int, fs::path> found = recordings(folder_);
  const int next = found.empty() ? 1 : std::min(found.rbegin()->first + 1, max_number);
  while (found.size() >= max_runs) {
    fs::remove(found.begin()->second, error);
    found.erase(found.begin());
  }
  const std::string number = std::to_string(next);
  return folder_ + "/" + std::string(digits - number.size(), '0') + number + "-" + level + ".replay";
}

}  // namespace game
