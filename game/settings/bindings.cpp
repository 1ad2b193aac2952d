#include "game/settings/bindings.h"

#include <algorithm>
#include <initializer_list>

#include "engine/window/input_names.h"
#include "game/words/words.h"

namespace game {

using engine::InputCode;
using engine::Key;
using engine::MouseButton;
using engine::PadButton;
using engine::WheelTurn;

Bindings Bindings::defaults() {
  Bindings made;
  const auto bind = [&made](Action action, std::initializer_list<InputCode> codes) {
    for (const InputCode& code : codes) made.bind(action, code);
  };
  bind(Action::left, {Key::left, Key::a, PadButton::left_stick_left, PadButton::dpad_left});
  bind(Action::right, {Key::right, Key::d, PadButton::left_stick_right, PadButton::dpad_right});
  bind(Action::up, {Key::up, Key::w, PadButton::left_stick_up, PadButton::dpad_up});
  bind(Action::down, {Key::down, Key::s, PadButton::left_stick_down, PadButton::dpad_down});
  bind(Action::jump, {Key::space, PadButton::a});
  bind(Action::grab, {Key::e, Key::shift, PadButton::x, PadButton::right_trigger});
  bind(Action::throw_line, {MouseButton::left, Key::f, PadButton::y});
  bind(Action::throw_second, {MouseButton::right, Key::g, PadButton::left_trigger});
  bind(Action::tie, {Key::v, PadButton::right_stick});
  bind(Action::cut, {Key::c, PadButton::left_stick});
  bind(Action::reel_in, {Key::q, WheelTurn::up, PadButton::right_shoulder});
  bind(Action::reel_out, {Key::z, WheelTurn::down, PadButton::left_shoulder});
  bind(Action::retry, {Key::t, Key::backspace, PadButton::b});
  bind(Action::restart, {Key::r, PadButton::back});
  bind(Action::pause, {Key::p, Key::escape, PadButton::start});
  bind(Action::step, {Key::n});
  bind(Action::slow_motion, {Key::x});
  bind(Action::help, {Key::f1, Key::h});
  bind(Action::debug_view, {Key::f3});
  bind(Action::panel, {Key::f2});
  bind(Action::palette, {Key::b});
  bind(Action::mute, {Key::m});
  bind(Action::fullscreen, {Key::f11});
  bind(Action::film, {Key::f10});
  bind(Action::screenshot, {Key::f12});
  return made;
}

Bindings Bindings::second_defaults() {
  Bindings made;
  const auto bind = [&made](Action action, std::initializer_list<InputCode> codes) {
    for (const InputCode& code : codes) made.bind(action, code);
  };
  bind(Action::left, {Key::left});
  bind(Action::right, {Key::right});
  bind(Action::up, {Key::up});
  bind(Action::down, {Key::down});
  bind(Action::jump, {Key::enter, Key::ctrl});
  bind(Action::grab, {Key::shift});
  bind(Action::throw_line, {Key::remove, Key::slash});
  bind(Action::reel_in, {Key::page_up, Key::comma});
  bind(Action::reel_out, {Key::page_down, Key::period});
  return made;
}

std::optional<Action> Bindings::action_of(const InputCode& code) const {
  for (const Action action : all_actions()) {
    if (std::find(codes(action).begin(), codes(action).end(), code) != codes(action).end()) return action;
  }
  return std::nullopt;
}

void Bindings::bind(Action action, const InputCode& code) {
  if (action_of(code) == action) return;
  unbind(code);
  codes_[index(action)].push_back(code);
}

void Bindings::unbind(const InputCode& code) {
  for (std::vector<InputCode>& bound : codes_) std::erase(bound, code);
}

bool Bindings::held(Action action, const engine::WindowInput& input) const {
  return std::any_of(codes(action).begin(), codes(action).end(),
                     [&input](const InputCode& code) { return input.held(code); });
}

bool Bindings::pressed(Action action, const engine::WindowInput& input) const {
  return std::any_of(codes(action).begin(), codes(action).end(),
                     [&input](const InputCode& code) { return input.pressed(code); });
}

std::string codes_in_words(const Bindings& bindings, Action action, bool of_pad, std::size_t max_codes) {
  std::string titles;
  std::size_t count = 0;
  for (const InputCode& code : bindings.codes(action)) {
    if (std::holds_alternative<PadButton>(code) != of_pad) continue;
    titles += (titles.empty() ? "" : words::or_key) + std::string(engine::input_title(code));
    if (++count == max_codes) break;
  }
  return titles.empty() ? words::no_key : titles;
}

}  // namespace game
