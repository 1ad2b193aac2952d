#pragma once

#include <string>

namespace game {

/// Where every run is recorded, under the next number: 000017-first_swing.replay. The newest are kept.
class RunFolder {
 public:
  static constexpr int kept = 50;

  /// An empty folder: runs are not recorded.
  explicit RunFolder(std::string folder) : folder_(std::move(folder)) {}

  /// A name for a new recording. The oldest ones go until there is room for it. Empty if there is no folder and none
  /// can be made.
  std::string next_path(const std::string& level);

 private:
  std::string folder_;
};

}  // namespace game
