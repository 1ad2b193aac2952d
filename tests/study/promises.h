#pragma once

#include <functional>

#include "tests/study/level_study.h"

namespace study {

/// How often what was recommended kept its word.
struct Promises {
  int error_tries = 0;  ///< in which a setting was found for the error
  int errors_kept = 0;
  int budget_tries = 0;
  int budgets_kept = 0;
};

/// Random players in a level, `tries` times: settings are chosen on the input of one for `max_error` [m] and for
/// `budget_us`, and measured anew on the input of another.
Promises try_promises(const LevelFile& file, double max_error, double budget_us, int tries,
                      const std::function<void(double)>& progress);

/// The buttons of somebody who presses them at random for so many ticks; the same for the same seed.
std::vector<engine::TickInput> random_inputs(unsigned seed, int ticks);

}  // namespace study
