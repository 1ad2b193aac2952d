#pragma once

#include <optional>
#include <string>

/// The one door to the player's own files.
namespace game {

/// $XDG_CONFIG_HOME/ropeswing, or ~/.config/ropeswing; empty if there is no home.
std::string config_folder();
/// $XDG_DATA_HOME/ropeswing, or ~/.local/share/ropeswing; empty if there is no home.
std::string data_folder();

/// The text of a regular file of at most 1 MiB; none if there is no such file. Throws a std::runtime_error naming it if
/// it is something else or cannot be read.
std::optional<std::string> read_user_file(const std::string& path);
/// Replaces the file at once or not at all, and makes its folder if need be. Throws a std::runtime_error naming it.
void write_user_file(const std::string& path, const std::string& text);
/// Copies a file in the same way.
void copy_user_file(const std::string& from, const std::string& to);
/// Renames a file that cannot be used, so that it is not overwritten: NAME.broken, in the place of an earlier one.
void keep_aside(const std::string& path);

}  // namespace game
