#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/by_cord.h"
#include "tests/study/film.h"
#include "tests/study/frontier.h"
#include "tests/study/level_file.h"
#include "tests/study/players.h"
#include "tests/study/reference.h"
#include "tests/study/setting.h"
#include "tests/study/statistics.h"
#include "tests/study/trace.h"
#include "tests/study/windows.h"

namespace study {

/// The counted work of the cords in the ticks of a run, by IslandReport::work: the same on every machine.
struct WorkFigures {
  double mean = unavailable;
  double p99 = unavailable;
  double most = unavailable;
};

/// Returns the figures of all ticks; NaN without ticks.
WorkFigures figures_of(std::span<const std::int64_t> tick_work);

/// The worst that a setting does with other players.
struct WithOthers {
  double error_m = unavailable;  ///< of time and solver: from the start and in windows, not below its resolution
  WorkFigures work;              ///< of each figure the largest
  std::string failure{};         ///< why the setting does not count; empty if it counts
  bool spends_budget = false;    ///< with some player a tick spent its budget of work
};

/// The measurement of a setting of the grid.
struct Measured {
  Setting setting;
  Errors error;        ///< of time and solver: relative to the converged motion of the same points
  Errors mesh;         ///< of the mesh: of that motion relative to the converged one with four times as many links
  Statistics chaotic;  ///< after the compared ticks: difference from the converged motion
  double resolution_m = 0.0;  ///< smaller errors are unknown
  WindowErrors windows;       ///< of time and solver, in windows; only for the level's own cords
  double windows_resolution_m = 0.0;
  ribbon::IslandReport work;
  WorkFigures tick_work;  ///< only of the direct solver
  WithOthers others;      ///< only for the level's own cords of the direct solver
  int contacts = 0;
  int unconverged_ticks = 0;
  std::string failure;
  double cost_us = 0.0;   ///< mean of the ticks, median of the repeats
  double least_us = 0.0;  ///< mean of the ticks, with their rest, least of the repeats
  double p99_us = 0.0;
  double most_us = 0.0;  ///< the most expensive tick; of each tick the median over the repeats

  Point point() const;
};

struct Study {
  std::string level;
  std::string replay;
  std::size_t ticks = 0;
  std::vector<Reference> references;
  std::size_t others = 0;  ///< number of other players
  std::size_t windows = 0;
  WindowErrors agreement;         ///< difference of the two references in windows
  double compared_cords = 0.0;    ///< share of the windows' ticks in which cords are compared
  double compared_players = 0.0;  ///< share of the windows' ticks in which players are compared
  std::vector<Measured> settings;
  int runs = 0;                   ///< number of runs for errors, without those that were saved in the folder
  std::string no_chains_reason;   ///< why chains of Box2D are missing; empty if they are present
  Stage stage;                    ///< of the films, if the options ask for them
  std::string converged_film;     ///< of the level's own points and rows
  std::vector<Film> films;        ///< by setting; empty ones for other points and rows
  std::optional<ByCord> by_cord;  ///< if the options ask for it, and it is cheaper than one setting for all cords
  double least_work_by_cord = unavailable;  ///< CordSearchResult::least_work of the search; NaN without one
  std::vector<std::string> left_out;        ///< a sentence for each other setting that the level cannot have
  bool complete = false;                    ///< false if it was interrupted

  std::vector<Point> points() const;
};

struct StudyOptions {
  bool quick = false;
  int repeats = 9;
  std::vector<Setting> grid;     ///< settings to measure in place of those by `quick`, without meshes
  bool ample_budgets = true;     ///< measure a setting that spends its budget again, with ample_work, after all others
  bool films = false;            ///< make films of the settings
  std::size_t windows = 0;       ///< number of windows, at most; 0: by `quick`
  std::vector<Inputs> others{};  ///< other players: a setting must do with each of them
  std::optional<double> by_cord_error_m{};         ///< m; find settings by cord for that error, too
  std::string folder;                              ///< for saved results; empty: none
  std::function<bool()> stopped;                   ///< called between runs
  std::function<void(double, double)> progress;    ///< called with the share done and the remaining seconds
  std::function<void(double)> by_cord_progress{};  ///< called with the share done of the search by cord
};

/// Measures a level and its recorded input over the grid. Continues saved results of the same level, replay, grid and
/// program. Throws engine::ReplayError for a file that is not a replay, has no ticks or is of another level, and
/// engine::MapError if no cord exists in any tick.
Study measure(const LevelFile& file, const std::string& replay_path, const StudyOptions& options);

/// The same for inputs that were not recorded; no results are saved.
Study measure(const LevelFile& file, const std::vector<engine::TickInput>& inputs, const StudyOptions& options);

/// Returns the largest figures of a setting: of the recording, and with other players.
WorkFigures largest_work(const Measured& measured);

/// Returns whether a tick of a setting spent its budget of work: of the recording, in a window, or with another player.
bool spends_budget(const Measured& measured);

/// Returns the accuracy in windows; none: each cord's own.
std::optional<ribbon::Accuracy> window_accuracy_of(const Setting& setting);

/// Returns the settings of a level's own cords, by the largest of their errors: from the start, in windows, with other
/// players. Those of other solvers and meshes are separate, because they are other cords.
std::vector<Point> applicable(const Study& study);

}  // namespace study
