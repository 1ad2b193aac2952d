#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "tests/extremes/any_scene/generate.h"
#include "tests/extremes/any_scene/play.h"

namespace any_scene {

/// The result of a run, one line of CSV.
struct Summary {
  SceneId which;
  Preset preset = Preset::balanced;
  End end = End::completed;
  int ticks = 0;         ///< number of ticks played
  int points = 0;        ///< of all cords
  int unconverged = 0;   ///< substeps, total
  int max_work = 0;      ///< per tick
  long total_work = 0;   ///< over all ticks
  double stretch = 0.0;  ///< greatest; this and the following are as in Sample
  double strain = 0.0;
  double speed = 0.0;
  double gain = 0.0;
  double rise = 0.0;
  double gap = 0.0;          ///< of bodies that Box2D has not pushed
  double gap_pressed = 0.0;  ///< of bodies that Box2D has pushed
  double penetration = 0.0;
  int crossings = 0;          ///< of cords with cords, total
  int crossings_fixed = 0;    ///< with static solids
  int crossings_moving = 0;   ///< with other solids
  int crossings_pressed = 0;  ///< with other solids while Box2D pushed them
  int inverted = 0;           ///< total
  double worst_ms = 0.0;      ///< the longest tick
  double seconds = 0.0;       ///< total of Coupling::step
  int worst_tick = 0;         ///< the tick of max_work
  int hanging = 0;            ///< most ticks one behind the other that hang, see Sample
  int late_unconverged = 0;   ///< this and the next four: of the late ticks, see Sample
  double late_left = 0.0;     ///< m
  double late_stretch = 0.0;
  double late_gap = 0.0;  ///< m
  double late_gain = 0.0;
  int first_bad = -1;  ///< the first tick with an unconverged substep, a crossing, an inversion or a number not finite
  std::map<int, int> work;  ///< number of ticks by Newton steps
  /// The number of unconverged ticks, by bin_of their residual [m]. No value if the solver did not report it.
  std::optional<std::map<int, int>> left = std::map<int, int>();
};

/// Returns the bin of a value above 0; there are four for each power of ten.
int bin_of(double value);
/// Returns the greatest value of a bin.
double end_of_bin(int bin);

Summary sum_up(const SceneId& which, const Scene& scene, const Outcome& outcome);
int all_crossings(const Summary& summary);
/// Returns the header of the CSV.
std::string csv_header();
/// Returns a line of CSV. Equal runs give equal lines except for times.
std::string to_csv(const Summary& summary);
/// Parses a line of to_csv. Throws std::invalid_argument for other text. The last column may be missing: an older
/// solver did not report residuals.
Summary from_csv(std::string_view line);

}  // namespace any_scene
