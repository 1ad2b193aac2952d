#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// What has been measured so far, so that whoever is interrupted goes on where he was: a line of JSON a setting in
/// results.jsonl of a folder, and a file a converged run. What is of another level, replay, grid or program is not
/// used.
class Results {
 public:
  /// Makes the folder. Without one, keeps nothing. Throws std::runtime_error if it cannot be written.
  Results(const std::string& folder, std::uint64_t level_hash, const std::string& replay_path, bool quick);

  /// Null if it is not known yet.
  const Measured* find(const Dials& dials) const;
  void add(const Measured& measured);

  /// A run of that name; none if it is not known yet.
  std::optional<Trace> run(const std::string& name) const;
  /// What cannot be written is run again another time.
  void add_run(const std::string& name, const Trace& trace);

 private:
  std::string path_of_run(const std::string& name) const;

  std::string folder_;
  std::string key_;
  std::vector<Measured> known_;
  std::ofstream out_;
};

}  // namespace study
