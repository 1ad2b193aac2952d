#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tests/extremes/any_scene/generate.h"
#include "tests/extremes/any_scene/play.h"

namespace any_scene {

/// A run in one line.
struct Summary {
  Which which;
  Preset preset = Preset::balanced;
  End end = End::whole;
  int ticks = 0;         ///< that were played
  int points = 0;        ///< of all cords
  int unconverged = 0;   ///< substeps in all
  int max_work = 0;      ///< in a tick
  long total_work = 0;   ///< in all
  double stretch = 0.0;  ///< the greatest, as those below: see Sample
  double strain = 0.0;
  double speed = 0.0;
  double gain = 0.0;
  double rise = 0.0;
  double gap = 0.0;          ///< of bodies that Box2D has not pushed,
  double gap_pressed = 0.0;  ///< and of those that it has
  double penetration = 0.0;
  int crossings = 0;          ///< of cords with cords, in all,
  int crossings_fixed = 0;    ///< with static solids,
  int crossings_moving = 0;   ///< with others,
  int crossings_pressed = 0;  ///< and with others that Box2D was pushing
  int inverted = 0;           ///< in all
  double worst_ms = 0.0;      ///< of a tick
  double seconds = 0.0;       ///< of Coupling::step in all
  int worst_tick = 0;         ///< that of max_work
  int first_bad = -1;  ///< the first tick with an unconverged substep, a crossing, an inversion or no finite number
  std::map<int, int> work;  ///< how many ticks took so many Newton steps
  /// The number of unconverged ticks, by bin_of their residual [m]. No value if the solver did not report it.
  std::optional<std::map<int, int>> left = std::map<int, int>();
};

/// The bin of a value above 0, four for each power of ten,
int bin_of(double value);
/// and the greatest value in it.
double end_of_bin(int bin);

Summary sum_up(const Which& which, const Scene& scene, const Outcome& outcome);
int all_crossings(const Summary& summary);
/// The columns of a line of CSV, by name.
std::string csv_header();
/// The same runs have the same lines but for the times.
std::string to_csv(const Summary& summary);
/// Throws std::invalid_argument for text that is not from to_csv. The last column may be missing: an older solver did
/// not report residuals.
Summary from_csv(std::string_view line);

}  // namespace any_scene
