#pragma once

#include <string>
#include <vector>

#include "game/settings.h"

namespace game {

/// What keys, or a gamepad's buttons, do in a run, a line each.
std::vector<std::string> help_lines(const Settings& settings, bool pad);

}  // namespace game
