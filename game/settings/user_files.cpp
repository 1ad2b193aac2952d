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
