#include "game/screens/rebinding.h"

#include "engine/window/input_names.h"
#include "game/words/words.h"

namespace game {

using engine::InputCode;
using engine::Key;
using engine::WindowInput;

namespace {

template <typename Code>
std::optional<InputCode> first_pressed(const WindowInput& input, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    if (input.pressed(static_cast<Code>(k))) return static_cast<Code>(k);
  }
  return std::nullopt;
}

}  // namespace

std::optional<InputCode> pressed_code(const WindowInput& input) {
  // The last keys are the sides of Shift and Ctrl, which are pressed together with these.
  if (const auto key = first_pressed<Key>(input, static_cast<std::size_t>(Key::left_shift))) return key;
  if (const auto button = first_pressed<engine::MouseButton>(input, engine::mouse_button_count)) return button;
  if (const auto turn = first_pressed<engine::WheelTurn>(input, engine::wheel_turn_count)) return turn;
  return first_pressed<engine::PadButton>(input, engine::pad_button_count);
}

bool Rebinding::take(const WindowInput& input, Bindings& bindings) {
  if (input.pressed(Key::escape) || input.pressed(engine::PadButton::start)) return true;
  const auto code = pressed_code(input);
  if (!code) return false;
  const auto owner = bindings.action_of(*code);
  if (owner == action_) {
    bindings.unbind(*code);
    return true;
  }
  if (owner && contested_ != code) {
    contested_ = code;
    return false;
  }
  bindings.bind(action_, *code);
  return true;
}

std::string Rebinding::prompt(const Bindings& bindings) const {
  const std::string_view action = action_title(action_);
  const auto owner = contested_ ? bindings.action_of(*contested_) : std::nullopt;
  if (!owner) return words::filled(words::press_a_key, {{"action", action}});
  return words::filled(
      words::key_is_taken,
      {{"key", engine::input_title(*contested_)}, {"owner", action_title(*owner)}, {"action", action}});
}

}  // namespace game
