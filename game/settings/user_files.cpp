#include "game/settings/user_files.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "engine/files/regular_file.h"

namespace game {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t max_bytes = 1U << 20U;

std::string folder(const char* variable, const char* below_home) {
  const char* const chosen = std::getenv(variable);
  if (chosen != nullptr && fs::path(chosen).is_absolute()) return std::string(chosen) + "/ropeswing";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || !fs::path(home).is_absolute()) return "";
  return std::string(home) + below_home + "/ropeswing";
}

/// Returns the absolute path that a value of user-dirs.dirs names: "$HOME/Pictures" or "/mnt/pictures". Empty if it
/// names none, or the home itself, which means that there is no such folder.
std::string path_of(std::string value, const std::string& home) {
  if (value.size() < 2 || value.front() != '"' || value.back() != '"') return "";
  value = value.substr(1, value.size() - 2);
  const std::string begin = "$HOME";
  if (value.starts_with(begin)) value.replace(0, begin.size(), home);
  const fs::path path = fs::path(value).lexically_normal();
  const bool is_home = (path / "").lexically_normal() == (fs::path(home) / "").lexically_normal();
  return path.is_absolute() && !is_home ? path.string() : "";
}

/// Returns a folder by its name in the desktop's list of the user's folders; empty if that names none.
std::string desktop_folder(const std::string& name) {
  if (const char* const chosen = std::getenv(name.c_str()); chosen != nullptr && fs::path(chosen).is_absolute())
    return chosen;
  const char* const home = std::getenv("HOME");
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  if (home == nullptr || !fs::path(home).is_absolute()) return "";
  const bool has_config = config != nullptr && fs::path(config).is_absolute();
  std::ifstream list((has_config ? std::string(config) : std::string(home) + "/.config") + "/user-dirs.dirs");
  std::string found;
  for (std::string line; std::getline(list, line);) {
    if (line.starts_with(name + "=")) found = path_of(line.substr(name.size() + 1), home);
  }
  return found;
}

std::string saving_folder(const std::string& name, const char* below_data) {
  std::string chosen = desktop_folder(name);
  if (!chosen.empty()) return chosen;
  return data_folder().empty() ? "" : data_folder() + below_data;
}

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  throw std::runtime_error(path + ": cannot be written: " + reason);
}

/// Replaces the file at `path` by one that `write` makes beside it.
template <typename Write>
void replace(const std::string& path, Write write) {
  const std::string part = path + ".part";
  std::error_code error;
  fs::create_directories(fs::path(path).parent_path(), error);
  if (error) fail(path, error.message());
  write(part);
  fs::rename(part, path, error);
  if (error) fail(path, error.message());
}

}  // namespace

std::string config_folder() { return folder("XDG_CONFIG_HOME", "/.config"); }

std::string data_folder() { return folder("XDG_DATA_HOME", "/.local/share"); }

std::string pictures_folder() { return saving_folder("XDG_PICTURES_DIR", "/pictures"); }

std::string videos_folder() { return saving_folder("XDG_VIDEOS_DIR", "/videos"); }

std::optional<std::string> read_user_file(const std::string& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  std::ifstream in = engine::open_regular_file(path);
  if (fs::file_size(path, ignored) > max_bytes) throw std::runtime_error(path + ": is too large");
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw std::runtime_error(path + ": cannot be read");
  return text.str();
}

void write_user_file(const std::string& path, const std::string& text) {
  replace(path, [&](const std::string& part) {
    errno = 0;
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    if (!out) fail(path, errno == 0 ? "reason unknown" : std::generic_category().message(errno));
  });
}

void copy_user_file(const std::string& from, const std::string& to) {
  replace(to, [&](const std::string& part) {
    std::error_code error;
    fs::copy_file(from, part, fs::copy_options::overwrite_existing, error);
    if (error) fail(to, error.message());
  });
}

void rename_broken(const std::string& path) {
  std::error_code ignored;
  fs::rename(path, path + ".broken", ignored);
}

}  // namespace game
