#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "ribbon/vec2.h"

namespace engine {

/// The keys a game can ask for. Left and right shift are one key, as are left and right ctrl. Letters are meant by
/// their label on the user's keyboard, as a help text names them.
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
};
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::semicolon) + 1;

enum class MouseButton : std::uint8_t { left, middle, right };
inline constexpr std::size_t mouse_button_count = 3;

/// The turning of a mouse's wheel by a notch: it is pressed and never held.
enum class WheelTurn : std::uint8_t { up, down };
inline constexpr std::size_t wheel_turn_count = 2;

/// A gamepad's buttons by their place on a pad of the usual shape (a is the lower of the four). Triggers and the eight
/// directions of the sticks count as buttons too: down beyond half the way.
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

/// Anything that can be pressed.
using InputCode = std::variant<Key, MouseButton, WheelTurn, PadButton>;

/// What the user did up to one poll. `held` is the state at the poll; `pressed` and `released` are what happened since
/// the poll before, so a key tapped between two polls is pressed and released without being held.
struct WindowInput {
  bool quit = false;        ///< the window was asked to close
  bool focus_lost = false;  ///< another window has the keyboard now: what was held is released
  ribbon::Vec2 mouse{};     ///< canvas pixels, y down
  bool mouse_moved = false;
  ribbon::Vec2 wheel{};  ///< notches: to the right, and upwards (away from the user)
  std::string text;      ///< what was typed, UTF-8
  std::bitset<key_count> keys_held, keys_pressed, keys_released;
  std::bitset<mouse_button_count> buttons_held, buttons_pressed, buttons_released;
  std::bitset<wheel_turn_count> wheel_turned;
  std::bitset<pad_button_count> pad_held, pad_pressed, pad_released;
  ribbon::Vec2 left_stick{}, right_stick{};  ///< −1 … 1 each way, y up; 0 where a stick at rest stands
  int pads = 0;                              ///< gamepads that are plugged in: they count as one
  bool pad_found = false;                    ///< one was plugged in
  bool pad_lost = false;                     ///< one was unplugged: what was held on any of them is released

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
  bool held(const InputCode& code) const {
    return std::visit([this](auto which) { return held(which); }, code);
  }
  bool pressed(const InputCode& code) const {
    return std::visit([this](auto which) { return pressed(which); }, code);
  }
};

/// Gathers single events into what a poll returns. Knows no window, so it can be tested without one.
class InputState {
 public:
  /// A repeated key_down of a held key (the keyboard's auto-repeat) is not another press.
  void key_down(Key key);
  void key_up(Key key);
  void button_down(MouseButton button);
  void button_up(MouseButton button);
  void mouse_at(ribbon::Vec2 pixels);
  /// By so many notches, to the right and upwards.
  void wheel(ribbon::Vec2 notches);
  void text(std::string_view utf8) { input_.text += utf8; }
  void quit() { input_.quit = true; }
  /// Releases everything held on keyboard and mouse: a window without focus is not told when a key goes up.
  void focus_lost();

  void pad_found();
  /// Releases everything held on gamepads.
  void pad_lost();
  void pad_down(PadButton button);
  void pad_up(PadButton button);
  /// How far a trigger is pulled, 0 … 1.
  void trigger(PadButton which, double pull);
  /// Where one coordinate of a stick is, −1 … 1: x to the right, y up.
  void stick_x(PadStick stick, double x);
  void stick_y(PadStick stick, double y);

  /// What happened since the last take. Presses, releases, quit and a lost focus are then forgotten; what is held stays
  /// held.
  WindowInput take();

 private:
  WindowInput input_;
};

}  // namespace engine
