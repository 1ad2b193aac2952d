#include "engine/window/window_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace engine {
namespace {

constexpr double press_threshold = 0.5;    // deflection from which a trigger or stick counts as a pressed button
constexpr double release_threshold = 0.4;  // lower than press_threshold: hysteresis
constexpr double max_notches = 20.0;       // of one event
constexpr double dead_zone = 0.2;          // a stick at rest is not exactly in its middle

double beyond_dead_zone(double deflection) {
  const double size = std::abs(std::clamp(deflection, -1.0, 1.0));
  return size <= dead_zone ? 0.0 : std::copysign((size - dead_zone) / (1.0 - dead_zone), deflection);
}

void set_pressed(WindowInput& input, const InputCode& code) {
  if (const auto* key = std::get_if<Key>(&code)) input.keys_pressed.set(static_cast<std::size_t>(*key));
  if (const auto* button = std::get_if<MouseButton>(&code))
    input.buttons_pressed.set(static_cast<std::size_t>(*button));
  if (const auto* turn = std::get_if<WheelTurn>(&code)) input.wheel_turned.set(static_cast<std::size_t>(*turn));
  if (const auto* button = std::get_if<PadButton>(&code)) input.pad_pressed.set(static_cast<std::size_t>(*button));
}

void set_not_held(WindowInput& input, const InputCode& code) {
  if (const auto* key = std::get_if<Key>(&code)) input.keys_held.reset(static_cast<std::size_t>(*key));
  if (const auto* button = std::get_if<MouseButton>(&code)) input.buttons_held.reset(static_cast<std::size_t>(*button));
  if (const auto* button = std::get_if<PadButton>(&code)) input.pad_held.reset(static_cast<std::size_t>(*button));
}

/// Returns the input without any event.
WindowInput without_events(const WindowInput& input) {
  WindowInput rest;
  rest.mouse = input.mouse;
  rest.keys_held = input.keys_held;
  rest.buttons_held = input.buttons_held;
  rest.pad_held = input.pad_held;
  rest.left_stick = input.left_stick;
  rest.right_stick = input.right_stick;
  rest.pads = input.pads;
  rest.each_pad = input.each_pad;
  for (PadInput& pad : rest.each_pad) pad.pressed = pad.released = {};
  return rest;
}

}  // namespace

WindowInput WindowInput::with_pad(std::size_t pad) const {
  WindowInput with = *this;
  const PadInput& only = each_pad[pad];
  with.pad_held = only.held;
  with.pad_pressed = only.pressed;
  with.pad_released = only.released;
  with.left_stick = only.left_stick;
  with.right_stick = only.right_stick;
  return with;
}

std::vector<WindowInput> single_presses(const WindowInput& input) {
  if (input.presses.empty()) return {input};
  std::vector<WindowInput> parts;
  for (std::size_t k = 0; k < input.presses.size(); ++k) {
    WindowInput part = without_events(input);
    part.mouse = input.presses[k].mouse;
    part.mouse_moved = input.mouse_moved;
    for (std::size_t later = k + 1; later < input.presses.size(); ++later)
      set_not_held(part, input.presses[later].code);
    set_pressed(part, input.presses[k].code);
    part.presses = {input.presses[k]};
    parts.push_back(std::move(part));
  }
  if (input.presses.back().mouse != input.mouse) parts.push_back(without_events(input));
  WindowInput& last = parts.back();
  last.mouse_moved = input.mouse_moved;
  last.quit = input.quit;
  last.focus_lost = input.focus_lost;
  last.wheel = input.wheel;
  last.text = input.text;
  last.keys_released = input.keys_released;
  last.buttons_released = input.buttons_released;
  last.pad_released = input.pad_released;
  last.each_pad = input.each_pad;  // the order of presses of different players does not matter
  last.pad_found = input.pad_found;
  last.pad_lost = input.pad_lost;
  return parts;
}

void InputState::key_down(Key key) {
  const auto i = static_cast<std::size_t>(key);
  if (input_.keys_held[i]) return;
  input_.keys_held.set(i);
  input_.keys_pressed.set(i);
  press(key);
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
  press(button);
}

void InputState::button_up(MouseButton button) {
  const auto i = static_cast<std::size_t>(button);
  if (!input_.buttons_held[i]) return;
  input_.buttons_held.reset(i);
  input_.buttons_released.set(i);
}

void InputState::focus_lost() {
  input_.focus_lost = true;
  input_.keys_released |= input_.keys_held;
  input_.keys_held.reset();
  input_.buttons_released |= input_.buttons_held;
  input_.buttons_held.reset();
}

void InputState::mouse_at(ribbon::Vec2 pixels) {
  if (pixels == input_.mouse) return;
  input_.mouse = pixels;
  input_.mouse_moved = true;
}

void InputState::wheel(ribbon::Vec2 notches) {
  input_.wheel += notches;
  if (notches.y != 0.0) {
    const WheelTurn turn = notches.y > 0.0 ? WheelTurn::up : WheelTurn::down;
    // Fine wheels report many fractions of a notch: together they are one press of the poll.
    const int fraction = input_.pressed(turn) ? 0 : 1;
    const int whole = static_cast<int>(std::min(std::abs(notches.y), max_notches));
    for (int k = 0; k < std::max(whole, fraction); ++k) press(turn);
  }
  if (notches.y > 0.0) input_.wheel_turned.set(static_cast<std::size_t>(WheelTurn::up));
  if (notches.y < 0.0) input_.wheel_turned.set(static_cast<std::size_t>(WheelTurn::down));
}

void InputState::pad_found() {
  ++input_.pads;
  input_.pad_found = true;
}

void InputState::pad_lost() {
  input_.pads = std::max(input_.pads - 1, 0);
  input_.pad_lost = true;
  input_.pad_released |= input_.pad_held;
  input_.pad_held.reset();
  input_.left_stick = input_.right_stick = {};
  for (PadInput& pad : input_.each_pad) {
    pad.released |= pad.held;
    pad.held.reset();
    pad.left_stick = pad.right_stick = {};
  }
}

void InputState::pad_down(PadButton button, std::size_t pad) {
  const auto i = static_cast<std::size_t>(button);
  if (pad < told_apart_pads && !input_.each_pad[pad].held[i]) {
    input_.each_pad[pad].held.set(i);
    input_.each_pad[pad].pressed.set(i);
  }
  if (input_.pad_held[i]) return;
  input_.pad_held.set(i);
  input_.pad_pressed.set(i);
  press(button);
}

void InputState::pad_up(PadButton button, std::size_t pad) {
  const auto i = static_cast<std::size_t>(button);
  if (pad < told_apart_pads && input_.each_pad[pad].held[i]) {
    input_.each_pad[pad].held.reset(i);
    input_.each_pad[pad].released.set(i);
  }
  if (!input_.pad_held[i]) return;
  input_.pad_held.reset(i);
  input_.pad_released.set(i);
}

void InputState::trigger(PadButton which, double pull, std::size_t pad) {
  const bool held =
      pad < told_apart_pads ? input_.each_pad[pad].held[static_cast<std::size_t>(which)] : input_.held(which);
  const double threshold = held ? release_threshold : press_threshold;
  pull >= threshold ? pad_down(which, pad) : pad_up(which, pad);
}

void InputState::stick_x(PadStick stick, double x, std::size_t pad) {
  const bool left = stick == PadStick::left;
  (left ? input_.left_stick : input_.right_stick).x = beyond_dead_zone(x);
  if (pad < told_apart_pads) {
    PadInput& own = input_.each_pad[pad];
    (left ? own.left_stick : own.right_stick).x = beyond_dead_zone(x);
  }
  trigger(left ? PadButton::left_stick_left : PadButton::right_stick_left, -x, pad);
  trigger(left ? PadButton::left_stick_right : PadButton::right_stick_right, x, pad);
}

void InputState::stick_y(PadStick stick, double y, std::size_t pad) {
  const bool left = stick == PadStick::left;
  (left ? input_.left_stick : input_.right_stick).y = beyond_dead_zone(y);
  if (pad < told_apart_pads) {
    PadInput& own = input_.each_pad[pad];
    (left ? own.left_stick : own.right_stick).y = beyond_dead_zone(y);
  }
  trigger(left ? PadButton::left_stick_down : PadButton::right_stick_down, -y, pad);
  trigger(left ? PadButton::left_stick_up : PadButton::right_stick_up, y, pad);
}

WindowInput InputState::take() {
  WindowInput taken = input_;
  input_.quit = false;
  input_.focus_lost = false;
  input_.mouse_moved = false;
  input_.wheel = {};
  input_.text.clear();
  input_.wheel_turned.reset();
  input_.pad_pressed.reset();
  input_.pad_released.reset();
  for (PadInput& pad : input_.each_pad) {
    pad.pressed.reset();
    pad.released.reset();
  }
  input_.pad_found = false;
  input_.pad_lost = false;
  input_.keys_pressed.reset();
  input_.keys_released.reset();
  input_.buttons_pressed.reset();
  input_.buttons_released.reset();
  input_.presses.clear();
  return taken;
}

}  // namespace engine
