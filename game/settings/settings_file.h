#pragma once

#include <string>

#include "game/settings/settings.h"

namespace game {

/// Returns the settings as JSON.
std::string settings_text(const Settings& settings);
/// Reads settings; missing fields have their defaults. Throws a std::runtime_error whose message begins with `where`
/// and names the invalid field and what is accepted.
Settings parse_settings(const std::string& text, const std::string& where);

/// The file of a player's settings.
class SettingsFile {
 public:
  /// An empty path: nothing is saved.
  explicit SettingsFile(std::string path) : path_(std::move(path)) {}

  /// Reads the file. If it is invalid, returns the defaults, renames the file, and reports it in `notice`.
  Settings load(std::string& notice);
  /// Writes the settings if they have changed since the last load or save. `notice` reports the first failure.
  void save(const Settings& settings, std::string& notice);

 private:
  std::string path_;
  Settings saved_;
  bool failed_ = false;
};

}  // namespace game
