#pragma once

#include <string>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// A table by family and preset, a line for each family and one for all of a preset.
void print_table(const std::vector<Summary>& runs);
/// How many ticks took how many Newton steps, with bars.
void print_histogram(const std::vector<Summary>& runs);
/// Of a scene, tick by tick.
void print_ticks(const Outcome& outcome);

}  // namespace any_scene
