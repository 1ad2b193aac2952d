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
  int recommended = 0;  ///< runs with a recommended setting
  int met = 0;          ///< of these, runs in which it met the limit with the other input
  int not_found = 0;    ///< runs without a recommendation
};

struct Validation {
  Tally error;
  Tally budget;
  int runs_with_grip = 0;               ///< runs in which the player held a cord with the other input
  std::vector<std::string> violations;  ///< a sentence for each missed limit
};

/// The limits of error and cost, and the number of runs.
struct ValidationOptions {
  double max_error_m = 1e-2;
  double budget_us = 100.0;
  int runs = 100;
  int ticks = 120;  ///< of each input
};

using Measure =
    std::function<Study(const LevelFile&, const std::vector<engine::TickInput>& inputs, const StudyOptions& options)>;

/// Validates recommendations with random inputs in variations of the levels, in turn. Settings are recommended for one
/// input, for the error and for the budget, and measured again with another input in the same variation. A setting that
/// fails there violates both limits. `measure_level` is `measure`, or a test's substitute.
Validation validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                                    const std::function<void(double)>& progress, const Measure& measure_level);
Validation validate_recommendations(std::span<const LevelFile> levels, const ValidationOptions& options,
                                    const std::function<void(double)>& progress);

/// Returns random buttons for a number of ticks; the same for the same seed.
std::vector<engine::TickInput> random_inputs(unsigned seed, int ticks);

}  // namespace study
