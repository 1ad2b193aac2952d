#include "engine/window_input.h"

namespace engine {

void InputState::key_down(Key key) {
  const auto i = static_cast<std::size_t>(key);
  if (input_.keys_held[i]) return;
  input_.keys_held.set(i);
  input_.keys_pressed.set(i);
}

void InputState::key_up(Key key) {
  const auto i = static_cast<std::size_t>(key);
  if (!input_.keys_held[i]) return;
  input_.keys_held.reset(i);
  input_.keys_released.set(i);
}

void InputState::button_down(MouseButton button) {
  const auto i = static_cast<std::size_t>(button);
  if (input_.buttons_held[i]) return;
  input_.buttons_held.set(i);
  input_.buttons_pressed.set(i);
}

void InputState::button_up(MouseButton button) {
  const auto i = static_cast<std::size_t>(button);
  if (!input_.buttons_held[i]) return;
  input_.buttons_held.reset(i);
  input_.buttons_released.set(i);
}

void InputState::focus_lost() {
  input_.keys_released |= input_.keys_held;
  input_.keys_held.reset();
  input_.buttons_released |= input_.buttons_held;
  input_.buttons_held.reset();
}

WindowInput InputState::take() {
  const WindowInput taken = input_;
  input_.quit = false;
  input_.keys_pressed.reset();
  input_.keys_released.reset();
  input_.buttons_pressed.reset();
  input_.buttons_released.reset();
  return taken;
}

}  // namespace engine
