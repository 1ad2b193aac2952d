#pragma once

#include <span>
#include <string>

#include "tests/study/frontier.h"

namespace study {

/// What gnuplot draws NAME.svg from: the points' errors against their costs, their front, and failures at the top; a
/// plot a group, beside each other. What has no number is left out.
std::string plot_of(std::span<const Point> points, const std::string& axis, const std::string& name);

/// Has gnuplot draw NAME.gp in a folder. False if it could not; then gnuplot.log is there.
bool draw(const std::string& folder, const std::string& name);

}  // namespace study
