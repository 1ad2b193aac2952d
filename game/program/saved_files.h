#pragma once

#include <string>
#include <utility>

namespace game {

/// Names for new pictures or videos in a folder of the user.
class SavedFiles {
 public:
  /// An empty folder: there is none, and no file can be saved.
  explicit SavedFiles(std::string folder) : folder_(std::move(folder)) {}

  /// Makes the folder and returns the path of the first free name of ropeswing-1.mp4, -2.mp4, … Throws a
  /// std::runtime_error with the folder if it cannot be made.
  std::string next(const std::string& ending) const;
  /// Returns a path for the player: the whole path the first time, later only the name of the file.
  std::string to_tell(const std::string& path);

 private:
  std::string folder_;
  bool told_ = false;
};

}  // namespace game
