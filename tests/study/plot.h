#pragma once

#include <span>
#include <string>

#include "tests/study/frontier.h"

namespace study {

/// Returns the gnuplot commands for NAME.svg: the points' errors against their costs, their front, and failures at the
/// top, one plot per group. NaN is not drawn.
std::string plot_of(std::span<const Point> points, const std::string& axis, const std::string& name);

/// Runs gnuplot with NAME.gp in a folder. Returns false on failure; then the folder has gnuplot.log.
bool draw(const std::string& folder, const std::string& name);

}  // namespace study
