#include "game/settings/two_players.h"

#include <variant>

namespace game {
namespace {

using engine::InputCode;
using engine::Key;

/// Returns the key of the player's side of the keyboard, if there are two.
InputCode on_side_of(int player, const InputCode& code) {
  if (code == InputCode(Key::shift)) return player == 0 ? Key::left_shift : Key::right_shift;
  if (code == InputCode(Key::ctrl)) return player == 0 ? Key::left_ctrl : Key::right_ctrl;
  return code;
}

bool is_of_pad(const InputCode& code) { return std::holds_alternative<engine::PadButton>(code); }

}  // namespace

Bindings bindings_of(int player, const Settings& settings) {
  Bindings own;
  const auto bind = [&own, player](Action action, const InputCode& code) {
    own.bind(action, on_side_of(player, code));
  };
  if (player == 1) {
    for (const Action action : all_actions()) {
      for (const InputCode& code : settings.second_bindings.codes(action)) bind(action, code);
      for (const InputCode& code : settings.bindings.codes(action)) {
        if (is_of_pad(code)) bind(action, code);
      }
    }
    return own;
  }
  const Bindings second = bindings_of(1, settings);
  for (const Action action : all_actions()) {
    for (const InputCode& code : settings.bindings.codes(action)) {
      if (is_of_pad(code) || !second.action_of(on_side_of(0, code))) bind(action, code);
    }
  }
  return own;
}

engine::WindowInput input_of(int player, const engine::WindowInput& input) {
  return input.with_pad(player == 0 ? 0 : 1);
}

}  // namespace game
