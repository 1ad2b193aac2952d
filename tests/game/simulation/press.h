#pragma once

#include <cstdint>

#include "engine/tick/input.h"

namespace game {

/// Returns the input of a tick with these buttons (game/simulation/buttons.h).
inline engine::TickInput press(int buttons) {
  engine::TickInput input;
  input.buttons = static_cast<std::uint16_t>(buttons);
  return input;
}

}  // namespace game
