#pragma once

#include <string>

#include "game/settings/settings.h"

namespace game {

/// Settings as JSON.
std::string settings_text(const Settings& settings);
/// The other way round; what is not in it is as by default. Throws a std::runtime_error, beginning with `where`, that
/// names the field which is wrong and what is accepted.
Settings parse_settings(const std::string& text, const std::string& where);

/// A player's settings between two games.
class SettingsFile {
 public:
  /// An empty path: nothing is remembered.
  explicit SettingsFile(std::string path) : path_(std::move(path)) {}

  /// What the file holds. If it cannot be used the settings are those by default, the file is kept aside, and `notice`
  /// says so.
  Settings load(std::string& notice);
  /// Writes them if they differ from those that were last read or written. The first time that this fails `notice`
  /// says so.
  void keep(const Settings& settings, std::string& notice);

 private:
  std::string path_;
  Settings kept_;
  bool failed_ = false;
};

}  // namespace game
