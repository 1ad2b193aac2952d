#pragma once

#include <optional>
#include <vector>

#include "tests/study/level_study.h"

namespace study {

/// Returns what a search by cord starts from: the common setting with the least counted work within the error [m], and
/// all that are cheaper. (The present one is none: it may be another one for each cord.) None without such a setting,
/// with one cord, or if the cheapest setting has more than 1 / 1.2 of its work.
std::optional<CordSearch> search_of(const Study& study, double max_error_m, std::vector<int> cords);

/// Returns the least work of a setting within the error [m], the present one too; infinity without one.
double least_work_within(const Study& study, double max_error_m);

}  // namespace study
