#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/study/level_study.h"
#include "tests/study/shard.h"

namespace study {

/// What a level costs and how exact it is with its own settings, as a file of accepted rows says.
struct GuardRow {
  std::string level;   ///< a name, or a .tmj file, as --level
  std::string replay;  ///< its recorded input; empty: that of the level in the assets
  std::size_t ticks = 0;
  std::int64_t work = 0;       ///< counted work of all ticks
  std::int64_t most_work = 0;  ///< of the greatest tick
  double error_m = 0.0;
  double work_margin = 5.0;    ///< accepted increase of both kinds of work, %
  double error_margin = 20.0;  ///< accepted increase of the error, %; differences below 0.01 mm are always accepted
  std::string failure;         ///< why the run does not count; empty if it counts

  bool operator==(const GuardRow&) const = default;
};

/// Returns what is worse than the accepted row by more than its margins, a sentence each.
std::vector<std::string> worse(const GuardRow& accepted, const GuardRow& measured);

/// Throws std::runtime_error for a file that write_guard has not written, with its line and what is accepted.
std::vector<GuardRow> read_guard(const std::string& path);
/// Throws std::runtime_error if it cannot be written.
void write_guard(const std::string& path, const std::vector<GuardRow>& rows);

/// Returns the row of a study of the present setting, with the default margins.
GuardRow guard_row_of(const Study& study);

/// The options --check and --accept.
struct Guard {
  std::string file;
  std::vector<std::string> levels;  ///< empty: those of the file
  std::string replay;               ///< of one level
  Shard shard{};                    ///< of these levels; only to check
};

/// Measures the levels and prints what is worse than the file says. Returns 1 if anything is.
int check(const Guard& guard);
/// Measures the levels and writes their rows to the file; rows of other levels, and margins, stay.
int accept(const Guard& guard);

}  // namespace study
