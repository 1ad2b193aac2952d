#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/study/limits.h"
#include "tests/study/shard.h"

namespace study {

/// The options of tradeoff for a level.
struct Command {
  std::string level;
  std::vector<std::string> levels;  ///< for validation and --by-cord; empty: all levels in the assets folder
  std::string replay;               ///< empty: that of the level in the assets folder
  std::string folder;               ///< for the report; empty: no report
  bool quick = false;
  bool terms = false;
  bool by_cord = false;  ///< recommend settings by cord, too
  bool apply = false;
  Limits limits;
  std::optional<int> validation_runs;  ///< number of runs of each level that verify recommendations
  int validation_players = 1;          ///< number of players that each recommendation is tried with
  std::optional<int> repeats;          ///< of the timed runs; none: 9, and 3 of a quick study
  bool csv = false;                    ///< of a validation: print its rows
  Shard shard;                         ///< of a validation, or of --by-cord for several levels
};

/// Returns the recorded input of a level: the command's, or that of the level in the assets folder. Throws
/// std::runtime_error if there is none.
std::string replay_of(const Command& command, const LevelFile& file);

/// Prints how many promises were kept, from a file of a validation's rows. Returns the exit status.
int summarise_promises(const std::string& path);

/// Prints for each level, those of the command or all of the game, how many times less work than one setting for all
/// cords settings by cord need, and at most could (see CordBound), for the command's error, 1 cm without one. Returns
/// the exit status.
int print_by_cord(const Command& command);

/// Runs the command and prints its results. Returns the exit status: 0; 1 if no setting in the grid meets the request,
/// or if it was interrupted. Throws engine::MapError, engine::ReplayError or std::runtime_error for what cannot be
/// read, built or written.
int run(const Command& command);

}  // namespace study
