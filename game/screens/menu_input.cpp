#include "game/screens/menu_input.h"

#include <algorithm>
#include <initializer_list>

namespace game {
namespace {

using engine::InputCode;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using engine::WindowInput;

constexpr std::int64_t first_repeat_ns = 400'000'000;
constexpr std::int64_t repeat_ns = 110'000'000;

bool any_pressed(const WindowInput& input, std::initializer_list<InputCode> codes) {
  return std::any_of(codes.begin(), codes.end(), [&](const InputCode& code) { return input.pressed(code); });
}

bool any_held(const WindowInput& input, std::initializer_list<InputCode> codes) {
  return std::any_of(codes.begin(), codes.end(), [&](const InputCode& code) { return input.held(code); });
}

}  // namespace

int MenuReader::Repeat::steps(bool pressed, bool held, std::int64_t elapsed_ns) {
  if (pressed) {
    left_ns_ = first_repeat_ns;
    return 1;
  }
  if (!held) return 0;
  left_ns_ -= elapsed_ns;
  if (left_ns_ > 0) return 0;
  left_ns_ = repeat_ns;
  return 1;
}

MenuInput MenuReader::read(const WindowInput& input, std::int64_t elapsed_ns) {
  const auto steps = [&](Repeat& repeat, std::initializer_list<InputCode> codes) {
    return repeat.steps(any_pressed(input, codes), any_held(input, codes), elapsed_ns);
  };
  MenuInput menu;
  menu.down = steps(down_, {Key::down, Key::s, PadButton::dpad_down, PadButton::left_stick_down}) -
              steps(up_, {Key::up, Key::w, PadButton::dpad_up, PadButton::left_stick_up});
  menu.right = steps(right_, {Key::right, Key::d, PadButton::dpad_right, PadButton::left_stick_right}) -
               steps(left_, {Key::left, Key::a, PadButton::dpad_left, PadButton::left_stick_left});
  menu.accept = any_pressed(input, {Key::enter, Key::space, PadButton::a});
  menu.back = any_pressed(input, {Key::escape, Key::backspace, MouseButton::right, PadButton::b});
  menu.mouse_moved = input.mouse_moved;
  menu.clicked = input.pressed(MouseButton::left);
  menu.mouse = input.mouse;
  if (input.pressed(engine::WheelTurn::up)) --menu.down;
  if (input.pressed(engine::WheelTurn::down)) ++menu.down;
  return menu;
}

}  // namespace game
