#pragma once

#include <string>
#include <vector>

#include "game/settings/settings.h"

namespace game {

/// What keys, or a gamepad's buttons, do in a run, a line each.
std::vector<std::string> help_lines(const Settings& settings, bool pad);

/// What a level teaches: the name of an action in braces, as in "hold {grab}", is put in the words of its first key.
/// Braces around anything else stay.
std::string hint_in_words(const std::string& hint, const Settings& settings, bool pad);

}  // namespace game
