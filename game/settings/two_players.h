#pragma once

#include "engine/window/window_input.h"
#include "game/settings/bindings.h"
#include "game/settings/settings.h"

namespace game {

/// Returns the bindings of a player, 0 or 1, in a level for two, where each has a half of the keyboard and a gamepad.
/// The first player has its usual keys without those of the second one, and the mouse. Shift and ctrl are the left ones
/// for the first player, the right ones for the second. Both have the same buttons on their gamepads.
Bindings bindings_of(int player, const Settings& settings);

/// Returns the input of that player: its gamepad is the first or the second one.
engine::WindowInput input_of(int player, const engine::WindowInput& input);

}  // namespace game
