#pragma once

#include <cstdint>

#include "engine/tick/input.h"
#include "game/simulation/simulation.h"
#include "ribbon/vec2.h"

namespace game {

/// Returns the input of a tick with these buttons (game/simulation/buttons.h) of the first and the second player.
inline engine::TickInput press(int buttons, int second = 0) {
  engine::TickInput input;
  input.buttons = static_cast<std::uint16_t>(buttons);
  input.second_buttons = static_cast<std::uint16_t>(second);
  return input;
}

inline void run(Simulation& simulation, int ticks, int buttons = 0, int second = 0) {
  for (int k = 0; k < ticks; ++k) simulation.tick(press(buttons, second));
}

/// Advances by ticks with these buttons of the first player and its pointer [m].
inline void tick(Simulation& simulation, int buttons, int ticks = 1, ribbon::Vec2 pointer = {}) {
  engine::TickInput input = press(buttons);
  engine::set_pointer(input, pointer);
  for (int k = 0; k < ticks; ++k) simulation.tick(input);
}

/// Returns the height of a player, m.
inline double height_of(const Simulation& simulation, int player) { return simulation.player(player).position().y; }

}  // namespace game
