#pragma once

#include <optional>
#include <string>

/// Access to the player's own files. The only place that reads and writes them.
namespace game {

/// $XDG_CONFIG_HOME/ropeswing, or ~/.config/ropeswing; empty if there is no home.
std::string config_folder();
/// $XDG_DATA_HOME/ropeswing, or ~/.local/share/ropeswing; empty if there is no home.
std::string data_folder();

/// Returns the user's folder for pictures: $XDG_PICTURES_DIR, or that of user-dirs.dirs in the folder of settings of
/// the desktop, or pictures in data_folder(); empty if there is no home. It may not exist yet.
std::string pictures_folder();
/// The same for videos: XDG_VIDEOS_DIR, or videos in data_folder().
std::string videos_folder();

/// Reads a regular file of at most 1 MiB. Returns nothing if it does not exist. Throws a std::runtime_error with the
/// path if it cannot be read or is not a regular file.
std::optional<std::string> read_user_file(const std::string& path);
/// Replaces a file atomically and makes its folder if necessary. Throws a std::runtime_error with the path.
void write_user_file(const std::string& path, const std::string& text);
/// Copies a file atomically and makes the folder if necessary. Throws a std::runtime_error with the path.
void copy_user_file(const std::string& from, const std::string& to);
/// Renames an invalid file to NAME.broken, so that it is not overwritten. Replaces an earlier NAME.broken.
void rename_broken(const std::string& path);

}  // namespace game
