#pragma once

#include <optional>
#include <string_view>

#include "engine/window/window_input.h"

namespace engine {

/// Returns the unique name of an input in files: `key_a`, `mouse_left`, `wheel_up`, `pad_dpad_left`.
std::string_view input_name(const InputCode& code);
/// Returns the input with that name; nothing if there is none.
std::optional<InputCode> input_of_name(std::string_view name);
/// Returns the name of an input for the player: `A`, `Left mouse`, `Wheel up`, `D-pad ←`.
std::string_view input_title(const InputCode& code);

}  // namespace engine
