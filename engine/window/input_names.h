#pragma once

#include <optional>
#include <string_view>

#include "engine/window/window_input.h"

namespace engine {

/// How files name what can be pressed: `key_a`, `mouse_left`, `wheel_up`, `pad_dpad_left`. Each has one name.
std::string_view input_name(const InputCode& code);
/// The other way round; none if nothing has that name.
std::optional<InputCode> input_of_name(std::string_view name);
/// How a player reads it: `A`, `Left mouse`, `Wheel up`, `Pad left`.
std::string_view input_title(const InputCode& code);

}  // namespace engine
