#include "game/settings/controls.h"

#include <algorithm>

#include "game/simulation/buttons.h"

namespace game {
namespace {

using engine::InputCode;
using engine::WindowInput;

constexpr unsigned edge_triggered =
    button_jump | button_throw | button_throw_second | button_cut | button_tie | button_retry | button_restart;
constexpr double aim_threshold = 0.5;  // deflection of a stick from which it aims

std::uint16_t with(std::uint16_t buttons, unsigned more) { return static_cast<std::uint16_t>(buttons | more); }
std::uint16_t without(std::uint16_t buttons, unsigned less) { return static_cast<std::uint16_t>(buttons & ~less); }

}  // namespace

void Controls::take(const WindowInput& input, const Bindings& bindings, bool toggles_grab,
                    std::optional<ribbon::Vec2> mouse, bool dragging) {
  held_ = 0;
  for (const Action action : all_actions()) {
    for (const InputCode& code : bindings.codes(action)) {
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
  stale_ = discarded_ ? static_cast<std::uint16_t>(held_ & ~tapped_ & edge_triggered)
                      : static_cast<std::uint16_t>(stale_ & held_);
  discarded_ = false;
  held_ = without(held_, stale_);
  toggle_grab(toggles_grab);
  take_aim(input, mouse);
}

/// With the option, a press grabs, and the next press or a jump releases.
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

void Controls::take_aim(const WindowInput& input, std::optional<ribbon::Vec2> mouse) {
  mouse_ = mouse;
  const double deflection = length(input.right_stick);
  if (deflection > aim_threshold) stick_ = (1.0 / deflection) * input.right_stick;
  const bool uses_mouse = mouse && (input.mouse_moved || input.buttons_pressed.any());
  if (uses_mouse || input.pad_lost) stick_.reset();
}

std::optional<ribbon::Vec2> Controls::pointer(ribbon::Vec2 hand) const {
  return stick_ ? hand + pad_aim * *stick_ : mouse_;
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
  if (const auto at = pointer(hand)) engine::set_pointer(tick, *at);
  return tick;
}

void Controls::discard() {
  discard_presses();
  discarded_ = true;
  grabs_ = false;
}

void Controls::ignore_held() {
  discard_presses();
  grabs_ = false;
  stale_ = with(stale_, held_);
  held_ = 0;
}

void Controls::discard_presses() {
  tapped_ = 0;
  wheel_left_.fill(0);
}

}  // namespace game
