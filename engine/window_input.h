#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

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
};
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::f12) + 1;

enum class MouseButton : std::uint8_t { left, middle, right };
inline constexpr std::size_t mouse_button_count = 3;

/// What the user did up to one poll. `held` is the state at the poll; `pressed` and `released` are what happened since
/// the poll before, so a key tapped between two polls is pressed and released without being held.
struct WindowInput {
  bool quit = false;     ///< the window was asked to close
  ribbon::Vec2 mouse{};  ///< canvas pixels, y down
  std::bitset<key_count> keys_held, keys_pressed, keys_released;
  std::bitset<mouse_button_count> buttons_held, buttons_pressed, buttons_released;

  bool held(Key key) const { return keys_held[static_cast<std::size_t>(key)]; }
  bool pressed(Key key) const { return keys_pressed[static_cast<std::size_t>(key)]; }
  bool released(Key key) const { return keys_released[static_cast<std::size_t>(key)]; }
  bool held(MouseButton button) const { return buttons_held[static_cast<std::size_t>(button)]; }
  bool pressed(MouseButton button) const { return buttons_pressed[static_cast<std::size_t>(button)]; }
  bool released(MouseButton button) const { return buttons_released[static_cast<std::size_t>(button)]; }
};

/// Gathers single events into what a poll returns. Knows no window, so it can be tested without one.
class InputState {
 public:
  /// A repeated key_down of a held key (the keyboard's auto-repeat) is not another press.
  void key_down(Key key);
  void key_up(Key key);
  void button_down(MouseButton button);
  void button_up(MouseButton button);
  void mouse_at(ribbon::Vec2 pixels) { input_.mouse = pixels; }
  void quit() { input_.quit = true; }
  /// Releases everything held: a window without focus is not told when a key goes up.
  void focus_lost();

  /// What happened since the last take. Presses, releases and quit are then forgotten; what is held stays held.
  WindowInput take();

 private:
  WindowInput input_;
};

}  // namespace engine
