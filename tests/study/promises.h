#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// How often what was recommended kept its word.
struct Tally {
  int found = 0;  ///< tries in which there was a setting to recommend
  int kept = 0;   ///< of these
  int none = 0;   ///< tries in which there was none
};

struct Promises {
  Tally error;
  Tally budget;
  int held = 0;                     ///< tries in which the other player held a cord
  std::vector<std::string> broken;  ///< each, in words
};

/// What is promised, and how often that is tried.
struct PromiseOptions {
  double max_error_m = 1e-2;
  double budget_us = 100.0;
  int tries = 100;
  int ticks = 120;  ///< that each player plays
};

using Measure =
    std::function<Study(const LevelFile&, const std::vector<engine::TickInput>& inputs, const StudyOptions& options)>;

/// Random players in variations of the levels, which take turns: settings are chosen on the input of one player for the
/// error and for the budget, and measured anew on the input of another in the same variation. One that fails there has
/// not kept its word, whatever its error and cost. `measure_level` is `measure`, or a test's own.
Promises try_promises(std::span<const LevelFile> levels, const PromiseOptions& options,
                      const std::function<void(double)>& progress, const Measure& measure_level);
Promises try_promises(std::span<const LevelFile> levels, const PromiseOptions& options,
                      const std::function<void(double)>& progress);

/// The buttons of somebody who presses them at random for so many ticks; the same for the same seed.
std::vector<engine::TickInput> random_inputs(unsigned seed, int ticks);

}  // namespace study
