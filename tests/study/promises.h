#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// Counts recommendations.
struct Tally {
  int found = 0;  ///< tries with a recommended setting
  int kept = 0;   ///< of these, tries in which it was met
  int none = 0;   ///< tries without a recommendation
};

struct Promises {
  Tally error;
  Tally budget;
  int held = 0;                     ///< tries in which the other player held a cord
  std::vector<std::string> broken;  ///< a sentence for each
};

/// The promised limits, and the number of tries.
struct PromiseOptions {
  double max_error_m = 1e-2;
  double budget_us = 100.0;
  int tries = 100;
  int ticks = 120;  ///< of each player
};

using Measure =
    std::function<Study(const LevelFile&, const std::vector<engine::TickInput>& inputs, const StudyOptions& options)>;

/// Tries random players in variations of the levels, in turn. Settings are chosen with the input of one player, for the
/// error and for the budget, and measured again with the input of another player in the same variation. A setting that
/// fails there counts as broken, for any error and cost. `measure_level` is `measure`, or a test's substitute.
Promises try_promises(std::span<const LevelFile> levels, const PromiseOptions& options,
                      const std::function<void(double)>& progress, const Measure& measure_level);
Promises try_promises(std::span<const LevelFile> levels, const PromiseOptions& options,
                      const std::function<void(double)>& progress);

/// Returns random buttons for a number of ticks; the same for the same seed.
std::vector<engine::TickInput> random_inputs(unsigned seed, int ticks);

}  // namespace study
