#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// Prints a table with a row for each family and preset, and one for all families of a preset.
void print_table(const std::vector<Summary>& runs);
/// Returns the least number that is not exceeded in at least `share` of the ticks.
int quantile_of_ticks(const std::map<int, int>& ticks, double share);
/// Returns the upper end of the histogram bin that contains `work` Newton steps. Bins have width 1 up to 8, then grow
/// by a quarter.
int end_of_work_bin(int work);
/// Prints a histogram of ticks by Newton steps.
void print_histogram(const std::vector<Summary>& runs);
/// Prints a scene's figures, tick by tick.
void print_ticks(const Outcome& outcome);

}  // namespace any_scene
