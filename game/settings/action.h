#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace game {

/// The actions to which keys, mouse buttons and gamepad buttons can be bound.
enum class Action : std::uint8_t {
  left,
  right,
  up,
  down,
  jump,
  grab,
  throw_line,
  throw_second,
  tie,
  cut,
  reel_in,
  reel_out,
  retry,
  restart,
  pause,
  step,
  slow_motion,
  help,
  debug_view,
  panel,
  palette,
  mute,
  fullscreen,
  film,
  screenshot,
};
inline constexpr std::size_t action_count = static_cast<std::size_t>(Action::screenshot) + 1;

/// Returns the name in settings files: `throw_line`.
std::string_view action_name(Action action);
/// Returns the name for the player: "Throw a line".
std::string_view action_title(Action action);
/// Returns the bit of engine::TickInput::buttons, or 0 if the action is not an input of the simulation.
std::uint16_t button_of(Action action);

/// Returns all actions in order.
std::span<const Action> all_actions();

}  // namespace game
