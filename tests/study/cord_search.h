#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// Returns what a search by cord starts from: the common setting with the least counted work within the error [m], and
/// all that are cheaper. (The present one is none: it may be another one for each cord.) None without such a setting,
/// with one cord, or if the cheapest setting has more than 1 / 1.2 of its work.
std::optional<CordSearch> search_of(const Study& study, double max_error_m, std::vector<int> cords);

/// How much settings by cord can save at most in a level.
struct CordBound {
  std::string common{};              ///< the common setting that a search starts from; empty: none is within the error
  double common_work = unavailable;  ///< mean over the ticks
  /// That no assignment is below: CordSearchResult::least_work if there was a search, but at least that of the cheapest
  /// setting for all that does not fail, whatever its error.
  double least_work = unavailable;
  /// How many times less work than the common setting: 1 with fewer than two cords; NaN without a common setting.
  double most_gain = unavailable;
};

/// Returns the bound for an error [m].
CordBound bound_of(const Study& study, double max_error_m, std::size_t cords);

/// Returns the least work of a setting within the error [m], the present one too; infinity without one.
double least_work_within(const Study& study, double max_error_m);

}  // namespace study
