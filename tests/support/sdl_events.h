#pragma once

#include "engine/window/window_input.h"

/// Events of keyboard, mouse and gamepad in SDL's queue.
namespace test_support {

void push_key(engine::Key key, bool down);
void push_button(engine::MouseButton button, bool down, ribbon::Vec2 at);
void push_mouse(ribbon::Vec2 at);
void push_wheel(int notches);
void push_text(const char* utf8);
void push_quit();
void push_focus_lost();

/// A gamepad that is plugged in until the end of its scope.
class VirtualPad {
 public:
  /// SDL's video must be open. Throws std::runtime_error if SDL cannot create one.
  VirtualPad();
  VirtualPad(const VirtualPad&) = delete;
  VirtualPad& operator=(const VirtualPad&) = delete;
  ~VirtualPad();

  /// Moves a trigger or a stick's direction fully, or to rest.
  void press(engine::PadButton button, bool down);

 private:
  int device_;
  void* joystick_;
};

}  // namespace test_support
