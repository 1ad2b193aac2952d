#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// Saved measurements, so that an interrupted study can continue: a line of JSON per setting in results.jsonl of a
/// folder, and a file per converged run. Results of another level, replay, grid or program are not used.
class Results {
 public:
  /// Creates the folder. Without a folder, saves nothing. Throws std::runtime_error if it cannot be written.
  Results(const std::string& folder, std::uint64_t level_hash, const std::string& replay_path, bool quick);

  /// Returns null if it is not yet known.
  const Measured* find(const Setting& setting) const;
  void add(const Measured& measured);

  /// Returns the run with that name; none if it is not yet known.
  std::optional<Trace> run(const std::string& name) const;
  /// Throws std::runtime_error if it cannot be written; what was saved before stays.
  void add_run(const std::string& name, const Trace& trace);

 private:
  std::string path_of_run(const std::string& name) const;

  std::string folder_;
  std::string level_;  // its hash and that of the replay: a folder may have the runs of several
  std::string key_;
  std::vector<Measured> known_;
  std::ofstream out_;
};

}  // namespace study
