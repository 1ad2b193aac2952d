#pragma once

#include <optional>
#include <string>
#include <vector>

namespace study {

/// What tradeoff is asked about a level.
struct Command {
  std::string level;
  std::vector<std::string> levels;  ///< of promises; empty: all that the assets folder has
  std::string replay;               ///< empty: the one of the level's name in the assets folder
  std::string folder;               ///< of the report; empty: none is written
  bool quick = false;
  bool terms = false;
  bool apply = false;
  std::optional<double> max_error_m;
  std::optional<double> budget_us;
  std::optional<int> promises;  ///< tries of whether recommendations keep their word
  int repeats = 9;
};

/// Does it, and prints what comes of it. The program's exit status: 0; 1 if nothing in the grid keeps what was asked
/// for, or if it was interrupted. Throws engine::MapError, engine::ReplayError or std::runtime_error for what cannot be
/// read, built or written.
int run(const Command& command);

}  // namespace study
