#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// A table by family and preset, a line for each family and one for all of a preset.
void print_table(const std::vector<Summary>& runs);
/// The least number of at least `share` of the ticks.
int quantile_of_ticks(const std::map<int, int>& ticks, double share);
/// The greatest number of Newton steps in the bin of a histogram that holds so many: one by one up to 8, then by a
/// quarter.
int end_of_work_bin(int work);
/// How many ticks took how many Newton steps, with bars.
void print_histogram(const std::vector<Summary>& runs);
/// Of a scene, tick by tick.
void print_ticks(const Outcome& outcome);

}  // namespace any_scene
