#pragma once

#include <functional>
#include <string>
#include <vector>

#include "game/simulation/verified_time.h"

namespace game {

/// The recordings (*.replay) of a folder, each of them verified.
struct RunTable {
  struct Row {
    std::string file;  ///< name in the folder
    VerifiedTime time;
  };
  std::vector<Row> rows;  ///< the true ones by level, place and name, then the others by name
  int other_files = 0;    ///< files in the folder with other names

  /// Returns the lines of the table: for each level the places, then the recordings that are not true.
  std::string text() const;
  bool all_are_true() const;
};

/// Verifies all recordings of a folder, without those of its subfolders. `report` is called with the share that is
/// done, 0 … 1. Throws std::runtime_error if the folder cannot be read.
RunTable table_of(const std::string& folder, const std::function<void(double share)>& report = {});

/// Prints the table of a folder, with a progress bar if the error stream is a terminal. Returns the exit status: 0 if
/// all recordings are true, else 1. Throws like table_of.
int print_table(const std::string& folder);

}  // namespace game
