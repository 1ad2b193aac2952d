#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ribbon/vec2.h"

namespace engine {

/// The keys that a game can use. Left and right shift are one key, as are left and right ctrl; each side is a key of
/// its own too. Letters are those of the labels on the user's keyboard.
enum class Key : std::uint8_t {
  a,
  b,
  c,
  d,
  e,
  f,
  g,
  h,
  i,
  j,
  k,
  l,
  m,
  n,
  o,
  p,
  q,
  r,
  s,
  t,
  u,
  v,
  w,
  x,
  y,
  z,
  digit_0,
  digit_1,
  digit_2,
  digit_3,
  digit_4,
  digit_5,
  digit_6,
  digit_7,
  digit_8,
  digit_9,
  left,
  right,
  up,
  down,
  space,
  enter,
  escape,
  tab,
  shift,
  ctrl,
  comma,
  period,
  f1,
  f2,
  f3,
  f4,
  f5,
  f6,
  f7,
  f8,
  f9,
  f10,
  f11,
  f12,
  backspace,
  alt,
  insert,
  remove,  // Delete
  home,
  end,
  page_up,
  page_down,
  minus,
  equals,
  slash,
  semicolon,
  left_shift,   // pressed together with shift
  right_shift,  // the same
  left_ctrl,    // pressed together with ctrl
  right_ctrl,   // the same
};
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::right_ctrl) + 1;

enum class MouseButton : std::uint8_t { left, middle, right };
inline constexpr std::size_t mouse_button_count = 3;

/// A turn of the mouse wheel by one notch: it is pressed and never held.
enum class WheelTurn : std::uint8_t { up, down };
inline constexpr std::size_t wheel_turn_count = 2;

/// The buttons of a gamepad by their position on a standard pad (a is the lower of the four). Triggers and the eight
/// directions of the sticks are buttons too, which are down beyond half their range.
enum class PadButton : std::uint8_t {
  a,
  b,
  x,
  y,
  back,
  start,
  left_stick,
  right_stick,
  left_shoulder,
  right_shoulder,
  dpad_up,
  dpad_down,
  dpad_left,
  dpad_right,
  left_trigger,
  right_trigger,
  left_stick_left,
  left_stick_right,
  left_stick_up,
  left_stick_down,
  right_stick_left,
  right_stick_right,
  right_stick_up,
  right_stick_down,
};
inline constexpr std::size_t pad_button_count = static_cast<std::size_t>(PadButton::right_stick_down) + 1;

enum class PadStick : std::uint8_t { left, right };

/// Any input that can be pressed.
using InputCode = std::variant<Key, MouseButton, WheelTurn, PadButton>;

/// The input of one gamepad at one poll; see WindowInput.
struct PadInput {
  std::bitset<pad_button_count> held, pressed, released;
  ribbon::Vec2 left_stick{}, right_stick{};
};
inline constexpr std::size_t told_apart_pads = 2;

/// One press among those of a poll.
struct Press {
  InputCode code;
  ribbon::Vec2 mouse;  ///< where the mouse was then, canvas pixels
};

/// The input at one poll. `held` is the state at the poll; `pressed` and `released` are events since the poll before: a
/// key that is tapped between two polls is pressed and released but not held.
struct WindowInput {
  bool quit = false;        ///< the window was asked to close
  bool focus_lost = false;  ///< another window got the keyboard; everything held is released
  ribbon::Vec2 mouse{};     ///< canvas pixels, y down
  bool mouse_moved = false;
  ribbon::Vec2 wheel{};  ///< notches: to the right, and upwards (away from the user)
  std::string text;      ///< typed text, UTF-8
  std::bitset<key_count> keys_held, keys_pressed, keys_released;
  std::bitset<mouse_button_count> buttons_held, buttons_pressed, buttons_released;
  std::bitset<wheel_turn_count> wheel_turned;
  std::bitset<pad_button_count> pad_held, pad_pressed, pad_released;
  std::vector<Press> presses;  ///< all presses since the poll before, in order; a notch of the wheel is one
  ribbon::Vec2 left_stick{}, right_stick{};          ///< −1 … 1 per axis, y up; 0 within the dead zone
  int pads = 0;                                      ///< number of connected gamepads; their input is combined
  std::array<PadInput, told_apart_pads> each_pad{};  ///< that of the first and of the second gamepad alone
  bool pad_found = false;                            ///< a gamepad was connected
  bool pad_lost = false;  ///< a gamepad was disconnected; everything held on gamepads is released

  bool held(Key key) const { return keys_held[static_cast<std::size_t>(key)]; }
  bool pressed(Key key) const { return keys_pressed[static_cast<std::size_t>(key)]; }
  bool released(Key key) const { return keys_released[static_cast<std::size_t>(key)]; }
  bool held(MouseButton button) const { return buttons_held[static_cast<std::size_t>(button)]; }
  bool pressed(MouseButton button) const { return buttons_pressed[static_cast<std::size_t>(button)]; }
  bool released(MouseButton button) const { return buttons_released[static_cast<std::size_t>(button)]; }
  bool held(WheelTurn) const { return false; }
  bool pressed(WheelTurn turn) const { return wheel_turned[static_cast<std::size_t>(turn)]; }
  bool released(WheelTurn turn) const { return pressed(turn); }
  bool held(PadButton button) const { return pad_held[static_cast<std::size_t>(button)]; }
  bool pressed(PadButton button) const { return pad_pressed[static_cast<std::size_t>(button)]; }
  bool released(PadButton button) const { return pad_released[static_cast<std::size_t>(button)]; }
  /// Returns this input with that of one gamepad, 0 or 1, in place of that of all.
  WindowInput with_pad(std::size_t pad) const;
  bool held(const InputCode& code) const {
    return std::visit([this](auto which) { return held(which); }, code);
  }
  bool pressed(const InputCode& code) const {
    return std::visit([this](auto which) { return pressed(which); }, code);
  }
};

/// Divides the input of a poll into inputs with one press each, in order, for menus in which every press counts. The
/// last one has all the rest: what was released, typed and turned, and the final position of the mouse. At least one.
std::vector<WindowInput> single_presses(const WindowInput& input);

/// Collects events into the result of a poll. Independent of a window.
class InputState {
 public:
  /// Ignores key_down of a held key (auto-repeat).
  void key_down(Key key);
  void key_up(Key key);
  void button_down(MouseButton button);
  void button_up(MouseButton button);
  void mouse_at(ribbon::Vec2 pixels);
  /// Turns the wheel by this number of notches, to the right and upwards.
  void wheel(ribbon::Vec2 notches);
  void text(std::string_view utf8) { input_.text += utf8; }
  void quit() { input_.quit = true; }
  /// Releases everything held on keyboard and mouse, since a window without focus receives no key-up events.
  void focus_lost();

  void pad_found();
  /// Releases everything held on gamepads.
  void pad_lost();
  // `pad`: the number of the gamepad, from 0. Those from 2 on are only combined with the others.
  void pad_down(PadButton button, std::size_t pad = 0);
  void pad_up(PadButton button, std::size_t pad = 0);
  /// Sets the position of a trigger, 0 … 1.
  void trigger(PadButton which, double pull, std::size_t pad = 0);
  /// Sets one coordinate of a stick, −1 … 1: x to the right, y up.
  void stick_x(PadStick stick, double x, std::size_t pad = 0);
  void stick_y(PadStick stick, double y, std::size_t pad = 0);

  /// Returns the input since the last call and clears all events; what is held stays held.
  WindowInput take();

 private:
  void press(const InputCode& code) { input_.presses.push_back({code, input_.mouse}); }

  WindowInput input_;
};

}  // namespace engine
