#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/study/dials.h"
#include "tests/study/frontier.h"
#include "tests/study/level_file.h"
#include "tests/study/statistics.h"
#include "tests/study/trace.h"
#include "tests/study/windows.h"

namespace study {

/// A setting of the grid, as measured.
struct Measured {
  Dials dials;
  Errors error;             ///< of time and solver: against the converged motion of the same points
  Errors mesh;              ///< of the points: of that motion against the converged one of four times as many links
  Statistics later;         ///< after what is compared: how far from the converged motion's
  double known_to_m = 0.0;  ///< below which the error is not known
  WindowErrors windows;     ///< of time and solver, in windows of the level as it is; of its own cords only
  double windows_known_to_m = 0.0;
  ribbon::CordReport work;
  int contacts = 0;
  int unconverged_ticks = 0;
  std::string failure;
  double cost_us = 0.0;
  double p99_us = 0.0;

  Point point() const;
};

/// What the converged runs of a level say.
struct Reference {
  Mesh mesh;
  std::size_t ticks = 0;      ///< in which 1e-10 m do not grow to 1 cm, nor the runs differ by 0.1 mm; or all
  double agreement_m = 0.0;   ///< of two converged runs of different substeps in them
  Statistics later;           ///< of these two after them: how far apart
  int unconverged_ticks = 0;  ///< of the one that others are compared with
};

struct Study {
  std::string level;
  std::string replay;
  std::size_t ticks = 0;
  std::vector<Reference> references;
  std::size_t windows = 0;
  WindowErrors agreement;         ///< of the references of windows
  double compared_cords = 0.0;    ///< of all windows' ticks, in which these are compared,
  double compared_players = 0.0;  ///< and these
  std::vector<Measured> settings;
  int runs = 0;           ///< of the level, to find errors: those that the folder knew were not run again
  std::string no_chains;  ///< why none of Box2D's chains are among them; empty if they are
  bool complete = false;  ///< false if it was interrupted

  std::vector<Point> points() const;
};

struct StudyOptions {
  bool quick = false;
  int repeats = 9;
  std::vector<Dials> grid;                       ///< settings to measure in place of those by `quick`, without meshes
  std::string folder;                            ///< for saved results; empty: none
  std::function<bool()> stopped;                 ///< called between runs
  std::function<void(double, double)> progress;  ///< the share done, and the seconds that are left
};

/// Measures a level and its recorded input over the grid. Continues what the folder holds of the same level, replay,
/// grid and program. Throws engine::ReplayError for a replay that is none, has no ticks or is of another level.
Study measure(const LevelFile& file, const std::string& replay_path, const StudyOptions& options);

/// The same for inputs that were not recorded; no results are saved.
Study measure(const LevelFile& file, const std::vector<engine::TickInput>& inputs, const StudyOptions& options);

/// Why a run does not count, in words: it blew up, let something through that its reference did not (see let_through),
/// or did not converge in all ticks; empty if it does.
std::string failure_of(const Trace& run, const Trace& reference, std::size_t ticks);

/// The settings that a level's own cords can have, by the greater of their errors from the start and in windows: those
/// of other solvers and meshes stand apart, for they would be other cords.
std::vector<Point> applicable(const Study& study);

}  // namespace study
