#include "game/settings/controls.h"

#include <algorithm>

#include "game/simulation/buttons.h"

namespace game {
namespace {

using engine::InputCode;
using engine::WindowInput;

constexpr unsigned at_a_press =
    button_jump | button_throw | button_retry | button_restart;  // what they do they do then
constexpr double aiming = 0.5;  // share of a stick's way, from where it points somewhere

std::uint16_t with(std::uint16_t buttons, unsigned more) { return static_cast<std::uint16_t>(buttons | more); }
std::uint16_t without(std::uint16_t buttons, unsigned less) { return static_cast<std::uint16_t>(buttons & ~less); }

}  // namespace

void Controls::take(const WindowInput& input, const Settings& settings, ribbon::Vec2 mouse, bool dragging) {
  held_ = 0;
  for (const Action action : all_actions()) {
    for (const InputCode& code : settings.bindings.codes(action)) {
      if (dragging && code == InputCode(engine::MouseButton::left)) continue;
      if (input.held(code)) held_ = with(held_, button_of(action));
      if (!input.pressed(code)) continue;
      tapped_ = with(tapped_, button_of(action));
      if (!std::holds_alternative<engine::WheelTurn>(code)) continue;
      int& left = wheel_left_[static_cast<std::size_t>(action)];
      left = std::min(left + wheel_ticks, 4 * wheel_ticks);
    }
  }
  if (dragging && input.held(engine::MouseButton::left)) held_ = with(held_, button_drag);
  if (dragging && input.pressed(engine::MouseButton::left)) tapped_ = with(tapped_, button_drag);
  stale_ =
      forgot_ ? static_cast<std::uint16_t>(held_ & ~tapped_ & at_a_press) : static_cast<std::uint16_t>(stale_ & held_);
  forgot_ = false;
  held_ = without(held_, stale_);
  toggle_grab(settings.toggle_grab);
  take_aim(input, mouse);
}

/// Where a press holds on, the next one lets go, and so does a jump.
void Controls::toggle_grab(bool wanted) {
  const bool pressed = (tapped_ & button_grab) != 0;
  if (!wanted) {
    grabs_ = false;
    return;
  }
  if (pressed) grabs_ = !grabs_;
  if ((tapped_ & button_jump) != 0) grabs_ = false;
  tapped_ = without(tapped_, button_grab);
  held_ = grabs_ ? with(held_, button_grab) : without(held_, button_grab);
}

void Controls::take_aim(const WindowInput& input, ribbon::Vec2 mouse) {
  mouse_ = mouse;
  const double far = length(input.right_stick);
  if (far > aiming) stick_ = (1.0 / far) * input.right_stick;
  if (input.mouse_moved || input.buttons_pressed.any() || input.pad_lost) stick_.reset();
}

engine::TickInput Controls::next(ribbon::Vec2 hand) {
  engine::TickInput tick;
  tick.buttons = with(held_, tapped_);
  tapped_ = 0;
  for (const Action action : all_actions()) {
    int& left = wheel_left_[static_cast<std::size_t>(action)];
    if (left == 0) continue;
    tick.buttons = with(tick.buttons, button_of(action));
    --left;
  }
  engine::set_pointer(tick, stick_ ? hand + pad_aim * *stick_ : mouse_);
  return tick;
}

void Controls::forget() {
  forget_presses();
  forgot_ = true;
  grabs_ = false;
}

void Controls::forget_presses() {
  tapped_ = 0;
  wheel_left_.fill(0);
}

}  // namespace game
