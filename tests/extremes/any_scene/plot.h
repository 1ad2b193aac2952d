#pragma once

#include <string>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// Returns a gnuplot script that writes an SVG to `path`. It shows by preset the shares of ticks by number of linear
/// systems and by residual, and the shares of scenes by the greatest stretch of their inextensible ropes. Runs of an
/// earlier solver, if any, are in grey behind.
std::string plot_of(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path);

/// Runs gnuplot on that script. Throws std::runtime_error if gnuplot fails.
void draw(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path);

}  // namespace any_scene
