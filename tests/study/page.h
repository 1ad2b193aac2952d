#pragma once

#include <string>

#include "tests/study/report.h"

namespace study {

/// Returns text for HTML.
std::string escaped(const std::string& text);

/// Returns the page of a report, one file without references to others: the recommendation, the plot of error against
/// cost, which shows a setting at the pointer and plays its film at a click, the findings and the failures, and,
/// folded, `method`, HTML of everything else.
std::string page_of(const Report& report, const std::string& method);

/// The style and the script of the page.
extern const char* const page_style;
extern const char* const page_script;

}  // namespace study
