#pragma once

#include <string>

#include "game/lab/knobs.h"

namespace game::lab {

/// Return the name of a knob, and its value, for the player.
/// @{
const char* name_of(Knob knob);
std::string value_in_words(Knob knob, double value);
/// @}

}  // namespace game::lab
