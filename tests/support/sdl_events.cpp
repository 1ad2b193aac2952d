#include "tests/support/sdl_events.h"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>

namespace test_support {
namespace {

using engine::Key;
using engine::PadButton;

int offset(Key key, Key first) { return static_cast<int>(key) - static_cast<int>(first); }

SDL_Keycode code_of(Key key) {
  if (key <= Key::z) return SDLK_a + offset(key, Key::a);
  if (key <= Key::digit_9) return SDLK_0 + offset(key, Key::digit_0);
  if (key >= Key::f1 && key <= Key::f12) return SDLK_F1 + offset(key, Key::f1);
  switch (key) {
    case Key::left: return SDLK_LEFT;
    case Key::right: return SDLK_RIGHT;
    case Key::up: return SDLK_UP;
    case Key::down: return SDLK_DOWN;
    case Key::space: return SDLK_SPACE;
    case Key::enter: return SDLK_RETURN;
    case Key::escape: return SDLK_ESCAPE;
    case Key::backspace: return SDLK_BACKSPACE;
    case Key::shift:
    case Key::left_shift: return SDLK_LSHIFT;
    case Key::right_shift: return SDLK_RSHIFT;
    case Key::right_ctrl: return SDLK_RCTRL;
    default: throw std::invalid_argument("a key that no test has used yet");
  }
}

struct Axis {
  SDL_GameControllerAxis axis;
  Sint16 pressed;
};

std::optional<Axis> axis_of(PadButton button) {
  constexpr Sint16 most = 32767;
  switch (button) {
    case PadButton::left_trigger: return Axis{SDL_CONTROLLER_AXIS_TRIGGERLEFT, most};
    case PadButton::right_trigger: return Axis{SDL_CONTROLLER_AXIS_TRIGGERRIGHT, most};
    case PadButton::left_stick_left: return Axis{SDL_CONTROLLER_AXIS_LEFTX, -most};
    case PadButton::left_stick_right: return Axis{SDL_CONTROLLER_AXIS_LEFTX, most};
    case PadButton::left_stick_up: return Axis{SDL_CONTROLLER_AXIS_LEFTY, -most};
    case PadButton::left_stick_down: return Axis{SDL_CONTROLLER_AXIS_LEFTY, most};
    case PadButton::right_stick_left: return Axis{SDL_CONTROLLER_AXIS_RIGHTX, -most};
    case PadButton::right_stick_right: return Axis{SDL_CONTROLLER_AXIS_RIGHTX, most};
    case PadButton::right_stick_up: return Axis{SDL_CONTROLLER_AXIS_RIGHTY, -most};
    case PadButton::right_stick_down: return Axis{SDL_CONTROLLER_AXIS_RIGHTY, most};
    default: return std::nullopt;
  }
}

SDL_GameControllerButton pad_code_of(PadButton button) {
  constexpr std::array codes = {SDL_CONTROLLER_BUTTON_A,
                                SDL_CONTROLLER_BUTTON_B,
                                SDL_CONTROLLER_BUTTON_X,
                                SDL_CONTROLLER_BUTTON_Y,
                                SDL_CONTROLLER_BUTTON_BACK,
                                SDL_CONTROLLER_BUTTON_START,
                                SDL_CONTROLLER_BUTTON_LEFTSTICK,
                                SDL_CONTROLLER_BUTTON_RIGHTSTICK,
                                SDL_CONTROLLER_BUTTON_LEFTSHOULDER,
                                SDL_CONTROLLER_BUTTON_RIGHTSHOULDER,
                                SDL_CONTROLLER_BUTTON_DPAD_UP,
                                SDL_CONTROLLER_BUTTON_DPAD_DOWN,
                                SDL_CONTROLLER_BUTTON_DPAD_LEFT,
                                SDL_CONTROLLER_BUTTON_DPAD_RIGHT};
  return codes.at(static_cast<std::size_t>(button));
}

}  // namespace

void push_key(Key key, bool down) {
  SDL_Event event{};
  event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
  event.key.keysym.sym = code_of(key);
  SDL_PushEvent(&event);
}

void push_button(engine::MouseButton button, bool down, ribbon::Vec2 at) {
  SDL_Event event{};
  event.type = down ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  constexpr std::array codes = {SDL_BUTTON_LEFT, SDL_BUTTON_MIDDLE, SDL_BUTTON_RIGHT};
  event.button.button = static_cast<Uint8>(codes.at(static_cast<std::size_t>(button)));
  event.button.x = static_cast<Sint32>(at.x);
  event.button.y = static_cast<Sint32>(at.y);
  SDL_PushEvent(&event);
}

void push_mouse(ribbon::Vec2 at) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<Sint32>(at.x);
  event.motion.y = static_cast<Sint32>(at.y);
  SDL_PushEvent(&event);
}

void push_wheel(int notches) {
  SDL_Event event{};
  event.type = SDL_MOUSEWHEEL;
  event.wheel.y = notches;
  event.wheel.preciseY = static_cast<float>(notches);
  SDL_PushEvent(&event);
}

void push_text(const char* utf8) {
  SDL_Event event{};
  event.type = SDL_TEXTINPUT;
  std::strncpy(event.text.text, utf8, sizeof event.text.text - 1);
  SDL_PushEvent(&event);
}

void push_quit() {
  SDL_Event event{};
  event.type = SDL_QUIT;
  SDL_PushEvent(&event);
}

void push_focus_lost() {
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  SDL_PushEvent(&event);
}

VirtualPad::VirtualPad() {
  SDL_VirtualJoystickDesc description{};
  description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
  description.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
  description.naxes = SDL_CONTROLLER_AXIS_MAX;
  description.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
  description.vendor_id = 0x1234;
  description.product_id = 0x5678;
  description.name = "Virtual gamepad";
  device_ = SDL_JoystickAttachVirtualEx(&description);
  joystick_ = device_ < 0 ? nullptr : SDL_JoystickOpen(device_);
  if (joystick_ == nullptr) throw std::runtime_error(std::string("no virtual gamepad: ") + SDL_GetError());
  for (const auto trigger : {SDL_CONTROLLER_AXIS_TRIGGERLEFT, SDL_CONTROLLER_AXIS_TRIGGERRIGHT}) {
    SDL_JoystickSetVirtualAxis(static_cast<SDL_Joystick*>(joystick_), trigger, -32768);
  }
  SDL_GameControllerUpdate();
}

VirtualPad::~VirtualPad() {
  SDL_JoystickClose(static_cast<SDL_Joystick*>(joystick_));
  SDL_JoystickDetachVirtual(device_);
}

void VirtualPad::press(PadButton button, bool down) {
  auto* const joystick = static_cast<SDL_Joystick*>(joystick_);
  if (const auto axis = axis_of(button)) {
    const bool is_trigger = axis->axis >= SDL_CONTROLLER_AXIS_TRIGGERLEFT;
    const Sint16 rest = is_trigger ? Sint16{-32768} : Sint16{0};
    SDL_JoystickSetVirtualAxis(joystick, axis->axis, down ? axis->pressed : rest);
  } else {
    SDL_JoystickSetVirtualButton(joystick, pad_code_of(button), down ? 1 : 0);
  }
  SDL_GameControllerUpdate();
}

}  // namespace test_support
