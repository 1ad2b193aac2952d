#pragma once

#include <string>
#include <vector>

#include "tests/study/level_study.h"
#include "tests/study/limits.h"
#include "tests/study/report.h"
#include "tests/study/terms.h"

namespace study {

/// What the page of a level says before its numbers.
struct Advice {
  Limits limits;                 ///< without one: an error of 1 cm
  const Terms* terms = nullptr;  ///< of its cords; null: not tried
};

/// Returns the report of a level's study.
Report report_of(const Study& study, const LevelFile& file, const Advice& advice);

/// Returns sentences on the terms that the cords need, do not need and may lack.
std::vector<std::string> findings_of(const Terms& terms);

}  // namespace study
