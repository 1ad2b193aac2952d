#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tests/study/limits.h"
#include "tests/study/players.h"
#include "tests/study/shard.h"

namespace study {

/// What a recommendation promises: one limit.
struct Promise {
  std::string name;  ///< error_0.01_m, median_100_us
  Limits limits;
};

/// Returns a promise for each limit that is given; without any: errors of 1 cm and 1 mm, a median of 100 µs and a 99th
/// percentile of 300 µs.
std::vector<Promise> promises_of(const Limits& limits);

/// What became of a promise in a run. That of an error is the same on every machine, because settings for it are chosen
/// by counted work; that of a cost depends on the clock.
struct PromiseRow {
  std::size_t run = 0;
  std::string level;
  std::string promise;
  std::string setting;       ///< that was recommended; empty: none
  double value = 0.0;        ///< with the other input, m, us, or work
  bool is_met = false;       ///< of a recommended setting
  std::string failure;       ///< why the setting or the run does not count; empty if it counts
  bool holds_cord = false;   ///< whether the player held a cord with the other input
  std::string level_hash{};  ///< hexadecimal, of the level's file: another one's rows say nothing of this one

  bool operator==(const PromiseRow&) const = default;
};

/// Counts recommendations.
struct Tally {
  int recommended = 0;  ///< runs with a recommended setting
  int met = 0;          ///< of these, runs in which it met the limit with the other input
  int not_found = 0;    ///< runs without a recommendation
};

/// Returns the tallies by promise and level, in the order of the rows; level "": of all levels.
std::vector<std::pair<std::string, std::vector<std::pair<std::string, Tally>>>> tallies_of(
    std::span<const PromiseRow> rows);

/// The number of runs of each level, and what is tried in each.
struct ValidationOptions {
  std::vector<Promise> promises = promises_of({});
  int runs = 100;
  int players = 1;                       ///< tried with each choice of settings; divides runs
  int ticks = 120;                       ///< of each input
  std::size_t others = judging_players;  ///< number of players, beside the first, that a setting is chosen with
  std::vector<Inputs> recorded{};        ///< by level: of another such player; without any none
  Shard shard;                           ///< of the choices for all levels, which alternate
};

using Measure =
    std::function<Study(const LevelFile&, const std::vector<engine::TickInput>& inputs, const StudyOptions& options)>;

/// Validates recommendations with random inputs in variations of the levels, in turn, and calls `add` with the rows of
/// each variation. Settings are recommended as a study does, for the worst of several players (those that meet cords,
/// and the recorded one), and measured again with `players` further players in the same variation, a run each. To
/// choose settings costs about six times as much as to try them. With one player, run k is of variation k; the first of
/// several gives the same run. `measure_level` is `measure`, or a test's substitute. Throws std::invalid_argument if
/// `players` is below 1 or does not divide `runs`.
void validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                              const std::function<void(const std::vector<PromiseRow>&, double share)>& add,
                              const Measure& measure_level);
void validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                              const std::function<void(const std::vector<PromiseRow>&, double share)>& add);

/// The rows as lines of CSV.
std::string promises_header();
std::string csv_of(const PromiseRow& row);
/// Reads the lines of one output or of several shards' outputs. Throws std::runtime_error, with the line, for another
/// file.
std::vector<PromiseRow> read_promises(const std::string& path);

}  // namespace study
