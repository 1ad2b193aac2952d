#pragma once

#include <string>
#include <vector>

#include "tests/extremes/any_scene/summary.h"

namespace any_scene {

/// What gnuplot draws from, by preset: the shares of ticks by the linear systems that they took and by what was left
/// unsolved, and of scenes by the greatest stretch of their inextensible ropes; those of another solver, if there are
/// any, in grey behind. It writes an SVG to `path`.
std::string plot_of(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path);

/// Has gnuplot draw that. Throws std::runtime_error if it could not.
void draw(const std::vector<Summary>& runs, const std::vector<Summary>& before, const std::string& path);

}  // namespace any_scene
