#include "engine/window/sdl_events.h"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace engine {
namespace {

using ribbon::Vec2;

template <typename From, typename To, std::size_t N>
std::optional<To> find_in(const std::array<std::pair<From, To>, N>& table, From from) {
  for (const auto& [key, value] : table) {
    if (key == from) return value;
  }
  return std::nullopt;
}

std::optional<Key> offset_key(SDL_Keycode code, SDL_Keycode first, SDL_Keycode last, Key start) {
  if (code < first || code > last) return std::nullopt;
  return static_cast<Key>(static_cast<int>(start) + (code - first));
}

std::optional<Key> key_of_code(SDL_Keycode code) {
  static constexpr std::array table = std::to_array<std::pair<SDL_Keycode, Key>>({
      {SDLK_LEFT, Key::left},      {SDLK_RIGHT, Key::right},         {SDLK_UP, Key::up},
      {SDLK_DOWN, Key::down},      {SDLK_SPACE, Key::space},         {SDLK_RETURN, Key::enter},
      {SDLK_KP_ENTER, Key::enter}, {SDLK_ESCAPE, Key::escape},       {SDLK_TAB, Key::tab},
      {SDLK_LSHIFT, Key::shift},   {SDLK_RSHIFT, Key::shift},        {SDLK_LCTRL, Key::ctrl},
      {SDLK_RCTRL, Key::ctrl},     {SDLK_COMMA, Key::comma},         {SDLK_PERIOD, Key::period},
      {SDLK_LALT, Key::alt},       {SDLK_BACKSPACE, Key::backspace}, {SDLK_INSERT, Key::insert},
      {SDLK_DELETE, Key::remove},  {SDLK_HOME, Key::home},           {SDLK_END, Key::end},
      {SDLK_PAGEUP, Key::page_up}, {SDLK_PAGEDOWN, Key::page_down},  {SDLK_MINUS, Key::minus},
      {SDLK_EQUALS, Key::equals},  {SDLK_SLASH, Key::slash},         {SDLK_SEMICOLON, Key::semicolon},
  });
  if (const auto key = offset_key(code, SDLK_a, SDLK_z, Key::a)) return key;
  if (const auto key = offset_key(code, SDLK_0, SDLK_9, Key::digit_0)) return key;
  if (const auto key = offset_key(code, SDLK_F1, SDLK_F12, Key::f1)) return key;
  return find_in(table, code);
}

/// Returns the key by its label. If the layout has no such label (digits in French, letters in Greek), the key at the
/// same position on an American keyboard.
std::optional<Key> key_of(const SDL_Keysym& keysym) {
  if (const auto key = key_of_code(keysym.sym)) return key;
  switch (keysym.scancode) {
    case SDL_SCANCODE_0: return Key::digit_0;
    case SDL_SCANCODE_COMMA: return Key::comma;
    case SDL_SCANCODE_PERIOD: return Key::period;
    default: break;
  }
  if (const auto key = offset_key(keysym.scancode, SDL_SCANCODE_1, SDL_SCANCODE_9, Key::digit_1)) return key;
  return keysym.sym > 127 ? offset_key(keysym.scancode, SDL_SCANCODE_A, SDL_SCANCODE_Z, Key::a) : std::nullopt;
}

/// Returns the key of one side of the keyboard, of which there is another.
std::optional<Key> sided_key_of(const SDL_Keysym& keysym) {
  switch (keysym.sym) {
    case SDLK_LSHIFT: return Key::left_shift;
    case SDLK_RSHIFT: return Key::right_shift;
    case SDLK_LCTRL: return Key::left_ctrl;
    case SDLK_RCTRL: return Key::right_ctrl;
    default: return std::nullopt;
  }
}

std::optional<MouseButton> button_of(std::uint8_t button) {
  switch (button) {
    case SDL_BUTTON_LEFT: return MouseButton::left;
    case SDL_BUTTON_MIDDLE: return MouseButton::middle;
    case SDL_BUTTON_RIGHT: return MouseButton::right;
    default: return std::nullopt;
  }
}

std::optional<PadButton> pad_button_of(std::uint8_t button) {
  static constexpr std::array table = std::to_array<std::pair<int, PadButton>>({
      {SDL_CONTROLLER_BUTTON_A, PadButton::a},
      {SDL_CONTROLLER_BUTTON_B, PadButton::b},
      {SDL_CONTROLLER_BUTTON_X, PadButton::x},
      {SDL_CONTROLLER_BUTTON_Y, PadButton::y},
      {SDL_CONTROLLER_BUTTON_BACK, PadButton::back},
      {SDL_CONTROLLER_BUTTON_START, PadButton::start},
      {SDL_CONTROLLER_BUTTON_LEFTSTICK, PadButton::left_stick},
      {SDL_CONTROLLER_BUTTON_RIGHTSTICK, PadButton::right_stick},
      {SDL_CONTROLLER_BUTTON_LEFTSHOULDER, PadButton::left_shoulder},
      {SDL_CONTROLLER_BUTTON_RIGHTSHOULDER, PadButton::right_shoulder},
      {SDL_CONTROLLER_BUTTON_DPAD_UP, PadButton::dpad_up},
      {SDL_CONTROLLER_BUTTON_DPAD_DOWN, PadButton::dpad_down},
      {SDL_CONTROLLER_BUTTON_DPAD_LEFT, PadButton::dpad_left},
      {SDL_CONTROLLER_BUTTON_DPAD_RIGHT, PadButton::dpad_right},
  });
  return find_in(table, static_cast<int>(button));
}

void read_axis(const SDL_ControllerAxisEvent& event, std::size_t pad, InputState& input) {
  const double value = event.value / 32767.0;
  switch (event.axis) {
    case SDL_CONTROLLER_AXIS_LEFTX: return input.stick_x(PadStick::left, value, pad);
    case SDL_CONTROLLER_AXIS_LEFTY: return input.stick_y(PadStick::left, -value, pad);
    case SDL_CONTROLLER_AXIS_RIGHTX: return input.stick_x(PadStick::right, value, pad);
    case SDL_CONTROLLER_AXIS_RIGHTY: return input.stick_y(PadStick::right, -value, pad);
    case SDL_CONTROLLER_AXIS_TRIGGERLEFT: return input.trigger(PadButton::left_trigger, value, pad);
    case SDL_CONTROLLER_AXIS_TRIGGERRIGHT: return input.trigger(PadButton::right_trigger, value, pad);
    default: return;
  }
}

Vec2 notches_of(const SDL_MouseWheelEvent& event) {
  const double sign = event.direction == SDL_MOUSEWHEEL_FLIPPED ? -1.0 : 1.0;
  return sign * Vec2{static_cast<double>(event.preciseX), static_cast<double>(event.preciseY)};
}

}  // namespace

void EventReader::Close::operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }

EventReader::EventReader() {
  // A failure, for instance without permission for gamepads, is not an error: the keyboard works without.
  started_ = SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER) == 0;
}

EventReader::~EventReader() {
  pads_.clear();
  if (started_) SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
}

void EventReader::open_pad(int device, InputState& input) {
  std::unique_ptr<SDL_GameController, Close> pad(SDL_GameControllerOpen(device));
  if (!pad) return;
  const int instance = SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad.get()));
  std::size_t number = 0;
  while (std::any_of(pads_.begin(), pads_.end(), [number](const auto& open) { return open.second.number == number; })) {
    ++number;
  }
  if (pads_.emplace(instance, Pad{std::move(pad), number}).second) input.pad_found();
}

std::size_t EventReader::number_of(int instance) const {
  const auto found = pads_.find(instance);
  return found == pads_.end() ? 0 : found->second.number;
}

void EventReader::read_pad(const SDL_Event& event, InputState& input) {
  switch (event.type) {
    case SDL_CONTROLLERDEVICEADDED: open_pad(event.cdevice.which, input); break;
    case SDL_CONTROLLERDEVICEREMOVED:
      if (pads_.erase(event.cdevice.which) != 0) input.pad_lost();
      break;
    case SDL_CONTROLLERBUTTONDOWN:
      if (const auto button = pad_button_of(event.cbutton.button))
        input.pad_down(*button, number_of(event.cbutton.which));
      break;
    case SDL_CONTROLLERBUTTONUP:
      if (const auto button = pad_button_of(event.cbutton.button))
        input.pad_up(*button, number_of(event.cbutton.which));
      break;
    case SDL_CONTROLLERAXISMOTION: read_axis(event.caxis, number_of(event.caxis.which), input); break;
    default: break;
  }
}

void EventReader::read(const SDL_Event& event, Vec2 pixels_per_unit, InputState& input) {
  const auto mouse_at = [&](int x, int y) { input.mouse_at({x * pixels_per_unit.x, y * pixels_per_unit.y}); };
  switch (event.type) {
    case SDL_QUIT: input.quit(); break;
    case SDL_KEYDOWN:
      if (event.key.repeat != 0) break;
      if (const auto key = key_of(event.key.keysym)) input.key_down(*key);
      if (const auto key = sided_key_of(event.key.keysym)) input.key_down(*key);
      break;
    case SDL_KEYUP:
      if (const auto key = key_of(event.key.keysym)) input.key_up(*key);
      if (const auto key = sided_key_of(event.key.keysym)) input.key_up(*key);
      break;
    case SDL_TEXTINPUT: input.text(event.text.text); break;
    case SDL_MOUSEMOTION: mouse_at(event.motion.x, event.motion.y); break;
    case SDL_MOUSEBUTTONDOWN:
      mouse_at(event.button.x, event.button.y);
      if (const auto button = button_of(event.button.button)) input.button_down(*button);
      break;
    case SDL_MOUSEBUTTONUP:
      mouse_at(event.button.x, event.button.y);
      if (const auto button = button_of(event.button.button)) input.button_up(*button);
      break;
    case SDL_MOUSEWHEEL: input.wheel(notches_of(event.wheel)); break;
    case SDL_WINDOWEVENT:
      if (event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) input.focus_lost();
      break;
    default: read_pad(event, input); break;
  }
}

}  // namespace engine
