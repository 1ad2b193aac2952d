#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// What has been measured so far, a line of JSON a setting in results.jsonl of a folder, so that whoever is interrupted
/// goes on where he was. Lines of another level, replay or program are not used.
class Results {
 public:
  /// Makes the folder. Without one, keeps nothing. Throws std::runtime_error if it cannot be written.
  Results(const std::string& folder, std::uint64_t level_hash, const std::string& replay_path);

  /// Null if it is not known yet.
  const Measured* find(const Dials& dials) const;
  void add(const Measured& measured);

 private:
  std::string key_;
  std::vector<Measured> known_;
  std::ofstream out_;
};

}  // namespace study
