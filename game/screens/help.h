#pragma once

#include <string>
#include <vector>

#include "game/settings/settings.h"
#include "game/simulation/level.h"

namespace game {

/// Returns a line for each action that has a key, or a button of a gamepad.
std::vector<std::string> help_lines(const Settings& settings, bool pad);

/// The same in a level for two: the keys of the first player, and behind them those of the second.
std::vector<std::string> help_lines_for_two(const Settings& settings, bool pad);

/// Returns the line that names the key for these lines; none for a gamepad, which has no such button.
std::vector<std::string> help_line(const Settings& settings, bool pad);

/// Returns the signs of a level with the keys that they name.
std::vector<std::string> signs_in_words(const Level& level, const Settings& settings, bool pad);

/// Returns how a hint names an action: "{grab}".
std::string name_in_braces(Action action);

/// Returns the hint or a sign of a level with names of actions in braces, as in "hold {grab}", replaced by their first
/// key. Other braces stay. A text that names keys of the second player, as in "{grab_2}", is of a level for two, where
/// each player has its half of the keyboard.
std::string hint_in_words(const std::string& hint, const Settings& settings, bool pad);

}  // namespace game
