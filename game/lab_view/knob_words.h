#pragma once

#include <string>

#include "game/lab/scene.h"

namespace game::lab {

/// Returns the name of a knob of a scene, and its value, for the player.
/// @{
const char* name_of(const Scene& scene, Knob knob);
std::string value_in_words(Knob knob, double value);
/// @}

}  // namespace game::lab
