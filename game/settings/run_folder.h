#pragma once

#include <string>

namespace game {

/// The folder of the recordings of all runs, numbered: 000017-first_swing.replay. Only the newest max_runs are stored.
class RunFolder {
 public:
  static constexpr int max_runs = 50;

  /// An empty folder: runs are not recorded.
  explicit RunFolder(std::string folder) : folder_(std::move(folder)) {}

  /// Returns the path for a new recording and removes the oldest ones. Empty if the folder cannot be made.
  std::string next_path(const std::string& level);

 private:
  std::string folder_;
};

}  // namespace game
