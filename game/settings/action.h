#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace game {

/// What a key, mouse button or gamepad button can be bound to.
enum class Action : std::uint8_t {
  left,
  right,
  up,
  down,
  jump,
  grab,
  throw_line,
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
  mute,
  fullscreen,
  film,
  screenshot,
};
inline constexpr std::size_t action_count = static_cast<std::size_t>(Action::screenshot) + 1;

/// `throw_line`: how a settings file names it.
std::string_view action_name(Action action);
/// "Throw a line": how the player reads it.
std::string_view action_title(Action action);
/// The bit of engine::TickInput::buttons, or 0 for what does not steer the player.
std::uint16_t button_of(Action action);

/// All of them, in their order.
std::span<const Action> all_actions();

}  // namespace game
